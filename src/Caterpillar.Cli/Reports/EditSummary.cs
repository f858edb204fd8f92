namespace Caterpillar.Cli;

/// <summary>Summary of edits.</summary>
internal static class EditSummary
{
    public static IEnumerable<string> Of(Toolpath before, Toolpath after)
    {
        if (ReferenceEquals(before, after)) return [];
        var events = after.Events.Count - before.Events.Count;
        var commands = events == 0 ? "" : Figures.Count(Math.Abs(events), "command") + (events > 0 ? " inserted" : " removed");
        return [.. Of(ToolpathDifference.Of(before, after)), commands];
    }

    public static IEnumerable<string> Of(ToolpathDifference changed)
    {
        string Part(string of, int count) => count > 0 ? of + " of " + Figures.Count(count, "move") + " changed" : "";
        return changed.Before != changed.After ? [$"{NumberFormatter.Format(changed.After)} instead of {Figures.Count(changed.Before, "move")}"]
            : [Part("position", changed.Shifted), Part("speed", changed.Speeds), Part("flow", changed.Amounts)];
    }
}
