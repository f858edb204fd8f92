using System.Collections.Generic;
using System.Linq;

namespace Caterpillar.Machines;

/// <summary>
/// JSON schemas of the profiles (draft 2020-12), made from the table of keys; they are in <c>printers/schema/</c> and let editors complete and check.
/// </summary>
public static class ProfileSchema
{
    /// <summary>JSON Schema of printers.</summary>
    public static string Printer => Of(ProfileKinds.Printer.Noun, ProfileKeys.Printer);

    /// <summary>JSON Schema of materials.</summary>
    public static string Material => Of(ProfileKinds.Material.Noun, ProfileKeys.Material);

    /// <summary>JSON Schema of print settings.</summary>
    public static string Settings => Of(ProfileKinds.Settings.Noun, ProfileKeys.Settings);

    private static string Of(string noun, IEnumerable<ProfileKey> keys)
    {
        var properties = new List<KeyValuePair<string, object>>
        {
            Entry("$schema", Text("The schema, for editors.")),
            Entry("inherits", Text("Profile to start from; the profile's own name means the one that comes with Caterpillar.")),
        };
        foreach (var key in keys) properties.Add(Entry(key.Name, key.Format.Schema.Concat([Entry("description", key.Summary)]).ToArray()));
        return JsonText.Object(
        [
            Entry("$schema", "https://json-schema.org/draft/2020-12/schema"),
            Entry("title", $"Caterpillar {noun}"),
            Entry("type", "object"),
            Entry("properties", properties),
            Entry("additionalProperties", false),
        ]);
    }

    private static KeyValuePair<string, object> Entry(string key, object value) => new(key, value);

    private static KeyValuePair<string, object>[] Text(string description) => [Entry("type", "string"), Entry("description", description)];
}
