using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Net;
using System.Text.RegularExpressions;
using Caterpillar.Machines;

namespace Caterpillar.Manual;

/// <summary>Documentation of a setting in the source: its summary, and its value, which begins with the unit.</summary>
internal sealed record SettingDoc(string Sentence, string Value);

/// <summary>Reads the summaries of all settings from the source: the properties of printers, materials and print settings.</summary>
internal sealed class SettingDocs
{
    private static readonly Regex Properties = new(@"((?:^ *///[^\n]*\n)+) *public [^\n(]+ (\w+) \{ get(?: => [^\n;]+)?; init", RegexOptions.Multiline);
    private static readonly Regex Record = new(@"public sealed (?:partial )?record (\w+)");

    private readonly Dictionary<ProfileKey, SettingDoc> _docs = [];

    /// <param name="repository">Folder of the repository.</param>
    public SettingDocs(string repository)
    {
        var written = new Dictionary<(string Record, string Property), SettingDoc>();
        foreach (var file in Directory.GetFiles(Path.Combine(repository, "src", "Caterpillar.Core", "Machines", "Settings"), "*.cs"))
        {
            var text = File.ReadAllText(file);
            var record = Record.Match(text).Groups[1].Value;
            foreach (Match property in Properties.Matches(text)) written[(record, property.Groups[2].Value)] = Doc(property.Groups[1].Value);
        }
        foreach (var (record, property, key) in Keys()) _docs.Add(key, written[(record, property)]);
    }

    public SettingDoc this[ProfileKey key] => _docs[key];

    private static IEnumerable<(string Record, string Property, ProfileKey Key)> Keys()
        => Of(ProfileKinds.Printer).Concat(Of(ProfileKinds.Material)).Concat(Of(ProfileKinds.Settings));

    private static IEnumerable<(string Record, string Property, ProfileKey Key)> Of<T>(ProfileKind<T> kind)
        where T : class
        => kind.Keys.Select(k => (typeof(T).Name, k.Property, (ProfileKey)k));

    private static SettingDoc Doc(string lines)
    {
        var text = string.Join(" ", lines.Split('\n').Select(l => l.Trim().TrimStart('/').Trim()));
        return new SettingDoc(Tag("summary"), Tag("value"));

        string Tag(string name) => WebUtility.HtmlDecode(Regex.Match(text, $"<{name}>(.*)</{name}>").Groups[1].Value.Trim());
    }
}
