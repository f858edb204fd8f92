using Caterpillar.Flavors;
using NUnit.Framework;

namespace Caterpillar.Tests.Flavors;

/// <summary>Rules that compute something, and what a firmware has that says nothing else.</summary>
public class FlavorRuleTests
{
    [Test]
    public void A_firmware_that_states_nothing_has_arcs_inches_and_firmware_retraction()
    {
        var rules = new FlavorRules();
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
        => Assert.That(new FlavorRules { DwellP = 0.001, DwellS = 2, DwellSums = sums }.DwellSeconds(p, s), Is.EqualTo(seconds).Within(1e-12));

    [Test]
    public void S_of_a_dwell_is_nothing_where_the_firmware_does_not_know_it()
        => Assert.That(new FlavorRules { DwellP = 0.001, DwellS = 0 }.DwellSeconds(250, 3), Is.EqualTo(0.25).Within(1e-12));

    // 0.05 mm are always right, 0.5 mm never; between them 1 % of the larger radius: 0.2 mm of 20 mm.
    [TestCase(20, 20.04, false)]
    [TestCase(20, 20.15, false)]
    [TestCase(20.15, 20, false)]
    [TestCase(20, 20.3, true)]
    [TestCase(5, 5.1, true)]
    [TestCase(100, 100.6, true)]
    public void An_arc_is_refused_where_its_radii_differ_too_much(double start, double end, bool refused)
        => Assert.That(new ArcTolerance(0.05, 0.5, 0.01).Refuses(start, end), Is.EqualTo(refused));
}
