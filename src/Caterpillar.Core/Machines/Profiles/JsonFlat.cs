namespace Caterpillar.Machines;

/// <summary>A key of a JSON object with its value and its position.</summary>
internal sealed record JsonEntry(string Key, object? Value, int Line, int Column);

/// <summary>Reads a JSON object with scalars and lists. <see cref="NumberReader"/> reads the numbers, so that they are the same everywhere.</summary>
internal static class JsonFlat
{
    /// <summary>The keys in their order, or null and an error.</summary>
    public static List<JsonEntry>? Read(string text, string file, List<Diagnostic> diagnostics)
    {
        using var reader = new JsonTextReader(new StringReader(text)) { FloatParseHandling = FloatParseHandling.Decimal,
            DateParseHandling = DateParseHandling.None, MaxDepth = 16 };
        try
        {
            if (!Next(reader) || reader.TokenType != JsonToken.StartObject)
            {
                diagnostics.Add(new Diagnostic(Severity.Error, "profile.not_an_object", "A profile must be a JSON object: { \"key\": value, … }.",
                    new SourceLocation(file, Math.Max(reader.LineNumber, 1), reader.LinePosition)));
                return null;
            }
            var entries = new List<JsonEntry>();
            while (Next(reader) && reader.TokenType == JsonToken.PropertyName)
            {
                var key = (string)reader.Value!;
                var line = reader.LineNumber;
                var column = ColumnOf(text, line, key, reader.LinePosition);
                Next(reader);
                entries.Add(new JsonEntry(key, Value(reader), line, column));
            }
            if (reader.TokenType != JsonToken.EndObject)
                throw new JsonReaderException("The object is not closed.", reader.Path, reader.LineNumber, reader.LinePosition, null);
            if (Next(reader)) throw new JsonReaderException("Text after the object.", reader.Path, reader.LineNumber, reader.LinePosition, null);
            return entries;
        }
        catch (JsonReaderException bad)
        {
            diagnostics.Add(new Diagnostic(Severity.Error, "profile.bad_json", Sentence(bad.Message),
                new SourceLocation(file, Math.Max(bad.LineNumber, 1), bad.LinePosition)));
            return null;
        }
    }

    private static bool Next(JsonTextReader reader)
    {
        do
        {
            if (!reader.Read()) return false;
        }
        while (reader.TokenType == JsonToken.Comment);
        return true;
    }

    // text, double, bool, a list of these, or null for anything else
    private static object? Value(JsonTextReader reader)
    {
        switch (reader.TokenType)
        {
            case JsonToken.String or JsonToken.Boolean: return reader.Value;
            case JsonToken.Integer or JsonToken.Float:
                return NumberReader.TryParse(Convert.ToString(reader.Value, System.Globalization.CultureInfo.InvariantCulture), out var number) ? number : null;
            case JsonToken.StartArray:
                var items = new List<object>();
                var whole = true;
                while (Next(reader) && reader.TokenType != JsonToken.EndArray)
                {
                    var item = Value(reader);
                    if (item is null) whole = false;
                    else items.Add(item);
                }
                return whole ? items.ToArray() : null;
            case JsonToken.StartObject:
                reader.Skip();
                return null;
            default: return null;
        }
    }

    private static int ColumnOf(string text, int line, string key, int position)
    {
        var start = 0;
        for (var i = 1; i < line && start >= 0; i++) start = text.IndexOf('\n', start) + 1;
        var end = Math.Min(start + position, text.Length);
        var at = end > start ? text.LastIndexOf(key, end - 1, end - start, StringComparison.Ordinal) : -1;
        return at > start ? at - start : position;
    }

    // Newtonsoft appends the path and the position, which the source of the diagnostic already has.
    private static string Sentence(string message)
    {
        var at = message.IndexOf(" Path '", StringComparison.Ordinal);
        return "Invalid JSON: " + (at > 0 ? message.Substring(0, at) : message);
    }
}
