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
    {
        json.WriteStartArray();
        foreach (var finding in findings)
        {
            json.WriteStartObject();
            Text(json, "severity", finding.Severity.ToString().ToLowerInvariant());
            Text(json, "code", finding.Code);
            Number(json, "count", finding.Count);
            if (finding.Share > 0)
            {
                json.WritePropertyName("share");
                json.WriteValue(Math.Round(finding.Share, 4));
            }
            Finding(json, finding);
            if (finding.Worst is { } worst)
            {
                json.WritePropertyName("worst");
                json.WriteStartObject();
                Finding(json, worst);
                json.WriteEndObject();
            }
            json.WriteEndObject();
        }
        json.WriteEndArray();
    }

    private static void Finding(JsonTextWriter json, Diagnostic finding)
    {
        Text(json, "message", finding.Message);
        if (finding.Source is { } place) Place(json, place);
    }

    private static void Place(JsonTextWriter json, SourceLocation place)
    {
        Text(json, "file", place.File);
        Text(json, "key", place.Key);
        Number(json, "line", place.Line);
        Number(json, "column", place.Column);
        Number(json, "layer", place.Layer);
        Number(json, "step", place.Step);
        Number(json, "move", place.Move);
        if (place.Origin is not { } origin) return;
        json.WritePropertyName("origin");
        json.WriteStartObject();
        Place(json, origin);
        json.WriteEndObject();
    }

    private static void Text(JsonTextWriter json, string key, string? value)
    {
        if (value is null) return;
        json.WritePropertyName(key);
        json.WriteValue(value);
    }

    private static void Number(JsonTextWriter json, string key, int? value)
    {
        if (value is not { } number) return;
        json.WritePropertyName(key);
        json.WriteValue(number);
    }
}
