namespace Caterpillar.Turtles;

/// <summary>The turtle commands of the letters of an L-system. Immutable.</summary>
public sealed class LSystemInterpretation
{
    private readonly Dictionary<char, TurtleCommand[]> _table;

    /// <summary>A custom table. Letters that are not in it do nothing.</summary>
    public LSystemInterpretation(IEnumerable<KeyValuePair<char, IReadOnlyList<TurtleCommand>>> table)
    {
        _table = [];
        foreach (var entry in table ?? throw new ArgumentNullException(nameof(table))) _table[entry.Key] = entry.Value.ToArray();
    }

    /// <summary>
    /// The usual letters: F and G draw a step, f and g move a step without drawing, + and - turn left and right. ^ and &amp; pitch up and down, \ and / roll
    /// left and right. | turns around, [ pushes and ] pops. Values of a letter replace the step or angle.
    /// </summary>
    /// <param name="step">Length of a step, mm.</param>
    /// <param name="angle">Angle of a turn, in the unit of the turtle.</param>
    public static LSystemInterpretation Standard(double step, double angle)
    {
        var draw = TurtleCommand.Of(TurtleAction.Forward, step);
        var move = TurtleCommand.Of(TurtleAction.Move, step);
        var table = new Dictionary<char, IReadOnlyList<TurtleCommand>>
        {
            ['F'] = [draw],
            ['G'] = [draw],
            ['f'] = [move],
            ['g'] = [move],
            ['+'] = [TurtleCommand.Of(TurtleAction.Yaw, angle)],
            ['-'] = [TurtleCommand.Of(TurtleAction.Right, angle)],
            ['^'] = [TurtleCommand.Of(TurtleAction.Pitch, angle)],
            ['&'] = [TurtleCommand.Of(TurtleAction.PitchDown, angle)],
            ['\\'] = [TurtleCommand.Of(TurtleAction.RollLeft, angle)],
            ['/'] = [TurtleCommand.Of(TurtleAction.Roll, angle)],
            ['|'] = [TurtleCommand.Of(TurtleAction.TurnAround)],
            ['['] = [TurtleCommand.Of(TurtleAction.Push)],
            [']'] = [TurtleCommand.Of(TurtleAction.Pop)],
        };
        return new LSystemInterpretation(table);
    }

    internal void Apply(Turtle turtle, LSystemWord word, int index)
    {
        var letter = word[index];
        if (!_table.TryGetValue(letter, out var commands)) return;
        for (var i = 0; i < commands.Length; i++)
        {
            var count = i == 0 ? word.ValueCount(index) : 0;
            if (count == 0)
            {
                commands[i].Apply(turtle);
                continue;
            }
            var values = new double[Math.Min(Math.Max(count, commands[i].Values.Count), 4)];
            for (var v = 0; v < values.Length; v++) values[v] = v < count ? word.Value(index, v) : commands[i].Values[v];
            TurtleCommand.Of(commands[i].Action, commands[i].Text, values.Take(TurtleCommands.Of(commands[i].Action).Values.Count).ToArray()).Apply(turtle);
        }
    }
}
