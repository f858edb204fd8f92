using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using System.Text;
using Caterpillar.Machines;
using Caterpillar.Manual;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Caterpillar.Tests.Machines;

public class ProfileSchemaTests
{
    private static readonly SettingDocs Docs = new(TestData.Repository);

    private static string Folder => Path.Combine(TestData.Repository, "printers");

    public static IEnumerable<string> ProfileFiles()
        => Directory.GetFiles(Folder, "*.json", SearchOption.AllDirectories).Select(f => f.Substring(Folder.Length + 1).Replace('\\', '/'))
            .Where(f => !f.StartsWith("schema/", StringComparison.Ordinal)).OrderBy(f => f, StringComparer.Ordinal);

    [TestCase("printer")]
    [TestCase("material")]
    [TestCase("settings")]
    public void The_schema_is_current(string kind) => Current(Path.Combine(Folder, "schema", kind + ".schema.json"), Schema(kind));

    [Test]
    public void The_manual_is_current() => Current(Path.Combine(TestData.Repository, "docs", "profiles.md"), ProfileManual.Write(new ProfileLibrary(), Docs));

    [TestCaseSource(nameof(ProfileFiles))]
    public void Every_profile_obeys_the_schema_that_it_names(string file)
    {
        var profile = JObject.Parse(File.ReadAllText(Path.Combine(Folder, file)));
        var named = Path.GetFullPath(Path.Combine(Folder, Path.GetDirectoryName(file)!, (string)profile["$schema"]!));
        var kind = file.StartsWith("materials/", StringComparison.Ordinal) ? "material" : file.StartsWith("settings/", StringComparison.Ordinal) ? "settings"
            : "printer";
        Assert.That(Path.GetFileName(named), Is.EqualTo(kind + ".schema.json"));
        Assert.That(Problems(profile, JObject.Parse(Schema(kind)), file), Is.Empty);
    }

    [TestCase("""{ "nozle": 1 }""")]
    [TestCase("""{ "nozzle_diameter_mm": "0.4" }""")]
    [TestCase("""{ "nozzle_diameter_mm": 0 }""")]
    [TestCase("""{ "decimals_e": 2.5 }""")]
    [TestCase("""{ "origin": "middle" }""")]
    [TestCase("""{ "build_volume_mm": [1, 2] }""")]
    [TestCase("""{ "tool_offsets_mm": [[0, 0, "x"]] }""")]
    [TestCase("""{ "start_gcode": [3] }""")]
    public void The_schema_refuses_what_the_reader_refuses(string json)
    {
        Assert.That(Problems(JObject.Parse(json), JObject.Parse(Schema("printer")), ""), Is.Not.Empty);
        Assert.That(ProfileReader.Read<Printer>(json, "f", "n").Value, Is.Null);
    }

    [Test]
    public void Each_property_of_a_profile_but_its_name_has_one_key()
    {
        Assert.That(ProfileKinds.Printer.Keys.Select(k => k.Property), Is.EquivalentTo(Properties<Printer>()));
        Assert.That(ProfileKinds.Material.Keys.Select(k => k.Property), Is.EquivalentTo(Properties<Material>()));
        Assert.That(ProfileKinds.Settings.Keys.Select(k => k.Property), Is.EquivalentTo(Properties<PrintSettings>()));

        static IEnumerable<string> Properties<T>()
            => typeof(T).GetProperties().Where(p => p.SetMethod is { IsPublic: true }).Select(p => p.Name).Where(name => name != "Name");
    }

    [Test]
    public void Keys_are_snake_case_and_unique_over_the_three_kinds()
    {
        var keys = ProfileKeys.All.Select(k => k.Name).ToArray();
        Assert.That(keys, Is.All.Match("^[a-z][a-z0-9]*(_[a-z0-9]+)*$"));
        Assert.That(keys.Where(k => k != "title"), Is.Unique);
        Assert.That(keys.Count(k => k == "title"), Is.EqualTo(3));
    }

    [Test]
    public void What_a_key_means_stands_at_its_property_with_the_unit()
    {
        var units = new Dictionary<string, string>
        {
            ["mm3_s"] = "mm³/s", ["mm_s2"] = "mm/s²", ["mm_s"] = "mm/s", ["mm2"] = "mm²", ["mm3"] = "mm³", ["mm"] = "mm", ["g_cm3"] = "g/cm³",
            ["deg"] = "Degrees", ["percent"] = "%", ["c"] = "°C", ["s"] = "s",
        };
        foreach (var key in ProfileKeys.All)
        {
            Assert.That(key.Summary, Is.EqualTo(Docs[key].Sentence).And.EndsWith("."), key.Name);
            if (key.Name.EndsWith("_c_s", StringComparison.Ordinal)) Assert.That(Docs[key].Value, Is.EqualTo("°C/s."));
            else if (units.TryGetValue(KeyAdvice.UnitOf(key.Name), out var unit)) Assert.That(Docs[key].Value, Does.StartWith(unit), key.Name);
        }
    }

    [Test]
    public void Every_property_of_the_records_has_its_key()
    {
        Assert.That(Properties(typeof(Printer)), Is.EqualTo(ProfileKeys.Of<Printer>().Count));
        Assert.That(Properties(typeof(Material)), Is.EqualTo(ProfileKeys.Of<Material>().Count));
        Assert.That(Properties(typeof(PrintSettings)), Is.EqualTo(ProfileKeys.Of<PrintSettings>().Count));

        // All but the name, which is that of the file.
        static int Properties(Type type) => type.GetProperties().Count(p => p.CanWrite && p.Name != "Name");
    }

    private static string Schema(string kind)
    {
        var schema = new ProfileSchema(Docs);
        return kind switch { "printer" => schema.Printer, "material" => schema.Material, _ => schema.Settings };
    }

    internal static void Current(string file, string expected)
    {
        if (Environment.GetEnvironmentVariable("CATERPILLAR_RENEW") == "1")
        {
            Directory.CreateDirectory(Path.GetDirectoryName(file)!);
            File.WriteAllText(file, expected, new UTF8Encoding(false));
        }
        Assert.That(File.Exists(file) ? File.ReadAllText(file) : "", Is.EqualTo(expected), "CATERPILLAR_RENEW=1 rewrites the file.");
    }

    // The part of JSON schema that the schemas use.
    private static IEnumerable<string> Problems(JToken value, JObject schema, string path)
    {
        if (schema["enum"] is JArray words)
        {
            if (!words.Any(w => JToken.DeepEquals(w, value))) yield return path + ": not one of the words";
            yield break;
        }
        var kinds = schema["type"] is JArray several ? several.Select(k => (string?)k).ToArray() : [(string?)schema["type"]];
        var fits = kinds.Any(kind => kind switch
        {
            "object" => value.Type == JTokenType.Object,
            "array" => value.Type == JTokenType.Array,
            "string" => value.Type == JTokenType.String,
            "boolean" => value.Type == JTokenType.Boolean,
            "integer" => value.Type == JTokenType.Integer,
            _ => value.Type is JTokenType.Integer or JTokenType.Float,
        });
        if (!fits)
        {
            yield return path + ": no " + string.Join(", ", kinds);
            yield break;
        }
        if (kinds.Length > 1 && value.Type == JTokenType.String)
        {
            if (schema["pattern"] is { } pattern && !Regex.IsMatch((string)value!, (string)pattern!)) yield return path + ": not like " + pattern;
            if (schema["maxLength"] is { } longest && ((string)value!).Length > (int)longest) yield return path + ": too long";
            yield break;
        }
        if (schema["minimum"] is { } min && (double)value < (double)min) yield return path + ": too small";
        if (schema["maximum"] is { } max && (double)value > (double)max) yield return path + ": too large";
        if (schema["minLength"] is { } length && ((string)value!).Length < (int)length) yield return path + ": too short";
        if (schema["minItems"] is { } few && ((JArray)value).Count < (int)few) yield return path + ": too few";
        if (schema["maxItems"] is { } many && ((JArray)value).Count > (int)many) yield return path + ": too many";
        if (value is JArray list && schema["items"] is JObject item)
        {
            foreach (var problem in list.SelectMany((v, i) => Problems(v, item, path + "[" + i + "]"))) yield return problem;
        }
        if (value is not JObject entries) yield break;
        foreach (var entry in entries.Properties())
        {
            if (schema["properties"]![entry.Name] is not JObject known) yield return path + ": unknown key " + entry.Name;
            else foreach (var problem in Problems(entry.Value, known, path + "." + entry.Name)) yield return problem;
        }
    }
}
