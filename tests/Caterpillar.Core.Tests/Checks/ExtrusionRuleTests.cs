using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>What carries an extrusion, what fits into its gap, and how it is judged in a layer.</summary>
public class ExtrusionRuleTests
{
    private static readonly PrintSetup Setup = SmallPrint.Setup();

    // A quarter circle of 20 mm: each chord of it counts, the first and the last too.
    [Test]
    public void An_arc_in_the_air_is_as_long_as_it_is()
    {
        var arc = new SmallPrint(50, 50, 30).Arc(70, 70, 30, new Vec3(50, 70, 30), 90, SmallPrint.Area).Build();
        Assert.That(SmallPrint.Find(arc, SmallPrint.Setup(), CheckCodes.Unsupported).Single().Message,
            Does.StartWith("An extrusion is in the air for 31.4 mm"));
    }

    // An extrusion in the air and one along it a little higher: what is nearer than half a height lies beside it, and carries nothing.
    [TestCase(0.09, 2)]
    [TestCase(0.11, 1)]
    public void An_extrusion_is_carried_by_what_is_half_its_height_below(double above, int hanging)
    {
        var print = new SmallPrint(50, 50, 4).Print(70, 50, 4).Go(70, 50, 20).Go(50, 50, 20).Go(50, 50, 4 + above).Print(70, 50, 4 + above).Go(80, 80, 20);
        Assert.That(Count(print, CheckCodes.Unsupported), Is.EqualTo(hanging));
    }

    // Printed 0.08 mm deep into what crosses it, the nozzle may rise from there, but not travel there.
    [Test]
    public void Where_an_extrusion_may_end_the_nozzle_may_rise()
    {
        SmallPrint Crossed() => new SmallPrint(50, 50, 4).Print(70, 50, 4).Go(70, 50, 20).Go(60, 40, 20).Go(60, 40, 3.92).Print(60, 50, 3.92);
        Assert.That(Count(Crossed().Go(60, 50, 20), CheckCodes.TravelHits), Is.Zero);
        Assert.That(Count(Crossed().Go(61, 50, 20), CheckCodes.TravelHits), Is.EqualTo(1));
        Assert.That(Count(Crossed().Go(60, 40, 3.92).Go(60, 50, 3.92).Go(60, 50, 20), CheckCodes.TravelHits), Is.GreaterThan(1));
    }

    // 0.02 mm² by a nozzle of 0.4 mm are 0.05 mm high, whatever the layer: half of that decides.
    [TestCase(0.02, 2)]
    [TestCase(0.03, 1)]
    public void A_thin_extrusion_is_carried_by_what_is_half_its_own_height_below(double above, int hanging)
    {
        var print = new SmallPrint(50, 50, 4).Print(70, 50, 4).Go(70, 50, 20).Go(50, 50, 20).Go(50, 50, 4 + above).Print(70, 50, 4 + above, 0.02)
            .Go(80, 80, 20);
        Assert.That(Count(print, CheckCodes.Unsupported), Is.EqualTo(hanging));
    }

    // Two extrusions higher up over the same line; the bed is 1.4 mm below.
    [Test]
    public void What_is_above_a_extrusion_does_not_carry_it()
    {
        var print = new SmallPrint(50, 50, 4).Print(70, 50, 4).Go(70, 50, 4.4).Print(50, 50, 4.4).Go(40, 50, 20).Go(40, 50, 1.4).Go(50, 50, 1.4)
            .Print(70, 50, 1.4).Go(80, 50, 1.4);
        Assert.That(Count(print, CheckCodes.Unsupported), Is.EqualTo(2), "the lower one of those above, and the one below them");
    }

    // Extrusions without a layer: twice the thicker of the layers or half a nozzle, and a tenth.
    [TestCase(0.1, 0.3, 0.69, 0)]
    [TestCase(0.1, 0.3, 0.71, 1)]
    [TestCase(0.3, 0.1, 0.69, 0)]
    [TestCase(0.3, 0.1, 0.71, 1)]
    [TestCase(0.1, 0.1, 0.49, 0)]
    [TestCase(0.1, 0.1, 0.51, 1)]
    public void Without_layers_the_thicker_of_the_settings_counts(double layer, double first, double z, int hanging)
    {
        var setup = Setup with { Settings = new PrintSettings { LayerHeight = layer, FirstLayerHeight = first } };
        var print = new SmallPrint(50, 50, z).Print(70, 50, z).Go(80, 80, z);
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.Unsupported).Sum(d => d.Count), Is.EqualTo(hanging));
    }

    // Of 0.5 mm: an extrusion has half the square of its layer at least, and is three nozzles wide at most; else its layer says nothing about it.
    [TestCase(0.124, 0)]
    [TestCase(0.126, 1)]
    [TestCase(0.599, 1)]
    [TestCase(0.601, 0)]
    public void A_layer_that_does_not_fit_its_extrusions_is_not_believed(double area, int found)
    {
        var print = new SmallPrint(50, 50, 0.5).InLayer(new Layer(0, 0.5, 0.5)).Print(70, 50, 0.5, area);
        Assert.That(Count(print, CheckCodes.Height), Is.EqualTo(found));
    }

    // Purging lands an extrusion: before it 5 mm may hang.
    [TestCase(55, 0)]
    [TestCase(55.5, 1)]
    public void An_extrusion_that_begins_in_the_air_may_hang_for_5_mm_before_it_lands(double x, int found)
    {
        var print = new SmallPrint(50, 50, 4).Print(x, 50, 4).Print(60, 50, 4, role: Role.Purge);
        Assert.That(Count(print, CheckCodes.Unsupported), Is.EqualTo(found));
    }

    // What has landed before a travel does not hold the extrusion after it.
    [TestCase(55, 0)]
    [TestCase(55.5, 1)]
    public void An_extrusion_after_a_travel_has_a_free_end(double x, int found)
    {
        var print = new SmallPrint(20, 20, 0.2).Print(30, 20, 0.2).Go(50, 50, 4).Print(x, 50, 4).Print(60, 50, 4, role: Role.Purge);
        Assert.That(Count(print, CheckCodes.Unsupported), Is.EqualTo(found));
    }

    // A loop of 10 by 20 mm whose last side of 10 mm is 4 mm up and joins its start, which lies on a wall.
    [TestCase(0, 0, 0)]
    [TestCase(0, 0.35, 0)]
    [TestCase(0, 0.5, 1)]
    [TestCase(6, 0, 1)]
    public void A_loop_is_held_by_a_start_that_has_something_below_it(double aside, double open, int found)
    {
        var print = new SmallPrint().Wall(40, 60, 50, 4).Wall(40, 60, 60, 4).Go(50, 50 + aside, 200).Go(50, 50 + aside, 4.2);
        print.Print(55, 50 + aside, 4.2).Print(55, 60, 4.2).Print(50, 60, 4.2).Print(50, 50 + aside + open, 4.2);
        Assert.That(Count(print.Go(80, 80, 4.2), CheckCodes.Unsupported), Is.EqualTo(found));
    }

    // 5.1 mm³ are 4.03 mm wide in a gap of a nozzle; higher up nothing is squeezed.
    [TestCase(0.4, 1)]
    [TestCase(0.401, 0)]
    [TestCase(0, 0)]
    public void A_blob_is_squeezed_in_a_gap_of_up_to_a_nozzle(double z, int found)
    {
        var print = new SmallPrint(50, 50, 0.2).Print(70, 50, 0.2).Go(100, 100, z).Prime(5.1);
        Assert.That(Count(print, CheckCodes.Squeezed), Is.EqualTo(found));
    }

    // Each half millimeter is looked at in its middle: the wall ends with the cell at 50.25.
    [TestCase(50, 55.4, 0)]
    [TestCase(50.6, 55.6, 0)]
    [TestCase(50.6, 55.8, 1)]
    public void An_extrusion_beside_a_wall_hangs_from_its_start_on(double from, double to, int found)
    {
        var print = new SmallPrint().Wall(40, 50, 50, 4).Go(from, 50, 200).Go(from, 50, 4.2).Print(to, 50, 4.2).Go(80, 80, 4.2);
        Assert.That(Count(print, CheckCodes.Unsupported), Is.EqualTo(found));
    }

    [Test]
    public void The_height_of_a_print_is_that_of_its_highest_extrusion()
    {
        var print = new SmallPrint().Wall(50, 70, 50, 25).Go(50, 50, 200).Go(50, 50, 25.2).Print(70, 50, 27.2);
        Assert.That(SmallPrint.Find(print.Build(), Setup, CheckCodes.FirstLayer).Single().Message, Does.StartWith("The print is 27.2 mm high"));
    }

    [TestCase(0.1, 0.08, true)]
    [TestCase(0.08, 0.1, false)]
    public void Of_squeezed_extrusions_the_lowest_is_the_worst(double first, double second, bool worse)
    {
        var print = new SmallPrint(50, 50, first).Print(70, 50, first).Go(70, 60, 5).Go(70, 60, second).Print(50, 60, second);
        var found = SmallPrint.Find(print.Build(), Setup, CheckCodes.Squeezed).Single();
        Assert.That((found.Count, found.Worst is not null), Is.EqualTo((2, worse)));
        if (worse) Assert.That(found.Worst!.Message, Does.EndWith("Raise the path by 0.12 mm."));
    }

    // A quarter turn of 20 mm in many chords: as thick as a straight extrusion.
    [TestCase(0.08, 0)]
    [TestCase(0.5, 1)]
    [TestCase(0.005, 1)]
    public void The_extrusion_of_an_arc_is_as_thick_as_a_straight_one(double area, int found)
    {
        var arc = new SmallPrint(50, 50, 0.2).Arc(70, 70, 0.2, new Vec3(50, 70, 0.2), 90, area).Build();
        var straight = new SmallPrint(50, 50, 0.2).Print(50 + arc[0].Length, 50, 0.2, area).Build();
        var width = SmallPrint.Find(arc, Setup, CheckCodes.Width).Select(d => d.Message).ToArray();
        Assert.That(width.Length, Is.EqualTo(found));
        Assert.That(width, Is.EqualTo(SmallPrint.Find(straight, Setup, CheckCodes.Width).Select(d => d.Message)));
        Assert.That(SmallPrint.Find(arc, Setup, CheckCodes.Squeezed).Length, Is.EqualTo(SmallPrint.Find(straight, Setup, CheckCodes.Squeezed).Length));
    }

    [Test]
    public void An_extrusion_that_goes_on_after_a_travel_begins_in_the_air_again()
    {
        // 4 mm hang at each side of a travel there and back; 5 mm may.
        var print = new SmallPrint(50, 50, 4).Print(54, 50, 4).Go(60, 60, 4).Go(54, 50, 4).Print(58, 50, 4).Go(80, 80, 4);
        Assert.That(Count(print, CheckCodes.Unsupported), Is.Zero);
    }

    // Exactly half a height above what is below it, in numbers without rounding.
    [TestCase(4.125, 1)]
    [TestCase(4.124, 2)]
    public void An_extrusion_exactly_half_its_height_above_another_lies_on_it(double z, int hanging)
    {
        var setup = Setup with { Settings = new PrintSettings { LayerHeight = 0.25, FirstLayerHeight = 0.25 } };
        var print = new SmallPrint(50, 50, 4).Print(70, 50, 4, 0.1).Go(70, 50, 20).Go(50, 50, 20).Go(50, 50, z).Print(70, 50, z, 0.1).Go(80, 80, 20);
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.Unsupported).Sum(d => d.Count), Is.EqualTo(hanging));
    }

    // 10 mm over another extrusion, a detour, and 30 mm over it again.
    [Test]
    public void Doubled_extrusions_are_named_by_the_first_of_their_run()
    {
        var print = new SmallPrint(50, 50, 0.2).Print(150, 50, 0.2).Go(150, 50, 5).Go(50, 50, 5).Go(50, 50, 0.2).Print(60, 50, 0.2).Print(60, 55, 0.2)
            .Print(70, 55, 0.2).Print(70, 50, 0.2).Print(100, 50, 0.2);
        Assert.That(SmallPrint.Find(print.Build(), Setup, CheckCodes.Duplicate).Single().Source!.Move, Is.EqualTo(8));
        // The same after a travel.
        print.Go(100, 50, 5).Go(120, 50, 5).Go(120, 50, 0.2).Print(145, 50, 0.2);
        Assert.That(SmallPrint.Find(print.Build(), Setup, CheckCodes.Duplicate).Single().Count, Is.EqualTo(2));
    }

    // Where no layers are known, what is at most 0.002 mm lower is of the same height, and only doubled.
    [TestCase(0.001, 0)]
    [TestCase(0.003, 1)]
    public void An_extrusion_is_too_low_above_one_that_is_lower(double above, int found)
    {
        var print = new SmallPrint(50, 50, 0.2).Print(100, 50, 0.2).Go(100, 50, 5).Go(50, 50, 5).Go(50, 50, 0.2 + above).Print(100, 50, 0.2 + above);
        Assert.That(Count(print, CheckCodes.TooLow), Is.EqualTo(found));
    }

    // 0.02 mm² by a nozzle of 0.4 mm are 0.05 mm high: half of that decides.
    [TestCase(0.02, 1)]
    [TestCase(0.03, 0)]
    public void Thin_extrusions_above_each_other_are_not_doubled(double above, int found)
    {
        var print = new SmallPrint(50, 50, 0.2).Print(100, 50, 0.2, 0.02).Go(100, 50, 5).Go(50, 50, 5).Go(50, 50, 0.2 + above)
            .Print(100, 50, 0.2 + above, 0.02);
        Assert.That(Count(print, CheckCodes.Duplicate), Is.EqualTo(found));
    }

    [TestCase(2e6, 20)]
    [TestCase(20, 2e6)]
    public void What_is_a_kilometer_away_is_not_looked_at(double from, double to)
    {
        var print = new SmallPrint(from, 10, 4).Print(to, 10, 4).Go(30, 30, 4);
        Assert.That(SmallPrint.Find(print.Build(), Setup, "extrusion."), Is.Empty);
    }

    [Test]
    public void Extrusions_in_the_air_are_named_by_the_first_of_them()
    {
        var print = new SmallPrint(40, 50, 4).Go(50, 50, 4).Print(53, 50, 4).Print(56, 50, 4).Print(59, 50, 4).Go(80, 80, 4);
        var found = SmallPrint.Find(print.Build(), Setup, CheckCodes.Unsupported).Single();
        Assert.That((found.Source!.Move, found.Message), Is.EqualTo(((int?)1, "An extrusion is in the air for 9 mm, with a free end. Add supports below it.")));
    }

    [TestCase(Role.Support)]
    [TestCase(Role.SupportInterface)]
    public void Supports_in_the_air_are_not_told_to_be_supported(Role role)
    {
        var print = new SmallPrint(40, 50, 4).Go(50, 50, 4).Print(59, 50, 4, role: role).Go(80, 80, 4);
        Assert.That(SmallPrint.Find(print.Build(), Setup, CheckCodes.Unsupported).Single().Message,
            Is.EqualTo("A support is in the air for 9 mm, with a free end. Use denser supports, or a grid instead of trees."));
    }

    [Test]
    public void Odd_widths_are_named_by_the_first_extrusion_of_5_mm_and_then_by_each()
    {
        // Rectangles of 0.2 mm: 2 mm wide.
        var setup = new PrintSetup(SmallPrint.Generic, new Material(), new PrintSettings { BeadShape = BeadShape.Rectangle });
        var print = new SmallPrint(40, 50, 0.2).Go(50, 50, 0.2).Print(55, 50, 0.2, 0.4);
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.Width), Is.Empty);
        var found = SmallPrint.Find(print.Print(56, 50, 0.2, 0.4).Print(57, 50, 0.2, 0.6).Build(), setup, CheckCodes.Width).Single();
        Assert.That((found.Source!.Move, found.Count, found.Worst!.Source!.Move), Is.EqualTo(((int?)1, 2, (int?)3)));
    }

    // 2 mm are 1.67 times the widest, 0.05 mm 1.6 times and 0.04 twice below the thinnest.
    [TestCase(0.05, false)]
    [TestCase(0.04, true)]
    public void Of_odd_widths_the_one_farthest_from_the_nozzle_is_the_worst(double thin, bool worse)
    {
        var setup = new PrintSetup(SmallPrint.Generic, new Material(), new PrintSettings { BeadShape = BeadShape.Rectangle });
        var print = new SmallPrint(50, 50, 0.2).Print(60, 50, 0.2, 0.4).Go(60, 80, 5).Go(60, 80, 0.2).Print(70, 80, 0.2, 0.2 * thin);
        var found = SmallPrint.Find(print.Build(), setup, CheckCodes.Width).Single();
        Assert.That((found.Count, found.Worst is not null), Is.EqualTo((2, worse)));
        Assert.That(found.Message, Does.StartWith("Extrusions are 2 mm wide, too wide for a nozzle of"));
    }

    private static int Count(SmallPrint print, string code) => SmallPrint.Find(print.Build(), Setup, code).Sum(d => d.Count);
}
