namespace Caterpillar.Cli;

/// <summary>Findings of the checks: in one line, and as JSON.</summary>
internal static class FindingSummary
{
    // Number of kinds that are named. The others are counted.
    private const int Named = 6;

    /// <summary>The kinds of errors and warnings with their counts; null for a single kind, which has its own message.</summary>
    public static string? Of(IEnumerable<Diagnostic> diagnostics)
    {
        var kinds = diagnostics.Where(d => d.Severity != Severity.Note && CheckCodes.Find(d.Code) is not null)
            .OrderByDescending(d => d.Severity).ThenByDescending(d => d.Count).ToArray();
        if (kinds.Length < 2) return null;
        var names = string.Join(", ", kinds.Take(Named).Select(d => $"{d.Code} {NumberFormatter.Format(d.Count)}"));
        var more = kinds.Length > Named ? $" and {NumberFormatter.Format(kinds.Length - Named)} more kinds" : "";
        return $"{NumberFormatter.Format(kinds.Sum(d => d.Count))} findings of {NumberFormatter.Format(kinds.Length)} kinds: {names}{more}.";
    }

    /// <summary>An array with an object for each kind of finding.</summary>
    public static JArray ToJson(IEnumerable<Diagnostic> findings) => new(findings.Select(finding => Json.Object(
        [
            ("severity", finding.Severity.ToString().ToLowerInvariant()), ("code", finding.Code), ("count", finding.Count),
            ("share", finding.Share > 0 ? Math.Round(finding.Share, 4) : null),
            .. Entries(finding), ("worst", finding.Worst is { } worst ? Json.Object([.. Entries(worst)]) : null),
        ])));

    private static IEnumerable<(string Name, JToken? Value)> Entries(Diagnostic finding)
        => [("message", finding.Message), .. finding.Source is { } place ? Entries(place) : []];

    private static IEnumerable<(string Name, JToken? Value)> Entries(SourceLocation place)
        =>
        [
            ("file", place.File), ("key", place.Key), ("line", place.Line), ("column", place.Column), ("layer", place.Layer), ("step", place.Step),
            ("move", place.Move), ("origin", place.Origin is { } origin ? Json.Object([.. Entries(origin)]) : null),
        ];
}
