using System.Linq;
using System.Reflection;
using Caterpillar.Basics;
using Caterpillar.Flavors;
using NUnit.Framework;

namespace Caterpillar.Tests.Flavors;

/// <summary>Rules that compute something, and what a firmware has that says nothing else.</summary>
public class FlavorRuleTests
{
    [Test]
    public void A_firmware_that_states_nothing_has_arcs_inches_and_firmware_retraction()
    {
        var rules = Rules();
        Assert.That((rules.Arcs, rules.RadiusArcs, rules.ArcsInRelativeMode, rules.Planes), Is.EqualTo((true, true, true, true)));
        Assert.That((rules.Inches, rules.FirmwareRetraction, rules.ToolLimit), Is.EqualTo((true, true, 1000)));
        Assert.That((rules.Dwells[0], rules.DwellP, rules.DwellS), Is.EqualTo(("G4", 0.001, 1.0)));
    }

    // Units of 2 s for S: Seconds = 2 · S, and P in milliseconds.
    [TestCase(null, null, false, 0)]
    [TestCase(500.0, null, false, 0.5)]
    [TestCase(null, 3.0, false, 6)]
    [TestCase(500.0, 3.0, false, 6)]
    [TestCase(500.0, 3.0, true, 6.5)]
    public void S_of_a_dwell_counts_instead_of_P_or_adds_to_it(double? p, double? s, bool sums, double seconds)
        => Assert.That(Rules(("DwellS", "2"), ("DwellSums", sums ? "yes" : "no")).DwellSeconds(p, s), Is.EqualTo(seconds).Within(1e-12));

    [Test]
    public void S_of_a_dwell_is_nothing_where_the_firmware_does_not_know_it()
        => Assert.That(Rules(("DwellS", "0")).DwellSeconds(250, 3), Is.EqualTo(0.25).Within(1e-12));

    // 0.05 mm are always right, 0.5 mm never; between them 1 % of the larger radius: 0.2 mm of 20 mm.
    [TestCase(20, 20.04, false)]
    [TestCase(20, 20.15, false)]
    [TestCase(20.15, 20, false)]
    [TestCase(20, 20.3, true)]
    [TestCase(5, 5.1, true)]
    [TestCase(100, 100.6, true)]
    public void An_arc_is_refused_where_its_radii_differ_too_much(double start, double end, bool refused)
        => Assert.That(new ArcTolerance(0.05, 0.5, 0.01).Refuses(start, end), Is.EqualTo(refused));

    [Test]
    public void A_flavor_that_is_like_another_has_its_rules_unless_it_has_its_own()
    {
        Assert.That((FlavorTable.Prusa.HomingSelectsXy, FlavorTable.Marlin1.HomingSelectsXy), Is.EqualTo((false, true)));
        Assert.That((FlavorTable.Prusa.RetractionLifts, FlavorTable.Prusa.Volumetric), Is.EqualTo((true, true)));
        Assert.That(FlavorTable.Marlin2.Notes, Is.EqualTo(FlavorTable.Marlin1.Notes));
        Assert.That((FlavorTable.Prusa.ShiftResets.Count, FlavorTable.Marlin1.ShiftResets.Count), Is.EqualTo((0, 1)));
    }

    // A misspelled rule would have its usual value.
    [Test]
    public void Each_line_of_a_flavor_is_a_rule_with_a_value_of_its_kind()
    {
        foreach (var flavor in FlavorTable.All)
        {
            foreach (var (name, value) in RuleWords.Of(flavor.Name).Select(p => (p.Key, p.Value)).Where(p => p.Key != "Like"))
            {
                var rule = typeof(FlavorRules).GetProperty(name, BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic);
                Assert.That(rule, Is.Not.Null, $"{flavor.Name}: {name}");
                var type = rule!.PropertyType;
                if (type == typeof(bool)) Assert.That(value is "yes" or "no", $"{flavor.Name}: {name}");
                if (type == typeof(double) || type == typeof(int)) Assert.That(NumberReader.TryParse(value, out _), $"{flavor.Name}: {name}");
            }
        }
    }

    private static FlavorRules Rules(params (string Name, string Value)[] words) => new(words.ToDictionary(w => w.Name, w => w.Value));
}
