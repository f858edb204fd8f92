using System;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Tests.Machines;

public class ExtrusionLawTests
{
    private static readonly ExtrusionModel Filament = new(ExtrusionUnit.Mm, 1.75);

    [Test]
    public void The_papers_third_line_has_a_extrusion_of_a_third_of_a_square_millimeter()
    {
        // Caterpillar 2019: 0.1353 mm of filament per mm of path; π/4 · 1.75² · 0.1353 = 0.3254 mm².
        Assert.That(Filament.AreaOfFactor(0.1353), Is.EqualTo(0.3254).Within(5e-5));
        Assert.That(Filament.E(10, 0.3254), Is.EqualTo(1.353).Within(1e-3));
    }

    [Test]
    public void Extruder_turtles_standard_is_the_formula_of_caterpillar()
    {
        // H 0.2, W 0.4, D 1.75, M 1 give 0.0333; the paper calls 0.03 standard.
        Assert.That(Filament.FactorOfArea(0.4 * 0.2), Is.EqualTo(0.03326).Within(1e-5));
        Assert.That(Filament.E(1, 0.4 * 0.2), Is.EqualTo(0.03326).Within(1e-5));
    }

    [Test]
    public void Kanadas_area_is_a_extrusion_of_half_a_millimeter()
    {
        Assert.That(ExtrusionModel.FilamentAreaOf(0.5), Is.EqualTo(0.196).Within(5e-4));
        Assert.That(Filament.E(100, 0.196), Is.EqualTo(100 * 0.196 / (Math.PI * 0.875 * 0.875)).Within(1e-12));
    }

    [TestCase(ExtrusionUnit.Mm, 1.75, 1)]
    [TestCase(ExtrusionUnit.Mm, 2.85, 0.95)]
    [TestCase(ExtrusionUnit.Mm, 60, 1.1)]
    [TestCase(ExtrusionUnit.Mm3, 1.75, 1.2)]
    public void Area_and_e_are_inverse(ExtrusionUnit unit, double diameter, double multiplier)
    {
        var law = new ExtrusionModel(unit, diameter, multiplier);
        Assert.That(law.E(7, 0.31) * law.VolumePerE!.Value / 7, Is.EqualTo(0.31).Within(1e-12));
        Assert.That(law.AreaOfFactor(law.FactorOfArea(0.31)), Is.EqualTo(0.31).Within(1e-12));
    }

    [Test]
    public void The_multiplier_scales_e()
        => Assert.That(new ExtrusionModel(ExtrusionUnit.Mm, 1.75, 1.1).E(5, 0.1), Is.EqualTo(1.1 * Filament.E(5, 0.1)).Within(1e-12));

    [Test]
    public void The_multiplier_scales_e_of_extrusions_given_by_a_factor()
    {
        var model = new ExtrusionModel(ExtrusionUnit.Mm, 1.75, 1.1);
        Assert.That(model.E(10, model.AreaOfFactor(0.05)), Is.EqualTo(0.55).Within(1e-12));
        Assert.That(model.FactorOfArea(model.AreaOfFactor(0.05)), Is.EqualTo(0.05).Within(1e-15));
    }

    [Test]
    public void Volumetric_e_counts_cubic_millimeters()
    {
        var law = new ExtrusionModel(ExtrusionUnit.Mm3, 1.75);
        Assert.That(law.E(10, 0.08), Is.EqualTo(0.8).Within(1e-12));
        Assert.That(law.EOfFilament(2), Is.EqualTo(2 * Math.PI / 4 * 1.75 * 1.75).Within(1e-12));
        Assert.That(law.FilamentPerE * law.EOfFilament(2), Is.EqualTo(2).Within(1e-12));
    }

    [Test]
    public void A_plunger_is_a_thick_filament()
    {
        // 1 mm of a plunger of 60 mm holds 2827.4 mm³: a bead of 3.4 × 2.2 mm over 378 mm.
        var law = new ExtrusionModel(ExtrusionUnit.Mm, 60);
        Assert.That(law.E(378, 3.4 * 2.2), Is.EqualTo(1).Within(1e-3));
    }

    [Test]
    public void A_pen_has_no_e()
    {
        var law = new ExtrusionModel(ExtrusionUnit.None, 1.75);
        Assert.That(law.VolumePerE, Is.Null);
        Assert.That(law.E(10, 0.4), Is.Zero);
        Assert.That(law.EOfFilament(3), Is.Zero);
    }

    [Test]
    public void Backward_moves_extrude_too() => Assert.That(Filament.E(-3, 0.1), Is.EqualTo(Filament.E(3, 0.1)));

    [TestCase(0)]
    [TestCase(-1)]
    [TestCase(double.NaN)]
    [TestCase(double.PositiveInfinity)]
    public void Invalid_diameters_are_rejected(double diameter)
        => Assert.That(() => new ExtrusionModel(ExtrusionUnit.Mm, diameter), Throws.InstanceOf<ArgumentOutOfRangeException>());
}
