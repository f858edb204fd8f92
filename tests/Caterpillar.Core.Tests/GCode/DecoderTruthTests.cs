using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Machines;
using NUnit.Framework;
using Newtonsoft.Json.Linq;

namespace Caterpillar.Tests.GCode;

/// <summary>The decoder against the results of an independent one, for every file of the shared data.</summary>
public class DecoderTruthTests
{
    [TestCaseSource(typeof(GCodeFiles), nameof(GCodeFiles.All))]
    public void The_report_equals_the_truth(string file)
    {
        var truth = Truth(file);
        var document = GCodeFiles.Document(file);
        foreach (var threads in new[] { 1, 3 })
        {
            var decoding = GCodeDecoder.Decode(document, new DecodeOptions { Flavor = FlavorTable.Slicer, Rule = ExtrusionRule.Rising, Threads = threads })
                .Value!;
            var differences = Differences(truth, JObject.Parse(decoding.Report.ToJson()));
            Assert.That(differences, Is.Empty, string.Join("\n", differences));
        }
    }

    [TestCaseSource(typeof(GCodeFiles), nameof(GCodeFiles.Chosen))]
    public void With_the_balance_the_filament_used_equals_the_truth(string file)
    {
        var truth = Truth(file);
        var decoding = GCodeDecoder.Decode(
            GCodeFiles.Document(file), new DecodeOptions { Flavor = FlavorTable.Slicer, Rule = ExtrusionRule.Balance }).Value!;
        if (truth["e_used"]!.Type == JTokenType.Null) return;
        var used = (double)truth["e_used"]!;
        Assert.That(decoding.Report.EUsed, Is.EqualTo(used).Within(1e-5 + 1e-9 * used));
        var deposited = decoding.Toolpath.Moves().Sum(m => m.Deposited);
        Assert.That(deposited, Is.EqualTo(used).Within(1e-5 + 1e-9 * used), "the balance deposits exactly what is used");
    }

    private static JObject Truth(string file)
    {
        var all = JObject.Parse(TestData.GCodeTruth());
        return (JObject)all[file]!;
    }

    private static List<string> Differences(JObject truth, JObject report)
    {
        var differences = new List<string>();
        foreach (var entry in truth)
        {
            if (entry.Key is "sha256_unpacked") continue;
            Compare(entry.Key, entry.Value!, report[entry.Key], differences);
        }
        foreach (var entry in report)
        {
            if (truth[entry.Key] is null) differences.Add($"{entry.Key}: not in the truth, is {entry.Value}");
        }
        return differences;
    }

    private static void Compare(string key, JToken expected, JToken? actual, List<string> differences)
    {
        switch (expected)
        {
            case JObject members when actual is JObject others:
                foreach (var entry in members) Compare(key + "." + entry.Key, entry.Value!, others[entry.Key], differences);
                foreach (var entry in others)
                {
                    if (members[entry.Key] is null) differences.Add($"{key}.{entry.Key}: not in the truth, is {entry.Value}");
                }
                return;
            case JArray items when actual is JArray others && items.Count == others.Count:
                for (var i = 0; i < items.Count; i++) Compare(key + "[" + i + "]", items[i], others[i], differences);
                return;
            case JValue { Type: JTokenType.Float or JTokenType.Integer } when actual is JValue { Type: JTokenType.Float or JTokenType.Integer }:
                var a = (double)expected;
                var b = (double)actual!;
                var tolerance = expected.Type == JTokenType.Integer && actual.Type == JTokenType.Integer ? 0 : 1e-5 + 1e-9 * Math.Abs(a);
                if (Math.Abs(a - b) > tolerance) differences.Add($"{key}: {expected} expected, is {actual}");
                return;
            default:
                if (!JToken.DeepEquals(expected, actual)) differences.Add($"{key}: {expected} expected, is {actual}");
                return;
        }
    }
}
