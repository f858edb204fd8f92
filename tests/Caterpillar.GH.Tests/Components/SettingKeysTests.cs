using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Tests;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Components;

/// <summary>Every setting of the manual can be set on the canvas, as in the terminal.</summary>
public sealed class SettingKeysTests
{
    [Test]
    public void Each_key_of_the_manual_is_a_port_with_the_value_of_the_terminal()
    {
        var setup = new PrintSetup { Settings = new Canvas<PrintSettingsComponent>().Solve().One<PrintSettings>("Settings") };
        var keys = Keys().ToArray();
        Assert.That(keys, Has.Length.GreaterThan(120));
        // Each profile has a title.
        foreach (var (key, range) in keys.Where(k => k.Key != "title"))
        {
            // Of the values in the range one that is not that of the profile.
            var wanted = Candidates(range).Select(value => (Text: $"{key}={value}", Settings: setup.With([$"{key}={value}"]).Value?.Settings))
                .FirstOrDefault(w => w.Settings is not null && w.Settings != setup.Settings);
            Assert.That(wanted.Settings, Is.Not.Null, $"{key} ({range}) takes none of {string.Join(" ", Candidates(range))}");
            var canvas = new Canvas<PrintSettingsComponent>().Key(key, wanted.Text!.Substring(key.Length + 1)).Solve();
            Assert.That(canvas.Errors.Concat(canvas.Warnings), Is.Empty, wanted.Text);
            Assert.That(canvas.One<PrintSettings>("Settings"), Is.EqualTo(wanted.Settings), wanted.Text);
            var bad = new Canvas<PrintSettingsComponent>().Key(key, "@@").Solve();
            Assert.That(bad.Errors, Is.Not.Empty, "a wrong value");
        }
    }

    private static IEnumerable<(string Key, string Range)> Keys()
        => File.ReadLines(Path.Combine(TestData.Repository, "docs", "profiles.md")).SkipWhile(l => l != "## Settings").TakeWhile(l => l != "## Templates")
            .Where(l => l.StartsWith("| `", StringComparison.Ordinal)).Select(l => l.Split('|')).Select(c => (c[1].Trim(' ', '`'), c[c.Length - 2].Trim()));

    private static string[] Candidates(string range)
    {
        if (range.StartsWith("a formula in z", StringComparison.Ordinal)) return ["0.2 + z / 1000"];
        if (range.StartsWith("a formula", StringComparison.Ordinal)) return ["sin(x) + y * z"];
        if (range.StartsWith("[x, y]", StringComparison.Ordinal)) return ["[3, 4]"];
        if (range.Contains(" lists ")) return ["[[1, 2, 0.1]]", "[[0, 1, 2], [0, 3, 4]]", "[[50, 20, 100, 1]]", "[[5, 1]]"];
        var ends = range.Split([" to "], StringSplitOptions.None);
        if (ends.Length < 2) return range.Split([", ", " or "], StringSplitOptions.None);
        var (low, high) = (Number(ends[0]), Number(ends[1]));
        return new[] { low, low + 1, high, (low + high) / 2 }.Select(n => n.ToString(CultureInfo.InvariantCulture)).ToArray();
    }

    private static double Number(string text) => double.Parse(text.Split(' ')[0], CultureInfo.InvariantCulture);
}
