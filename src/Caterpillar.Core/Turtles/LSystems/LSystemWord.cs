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

    /// <summary>Draws the word with a turtle. Letters without commands are skipped. The values of a letter replace the numbers of its first command.</summary>
    /// <returns>The problems, with the number of the letter as column. Empty = no problems.</returns>
    public IReadOnlyList<Diagnostic> Draw(Turtle turtle, LSystemInterpretation interpretation, System.Threading.CancellationToken cancel = default)
    {
        if (turtle is null) throw new ArgumentNullException(nameof(turtle));
        if (interpretation is null) throw new ArgumentNullException(nameof(interpretation));
        var depth = turtle.StackDepth;
        for (var i = 0; i < _symbols.Length; i++)
        {
            if ((i & 0xFFFF) == 0) cancel.ThrowIfCancellationRequested();
            try
            {
                interpretation.Apply(turtle, this, i);
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
