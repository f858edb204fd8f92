namespace Caterpillar.Cli;

/// <summary>Summary of edits.</summary>
internal static class EditSummary
{
    public static string Of(Toolpath before, Toolpath after)
    {
        if (ReferenceEquals(before, after)) return "";
        var parts = new List<string>();
        if (before.Count == after.Count) Compare(before, after, parts);
        else parts.Add($"{NumberFormatter.Format(after.Count)} instead of {Words.Count(before.Count, "move")}");
        var events = after.Events.Count - before.Events.Count;
        if (events > 0) parts.Add(Words.Count(events, "command") + " inserted");
        if (events < 0) parts.Add(Words.Count(-events, "command") + " removed");
        return string.Join(", ", parts);
    }

    private static void Compare(Toolpath before, Toolpath after, List<string> parts)
    {
        var changed = ToolpathDifference.Of(before, after);
        if (changed.Shifted > 0) parts.Add("position of " + Words.Count(changed.Shifted, "move") + " changed");
        if (changed.Speeds > 0) parts.Add("speed of " + Words.Count(changed.Speeds, "move") + " changed");
        if (changed.Amounts > 0) parts.Add("flow of " + Words.Count(changed.Amounts, "move") + " changed");
    }
}
