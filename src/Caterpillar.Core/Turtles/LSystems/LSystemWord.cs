namespace Caterpillar.Turtles;

/// <summary>A grown word of an L-system: letters, some with values.</summary>
public sealed class LSystemWord
{
    private readonly char[] _symbols;

    // Values of letter i are _values[_first[i]] up to _values[_first[i + 1]]; null if no letter has any.
    private readonly int[]? _first;
    private readonly double[] _values;

    internal LSystemWord(char[] symbols, int[]? first, double[] values) => (_symbols, _first, _values) = (symbols, first, values);

    /// <summary>Number of letters.</summary>
    public int Count => _symbols.Length;

    /// <summary>A letter.</summary>
    public char this[int index] => _symbols[index];

    /// <summary>Number of values of a letter.</summary>
    public int ValueCount(int index) => _first is null ? 0 : _first[index + 1] - _first[index];

    /// <summary>A value of a letter.</summary>
    public double Value(int index, int which)
        => which >= 0 && which < ValueCount(index) ? _values[_first![index] + which] : throw new ArgumentOutOfRangeException(nameof(which));

    /// <summary>
    /// Draws the word with a turtle. F and G draw a step, f and g move a step without drawing, + and - turn left and right. ^ and &amp; pitch up and down, \
    /// and / roll left and right. | turns around, [ pushes and ] pops. Values of a letter replace the step or angle. Other letters do nothing.
    /// </summary>
    /// <param name="turtle">The turtle.</param>
    /// <param name="step">Length of a step, mm.</param>
    /// <param name="angle">Angle of a turn, in the unit of the turtle.</param>
    /// <param name="cancel">Cancels the work.</param>
    /// <returns>The problems, with the number of the letter as column. Empty = no problems.</returns>
    public IReadOnlyList<Diagnostic> Draw(Turtle turtle, double step, double angle, CancellationToken cancel = default)
    {
        if (turtle is null) throw new ArgumentNullException(nameof(turtle));
        var depth = turtle.StackDepth;
        for (var i = 0; i < _symbols.Length; i++)
        {
            if ((i & 0xFFFF) == 0) cancel.ThrowIfCancellationRequested();
            try
            {
                Apply(turtle, i, step, angle);
            }
            catch (Exception e) when (e is ArgumentException or InvalidOperationException)
            {
                var code = e is InvalidOperationException ? "lsystem.bracket" : "lsystem.value";
                return [new Diagnostic(Severity.Error, code, $"Letter {NumberFormatter.Format(i + 1)} ('{_symbols[i]}') of the word: {Messages.Clean(e)}",
                    new SourceLocation(Line: 1, Column: i + 1))];
            }
        }
        return turtle.StackDepth == depth
            ? []
            : [new Diagnostic(Severity.Warning, "lsystem.bracket",
                $"The word has {NumberFormatter.Format(turtle.StackDepth - depth)} '[' without a closing ']'.")];
    }

    /// <summary>Lets a turtle do what a letter means.</summary>
    /// <exception cref="ArgumentException">A value is invalid for the turtle.</exception>
    /// <exception cref="InvalidOperationException">A pop without a push.</exception>
    internal void Apply(Turtle turtle, int index, double step, double angle)
    {
        TurtleAction? action = _symbols[index] switch
        {
            'F' or 'G' => TurtleAction.Forward,
            'f' or 'g' => TurtleAction.Move,
            '+' => TurtleAction.Yaw,
            '-' => TurtleAction.Right,
            '^' => TurtleAction.Pitch,
            '&' => TurtleAction.PitchDown,
            '\\' => TurtleAction.RollLeft,
            '/' => TurtleAction.Roll,
            '|' => TurtleAction.TurnAround,
            '[' => TurtleAction.Push,
            ']' => TurtleAction.Pop,
            _ => null,
        };
        if (action is not { } known) return;
        var moves = known is TurtleAction.Forward or TurtleAction.Move;
        var count = ValueCount(index);
        double[] values = count == 0 ? [moves ? step : angle]
            : count > 1 && known == TurtleAction.Forward ? [Value(index, 0), Value(index, 1)] : [Value(index, 0)];
        TurtleCommand.Apply(turtle, known, values.Length, values, "");
    }

    /// <summary>The word as text. Values have up to 6 decimals.</summary>
    public override string ToString()
    {
        if (_first is null) return new string(_symbols);
        var text = new StringBuilder();
        for (var i = 0; i < _symbols.Length; i++)
        {
            text.Append(_symbols[i]);
            for (var v = _first[i]; v < _first[i + 1]; v++)
            {
                text.Append(v == _first[i] ? '(' : ',').Append(NumberFormatter.Format(_values[v], 6));
                if (v == _first[i + 1] - 1) text.Append(')');
            }
        }
        return text.ToString();
    }
}
