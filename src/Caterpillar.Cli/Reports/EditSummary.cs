namespace Caterpillar.Cli;

/// <summary>Summary of edits.</summary>
internal static class EditSummary
{
    public static string Of(Toolpath before, Toolpath after)
    {
        if (ReferenceEquals(before, after)) return "";
        var parts = new List<string>();
        if (before.Count == after.Count)
        {
            var changed = ToolpathDifference.Of(before, after);
            if (changed.Shifted > 0) parts.Add("position of " + Figures.Count(changed.Shifted, "move") + " changed");
            if (changed.Speeds > 0) parts.Add("speed of " + Figures.Count(changed.Speeds, "move") + " changed");
            if (changed.Amounts > 0) parts.Add("flow of " + Figures.Count(changed.Amounts, "move") + " changed");
        }
        else
        {
            parts.Add($"{NumberFormatter.Format(after.Count)} instead of {Figures.Count(before.Count, "move")}");
        }
        var events = after.Events.Count - before.Events.Count;
        if (events > 0) parts.Add(Figures.Count(events, "command") + " inserted");
        if (events < 0) parts.Add(Figures.Count(-events, "command") + " removed");
        return string.Join(", ", parts);
    }
}
