namespace Caterpillar.Machines;

/// <summary>
/// Descriptions of the keys: the summaries of the properties of printers, materials and settings, as <c>printers/schema</c> contains them (a test compares).
/// </summary>
internal static class KeySentences
{
    private static readonly Lazy<Dictionary<string, string>> All = new(Read);

    public static string Of(string key) => All.Value[key];

    private static Dictionary<string, string> Read()
    {
        var sentences = new Dictionary<string, string>(StringComparer.Ordinal);
        foreach (var kind in new[] { "printer", "material", "settings" })
        {
            using var schema = typeof(KeySentences).Assembly.GetManifestResourceStream("schema/" + kind + ".schema.json")!;
            using var json = new JsonTextReader(new StreamReader(schema));
            var key = "";
            while (json.Read())
            {
                if (json.TokenType != JsonToken.PropertyName) continue;
                if (json.Depth == 2) key = (string)json.Value!;
                else if (json.Depth == 3 && (string)json.Value! == "description") sentences[key] = json.ReadAsString()!;
            }
        }
        return sentences;
    }
}
