using Newtonsoft.Json;

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

    /// <summary>Writes an array with an object for each kind of finding.</summary>
    public static void Write(JsonTextWriter json, IEnumerable<Diagnostic> findings)
        => json.List(findings, finding => json.Object(() =>
        {
            json.Entry("severity", finding.Severity.ToString().ToLowerInvariant());
            json.Entry("code", finding.Code);
            json.Entry("count", finding.Count);
            if (finding.Share > 0) json.Entry("share", Math.Round(finding.Share, 4));
            Finding(json, finding);
            if (finding.Worst is { } worst) json.Entry("worst", () => json.Object(() => Finding(json, worst)));
        }));

    private static void Finding(JsonTextWriter json, Diagnostic finding)
    {
        json.Entry("message", finding.Message);
        if (finding.Source is { } place) Place(json, place);
    }

    private static void Place(JsonTextWriter json, SourceLocation place)
    {
        json.Entry("file", place.File);
        json.Entry("key", place.Key);
        json.Entry("line", place.Line);
        json.Entry("column", place.Column);
        json.Entry("layer", place.Layer);
        json.Entry("step", place.Step);
        json.Entry("move", place.Move);
        if (place.Origin is { } origin) json.Entry("origin", () => json.Object(() => Place(json, origin)));
    }
}
