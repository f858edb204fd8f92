using System.Collections.Generic;
using System.Linq;
using Caterpillar.Machines;

namespace Caterpillar.Manual;

/// <summary>
/// JSON schemas of the profiles (draft 2020-12), made from the table of keys, in <c>printers/schema/</c>. Editors use them for completion and checks.
/// </summary>
internal sealed class ProfileSchema(SettingDocs docs)
{
    /// <summary>JSON Schema of printers.</summary>
    public string Printer => Of(ProfileKinds.Printer.Noun, ProfileKeys.Of<Printer>());

    /// <summary>JSON Schema of materials.</summary>
    public string Material => Of(ProfileKinds.Material.Noun, ProfileKeys.Of<Material>());

    /// <summary>JSON Schema of print settings.</summary>
    public string Settings => Of(ProfileKinds.Settings.Noun, ProfileKeys.Of<PrintSettings>());

    private string Of(string noun, IEnumerable<ProfileKey> keys)
    {
        var properties = new List<KeyValuePair<string, object>>
        {
            Entry("$schema", Text("The schema, for editors.")),
            Entry("inherits", Text("Profile to start from. The profile's own name refers to the built-in profile.")),
        };
        foreach (var key in keys) properties.Add(Entry(key.Name, key.Format.Schema.Concat([Entry("description", docs[key].Sentence)]).ToArray()));
        return ProfileJson.Write(
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
