namespace Caterpillar.GCode;

/// <summary>The lines of a file that an edited toolpath may change, and its new events.</summary>
internal sealed class SplicePlan
{
    // The first and the last of lines that may change.
    private readonly List<(int First, int Last)> _touched = [];

    /// <summary>The events of the edited toolpath. New ones have no line.</summary>
    public IReadOnlyList<MoveEvent> Events { get; private set; } = [];

    /// <summary>True if one of these lines may change.</summary>
    public bool Changes(int firstLine, int lastLine) => _touched.Exists(r => r.First <= lastLine && r.Last >= firstLine);

    /// <summary>These lines may change.</summary>
    public void Touch(int firstLine, int lastLine) => _touched.Add((firstLine, lastLine));

    public static SplicePlan Of(DecodedGCode decoding, Toolpath edited)
    {
        var plan = new SplicePlan { Events = edited.Events };
        foreach (var added in edited.Events.Where(e => e.Source < 0)) plan.TouchMove(edited, added.Move);
        // All lines of the blocks that they do not share.
        var (before, after) = (decoding.Toolpath.Blocks, edited.Blocks);
        foreach (var lines in before.Except(after).Concat(after.Except(before)).Select(b => b.Summary)) plan.Touch(lines.First, lines.Last);
        return plan;
    }

    /// <summary>True if the moves are in the order of their lines.</summary>
    public static bool IsInOrder(Toolpath toolpath)
    {
        var last = int.MinValue;
        foreach (var lines in toolpath.Blocks.Select(b => b.Summary))
        {
            if (!lines.Ascends || lines.First < last) return false;
            last = Math.Max(last, lines.Last);
        }
        return true;
    }

    // The line of the next move that has one, else the end of the file.
    private void TouchMove(Toolpath toolpath, int move)
    {
        for (move = Math.Min(move, toolpath.Count - 1); move >= 0 && move < toolpath.Count && toolpath[move].Source < 0;) move++;
        var line = move >= 0 && move < toolpath.Count ? toolpath[move].Source : int.MaxValue;
        Touch(line, line);
    }
}
