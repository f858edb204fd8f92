using System;
using System.Linq;
using System.Text;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Moves of a file at the limits of numbers, their counts, and arcs that are written.</summary>
public class MoveEdgeTests
{
    [TestCase("G1 X1.5:7", 1.5)]
    [TestCase("G1 X1.5/7", 1.5)]
    [TestCase("G1 X2:8", 2)]
    [TestCase("G1 X2/8", 2)]
    [TestCase("G1 X-0.25", -0.25)]
    [TestCase("G1 X+.25", 0.25)]
    [TestCase("G1 X123456789.125", 123456789.125)]
    [TestCase("G1 X9999999999", 9999999999.0)]
    [TestCase("G1 X10000000000", null)]
    [TestCase("G1 X-10000000000", null)]
    public void Coordinates_end_with_their_digits_and_below_ten_to_the_ten(string line, double? x)
    {
        var toolpath = Decode(line + "\n").Toolpath;
        Assert.That(toolpath.Count == 0 ? null : (double?)toolpath[0].End.X, Is.EqualTo(x));
    }

    // The known travel from the origin to (1, 1, 1), then E alone, with length, backward and without any.
    [Test]
    public void Moves_are_counted_by_what_they_do()
    {
        var report = Decode("M83\nG28\nG0 X1 Y1 Z1 F600\nG1 X4 Y5 E1\nG0 X4 Y10 E1\nG1 X9 E-0.5\nG1 E-1\nG1 E1.5\nG1 E0.25\nG1 X9\nG1 X19\nG0 X9\nG2 X9 Y10 "
            + "I5 E2\n").Report;
        Assert.That((report.PrintSegments, report.TravelSegments, report.Counters.TravelsWithRetraction), Is.EqualTo((3, 4, 1)));
        Assert.That((report.PrintArcs, report.TravelArcs, report.Counters.PrintsG0, report.Counters.TravelsG1), Is.EqualTo((1, 0, 1, 2)));
        var counters = report.Counters;
        Assert.That((counters.Rapids, counters.Feeds, report.Retractions, counters.Deretractions, counters.NoOps), Is.EqualTo((3, 8, 1, 2, 1)));
        Assert.That(report.PrintLength, Is.EqualTo(5 + 5 + 10 * Math.PI).Within(1e-9));
        Assert.That(report.TravelLength, Is.EqualTo(Math.Sqrt(3) + 5 + 10 + 10).Within(1e-9));
        Assert.That((report.Counters.EPositive, report.Counters.ENegative, report.Counters.EPrint, report.ENet), Is.EqualTo((5.75, -1.5, 4.0, 4.25)));
        Assert.That((report.Counters.Heights, report.Counters.FlatHeights, report.Counters.ZChanges), Is.EqualTo((1, 1, 1)));
        Assert.That(report.PrintBounds, Is.EqualTo(new Bounds(new Vec3(1, 1, 1), new Vec3(19, 15, 1))));
    }

    // After a retraction of 1 mm, 1.5 mm: by balance, 0.5 mm of it are printed in place.
    [TestCase(ExtrusionRule.Balance, 0.5)]
    [TestCase(ExtrusionRule.Rising, 0)]
    public void What_a_deretraction_prints_depends_on_the_rule(ExtrusionRule rule, double deposited)
    {
        var text = Encoding.ASCII.GetBytes("M83\nG1 X10 E1 F600\nG1 E-1\nG1 E1.5\nG1 X20 E1\n");
        var toolpath = GCodeDecoder.Decode(text, new DecodeOptions { Flavor = FlavorTable.Marlin2, Rule = rule }).Value!.Toolpath;
        Assert.That(toolpath.Moves().Where(m => m.Kind == MoveKind.Deretract).Select(m => (m.E, m.Deposited)), Is.EqualTo(new[] { (1.5, deposited) }));
    }

    [TestCase(0.2004, 1)]
    [TestCase(0.2006, 2)]
    public void Heights_are_told_apart_by_micrometers(double z, int heights)
    {
        var text = FormattableString.Invariant($"M83\nG1 X1 Z0.2 F600\nG1 X2 E1\nG1 Z{z}\nG1 X3 E1\n");
        Assert.That((Decode(text).Report.Counters.Heights, Decode(text).Report.Counters.FlatHeights), Is.EqualTo((heights, heights)));
    }

    [TestCase("cnc")]
    [TestCase("grbl")]
    public void After_going_to_the_stored_place_the_axes_are_known(string flavor)
    {
        var toolpath = Decode("G28\nG92 X5 Y6 Z7\nG1 X6 Y8 Z10 F600\n", flavor).Toolpath;
        Assert.That(toolpath[toolpath.Count - 1].End, Is.EqualTo(new Vec3(1, 2, 3)), "they stand at 0 and get another name");
    }

    [Test]
    public void E_is_summed_up_for_each_tool_and_the_tools_are_told_in_order()
    {
        var decoding = Decode("M83\nT1\nG1 X1 E2 F600\nT0\nG1 X2 E1\nG1 E-4\nT3\nG1 X3 E5\nT2\nG1 X4\n");
        Assert.That(decoding.Report.EUsedByTool.Select(t => (t.Key, t.Value)), Is.EqualTo(new[] { (0, 1.0), (1, 2.0), (3, 5.0) }));
        Assert.That(decoding.Report.ToJson(), Does.Contain("\"e_used_by_tool\": {\"0\": 1"));
        Assert.That(decoding.Report.Counters.ToolChanges, Is.EqualTo(4));
    }

    [TestCase("G1 E1\nG1 E0.5", "Prime 1, Prime 0.5")]
    [TestCase("G1 E-1\nG1 E0.5\nG1 E0.5\nG1 E0.5", "Retract 0, Deretract 0, Deretract 0, Prime 0.5")]
    [TestCase("G1 E-1\nG1 E1.5", "Retract 0, Deretract 0.5")]
    [TestCase("G1 E-1\nG1 X5 E0.5\nG1 X6 E1", "Retract 0, MovingDeretract 0, Print 0.5")]
    [TestCase("G1 X5 E-1\nG1 X6 E1\nG1 X7 E1", "Wipe 0, MovingDeretract 0, Print 1")]
    [TestCase("G1 E-1\nG1 X5 E1.0000000001\nG1 X6 E1", "Retract 0, MovingDeretract 0, Print 1")]
    public void E_prints_beyond_what_was_pulled_back(string lines, string kinds)
        => Assert.That(string.Join(", ",
            Decode("M83\nG1 F600\n" + lines + "\n").Toolpath.Moves().Select(m => FormattableString.Invariant($"{m.Kind} {m.Deposited}"))),
            Is.EqualTo(kinds));

    // Half a circle from (5, 0) around the origin, counterclockwise.
    [TestCase("marlin2", false, "G3 X-5 I-5 J0 E1 F600")]
    [TestCase("marlin2", true, "G2 X-5 I-5 J0 E1 F600")]
    public void Half_a_circle_is_one_line(string flavor, bool clockwise, string line)
    {
        var written = Written(flavor, new Vec3(-5, 0, 1), new Arc(Vec3.Zero, clockwise ? -180 : 180));
        Assert.That(written.Single(l => l.Contains('I')), Is.EqualTo(line));
    }

    [TestCase(ArcPlane.ZX, "G18", "I-5", "K0")]
    [TestCase(ArcPlane.YZ, "G19", "J0", "K-1")]
    public void Arcs_in_other_planes_name_their_plane(ArcPlane plane, string code, string first, string second)
    {
        // Around the origin, from (5, 0, 1).
        var end = plane == ArcPlane.ZX ? new Vec3(-5, 0, -1) : new Vec3(5, 0, -1);
        var written = Written("marlin2", end, new Arc(Vec3.Zero, 180, plane));
        Assert.That(written, Does.Contain(code));
        Assert.That(written.Last(l => l.StartsWith("G3", StringComparison.Ordinal)).Split(' '),
            Does.Contain(first).And.Contain(second == "K0" ? "K-1" : second));
    }

    // From (5, 0, 1) to (5, 0, -1), so that one of the two coordinates is the same.
    [TestCase(ArcPlane.ZX, 4, 0, 90)]
    [TestCase(ArcPlane.YZ, 5, -1, -90)]
    public void An_arc_that_comes_back_to_one_of_its_coordinates_is_no_circle(ArcPlane plane, double x, double y, double sweep)
    {
        var written = Written("marlin2", new Vec3(5, 0, -1), new Arc(new Vec3(x, y), sweep, plane));
        Assert.That(written.Count(l => l.StartsWith("G2 ", StringComparison.Ordinal) || l.StartsWith("G3 ", StringComparison.Ordinal)), Is.EqualTo(1));
    }

    // A short arc whose ends round to one point, and a full circle that does not close.
    [TestCase(0.0004, 0.005, false)]
    [TestCase(0.0, 360.0, true)]
    [TestCase(0.01, 359.9995, false)]
    [TestCase(0.01, 359.885, true)]
    public void Arcs_that_rounding_would_turn_into_circles_or_into_nothing_become_chords(double beside, double sweep, bool arc)
    {
        var written = Written("marlin2", new Vec3(5, beside == 0 ? 0 : sweep > 180 ? -beside : beside, 1), new Arc(Vec3.Zero, sweep));
        Assert.That(written.Any(l => l.Contains(" I")), Is.EqualTo(arc));
    }

    [TestCase(2.0, 2)]
    [TestCase(2.5, 3)]
    public void Turns_beyond_a_circle_are_circles_and_a_rest(double turns, int lines)
    {
        var end = turns == 2 ? new Vec3(5, 0, 4) : new Vec3(-5, 0, 4);
        var written = Written("smoothie", end, new Arc(Vec3.Zero, 360 * turns)).Where(l => l.Contains(" I")).ToArray();
        Assert.That(written, Has.Length.EqualTo(lines));
        Assert.That(written.Select(l => l.Split(' ').Single(w => w[0] == 'Z')), Is.EqualTo(turns == 2 ? new[] { "Z2.5", "Z4" } : ["Z2.2", "Z3.4", "Z4"]));
        var back = Decode(string.Join("\n", Written("smoothie", end, new Arc(Vec3.Zero, 360 * turns))), "smoothie").Toolpath;
        Assert.That(back.Moves().Sum(m => m.E), Is.EqualTo(1).Within(1e-4));
    }

    [Test]
    public void Chords_share_the_material_of_their_arc()
    {
        var lines = Written("sailfish", new Vec3(-5, 0, 1), new Arc(Vec3.Zero, 180)).Where(l => l.Contains(" E")).ToArray();
        // 24.8 chords of at most 0.01 mm beside the arc.
        Assert.That(lines, Has.Length.EqualTo(25));
        Assert.That(lines.Select(l => l.Split(' ').Single(w => w[0] == 'E')), Is.All.EqualTo("E0.04"));
    }

    // The origin of the system moves: the head is where it was, its name another.
    [TestCase("G10 L2 P1 X1 Y2 Z3")]
    [TestCase("G54;G10 L2 P1 X1 Y2 Z3")]
    [TestCase("G92 X5 Y5 Z5;G10 L2 P1 X1 Y2 Z3")]
    public void The_head_stays_where_an_origin_moves(string program)
    {
        var text = "G1 X10 Y20 Z30 F600\n" + program.Replace(';', '\n') + "\nG91\nG1 X1 Y1 Z1\n";
        var toolpath = Decode(text, "cnc").Toolpath;
        Assert.That(toolpath[toolpath.Count - 1].End, Is.EqualTo(new Vec3(11, 21, 31)));
        var absolute = Decode("G1 X10 Y20 Z30 F600\nG10 L2 P1 X1 Y2 Z3\nG1 X5 Y5 Z5\n", "cnc").Toolpath;
        Assert.That(absolute[absolute.Count - 1].End, Is.EqualTo(new Vec3(6, 7, 8)));
    }

    [Test]
    public void Lines_of_many_words_are_read_whole()
    {
        var words = string.Concat(Enumerable.Range(0, 60).Select(i => " S" + i));
        var decoding = Decode("M118" + words + "\nG1 X5 Y6 F600" + words + " Z7\n");
        Assert.That(decoding.Toolpath[0].End, Is.EqualTo(new Vec3(5, 6, 7)));
    }

    [TestCase("<svg width=\"5\">\n</svg>\n", "a drawing (SVG)")]
    [TestCase("<html>\n", "XML or HTML")]
    [TestCase("solid x\nfacet normal 0 0 1\n", "a mesh (ASCII STL)")]
    [TestCase("ply\nformat ascii 1.0\n", "a mesh (PLY)")]
    public void Other_files_are_recognized(string text, string kind) => Assert.That(Decode(text).NotGCode!.Message, Does.Contain("looks like " + kind));

    [TestCase("solid words without any triangle\n")]
    [TestCase("a mesh with one facet\n")]
    [TestCase("plywood\n")]
    public void Text_is_no_mesh(string text) => Assert.That(Decode(text).NotGCode?.Message, Does.Not.Contain("mesh"));

    [TestCase("M0")]
    [TestCase("M25")]
    [TestCase("M600")]
    public void Pauses_are_events_and_not_ignored(string command)
    {
        var decoding = Decode("G1 X1 F600\n" + command + "\n");
        Assert.That(decoding.Toolpath.Events.Count(e => e.Event is PauseEvent), Is.EqualTo(1));
        Assert.That(decoding.Ignored, Is.Empty);
    }

    [Test]
    public void A_speed_on_a_line_of_its_own_is_no_unknown_command()
    {
        foreach (var flavor in FlavorTable.All)
        {
            var bytes = Encoding.ASCII.GetBytes("G1 X1 F600\nF1200\nG1 X9\n");
            Assert.That(GCodeDecoder.Decode(bytes, new DecodeOptions { Flavor = flavor }).Value!.Used, Is.Empty, flavor.Name);
        }
    }

    [Test]
    public void Events_are_written_as_the_firmware_reads_them()
    {
        string[] Lines(PrinterEvent what, string flavor = "marlin2") => EventText.Lines(what, FlavorTable.Find(flavor)!).ToArray();
        Assert.That(Lines(new AccelerationEvent(1500.4)), Is.EqualTo(new[] { "M204 S1500" }));
        Assert.That(Lines(new NozzleTemperatureEvent(210.26, true, 2)), Is.EqualTo(new[] { "M109 T2 S210.3" }));
        Assert.That(Lines(new NozzleTemperatureEvent(210)), Is.EqualTo(new[] { "M104 S210" }));
        Assert.That(Lines(new BedTemperatureEvent(60.04, true)).Concat(Lines(new BedTemperatureEvent(0))), Is.EqualTo(new[] { "M190 S60", "M140 S0" }));
        Assert.That(new[] { -1, 0, 0.5, 1, 2 }.SelectMany(s => Lines(new FanEvent(s))),
            Is.EqualTo(new[] { "M107", "M107", "M106 S128", "M106 S255", "M106 S255" }));
        Assert.That(Lines(new DwellEvent(0.5004)), Is.EqualTo(new[] { "G4 P500" }));
        Assert.That(Lines(new HomeEvent()).Concat(Lines(new HomeEvent(true, false, true))).Concat(Lines(new HomeEvent(false, true, false))),
            Is.EqualTo(new[] { "G28", "G28 X Z", "G28 Y" }));
        Assert.That(Lines(new PauseEvent("look\nhere")), Is.EqualTo(new[] { "; look here", Lines(new PauseEvent())[0] }));
        Assert.That(Lines(new CommentEvent("a\rb")).Concat(Lines(new CommentEvent(""))), Is.EqualTo(new[] { "; a b", ";" }));
        Assert.That(Lines(new RawEvent("M1\r\nM2")).Concat(Lines(new FinishMovesEvent())), Is.EqualTo(new[] { "M1", "M2", "M400" }));
        Assert.That(Lines(new ToolEvent(1)), Is.EqualTo(new[] { "T1" }));
    }

    [Test]
    public void Circles_of_a_helix_turn_as_the_whole()
    {
        var clockwise = Written("smoothie", new Vec3(-5, 0, 4), new Arc(Vec3.Zero, -900)).Where(l => l.Contains(" I")).ToArray();
        Assert.That(clockwise.Select(l => l.Split(' ')[0]), Is.EqualTo(new[] { "G2", "G2", "G2" }));
        var counter = Written("smoothie", new Vec3(-5, 0, 4), new Arc(Vec3.Zero, 900)).Where(l => l.Contains(" I")).ToArray();
        Assert.That(counter.Select(l => l.Split(' ')[0]), Is.EqualTo(new[] { "G3", "G3", "G3" }));
    }

    [Test]
    public void A_restored_state_has_its_origin_back()
    {
        var toolpath = Decode("G1 X10 Y20 F600\nSAVE_GCODE_STATE NAME=a\nG92 X0 Y0\nG1 X1\nRESTORE_GCODE_STATE NAME=a\nG1 X5 Y6\n", "klipper").Toolpath;
        Assert.That(toolpath.Moves().Select(m => (m.End.X, m.End.Y)), Is.EqualTo(new[] { (10.0, 20.0), (11, 20), (5, 6) }));
    }

    [TestCase(1)]
    [TestCase(2)]
    public void The_box_of_a_file_holds_its_arcs(int radius)
    {
        var report = Decode(FormattableString.Invariant($"M83\nG1 X0 Y0 F600\nG2 X{2 * radius} Y0 I{radius} E1\n")).Report;
        Assert.That(report.PrintBounds.Max, Is.EqualTo(new Vec3(2 * radius, radius)));
    }

    private static string[] Written(string flavor, Vec3 end, Arc arc)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        builder.Add(new Vec3(5, 0, 1), 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.Add(end, 1, 1, 10, MoveKind.Print, Role.Unspecified, -1, 0, 0, arc);
        var text = NewFile.Plain(builder.Build([new ToolpathTool(1)]), new GCodeFormat(NewFile.Machine with { Flavor = FlavorTable.Find(flavor)! }));
        return text.Split(['\n'], StringSplitOptions.RemoveEmptyEntries);
    }

    private static DecodedGCode Decode(string text, string flavor = "marlin2")
        => GCodeDecoder.Decode(Encoding.ASCII.GetBytes(text), new DecodeOptions { Flavor = FlavorTable.Find(flavor)! }).Value!;
}
