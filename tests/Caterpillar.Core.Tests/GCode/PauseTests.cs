using System.Linq;
using System.Text;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>A pause retracts, lifts, parks and waits, and then goes on where it was.</summary>
public class PauseTests
{
    private const string Print = "G90\nM83\n;LAYER:0\nG0 X10 Y20 Z0.2 F6000\nG1 X30 E1 F1200\n;LAYER:1\nM106 S255\nG0 Z0.4 F600\nG1 X10 E1 F1200\n";
    private static readonly Printer Machine = new() { PauseLift = 5, PauseRetraction = 2, PausePrime = 0.1, ZHopSpeed = 10, RetractionSpeed = 30 };
    private static readonly PrintSetup Lifted = new(Machine, new Material(), new PrintSettings { TravelSpeed = 100 });
    private static readonly PrintSetup Unprimed = Lifted with { Printer = Machine with { PausePrime = 0 } };

    [Test]
    public void The_head_leaves_the_part_and_comes_back()
        => Assert.That(Written(Print, 1, Lifted), Is.EqualTo("G90\nM83\n;LAYER:0\nG0 X10 Y20 Z0.2 F6000\nG1 X30 E1 F1200\n;LAYER:1\nM106 S255\n"
            + "G1 E-2 F1800\nG0 Z5.2 F600\nG0 X10 F6000\nM0\nG0 X30\nG0 Z0.2 F600\nG1 E2.1 F1800\nG0 Z0.4 F600\nG1 X10 E1 F1200\n"));

    [Test]
    public void What_is_primed_after_a_pause_is_deposited_and_the_rest_restored()
    {
        var moves = Decode(Print).PauseAtLayer(1, Lifted).Value!.Moves().Where(m => m.Source < 0).ToArray();
        Assert.That(moves.Select(m => (m.Kind, m.E, m.Deposited)), Is.EqualTo(new[]
        {
            (MoveKind.Retract, -2.0, 0.0), (MoveKind.Travel, 0, 0), (MoveKind.Travel, 0, 0), (MoveKind.Travel, 0, 0), (MoveKind.Travel, 0, 0),
            (MoveKind.Deretract, 2.1, 0.1),
        }));
        var pen = Decode("G90\n;LAYER:0\nG0 X1 Z1 F6000\nG1 X9\n;LAYER:1\nG1 X1 Z2\n").PauseAtLayer(1, Lifted).Value!;
        Assert.That(pen.Moves().Select(m => m.E), Is.All.Zero, "without E nothing is retracted");
    }

    [Test]
    public void Where_E_is_a_volume_so_is_what_is_retracted_and_primed()
    {
        var area = ExtrusionModel.FilamentAreaOf(1.75);
        Assert.That(Decode("M200 D1.75\n" + Print).PauseAtLayer(1, Lifted).Value!.Moves().Where(m => m.Source < 0 && m.E != 0).Select(m => m.E),
            Is.EqualTo(new[] { -2 * area, 2.1 * area }).Within(1e-9));
    }

    [Test]
    public void A_dwell_at_the_beginning_of_the_layer_stays_with_its_move()
    {
        var paused = Decode("G90\nM83\n;LAYER:0\nG0 X1 Z1 F6000\nG1 X9 E1\n;LAYER:1\nG4 P500\nG1 X1 E1\n").PauseAtLayer(1, Lifted).Value!;
        var dwell = paused.Events.Single(e => e.Event is DwellEvent).Move;
        Assert.That(paused[dwell].Kind, Is.EqualTo(MoveKind.Dwell));
    }

    [Test]
    public void A_plain_pause_is_the_command_alone()
        => Assert.That(Written(Print, 1, null), Is.EqualTo(Print.Replace("G0 Z0.4", "M0\nG0 Z0.4")));

    [Test]
    public void Place_height_and_command_can_be_chosen()
    {
        var chosen = Machine with { PausePark = new(new Vec3(-7, 99, 0)), BuildVolume = new Vec3(200, 200, 3), PauseGCode = new("M25") };
        var text = Written(Print, 1, Lifted with { Printer = chosen });
        Assert.That(text, Does.Contain("G0 Z3 F600\nG0 X-7 Y99 F6000\nM25\nG0 X30 Y20\nG0 Z0.2"));
    }

    [Test]
    public void Absolute_E_goes_on_as_it_was()
    {
        var text = "M82\n;LAYER:0\nG0 X10 Y20 Z0.2 F6000\nG1 X30 E1 F1200\n;LAYER:1\nG0 Z0.4 F600\nG1 X10 E2 F1200\n";
        var toolpath = Decode(Written(text, 1, Unprimed));
        Assert.That(toolpath.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => m.E), Is.EqualTo(new[] { 1.0, 1.0 }).Within(1e-9));
        Assert.That(toolpath.Events.Count(e => e.Event is PauseEvent), Is.EqualTo(1));
        var pause = toolpath.Events.Single(e => e.Event is PauseEvent).Move;
        Assert.That(toolpath[pause].Start, Is.EqualTo(new Vec3(10, 20, 5.2)));
    }

    [Test]
    public void Files_of_slicers_print_the_same_around_it([Values("cu_plate_marlin_absE.gcode", "ps_plate_smoothie_volE_fwr.gcode")] string file)
    {
        var decoded = GCodeDecoder.Decode(GCodeFiles.Document(file)).Value!;
        var edited = decoded.Toolpath.PauseAtLayer(3, Unprimed).Value!;
        var back = GCodeDecoder.Decode(GCodeEditor.ToDocument(decoded, edited).Value!, new DecodeOptions { Flavor = decoded.Flavor }).Value!.Toolpath;
        (Vec3, Vec3)[] Extrusions(Toolpath t) => t.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => (m.Start, m.End)).ToArray();
        Assert.That(Extrusions(back), Is.EqualTo(Extrusions(decoded.Toolpath)));
        Assert.That(back.Moves().Sum(m => m.Deposited), Is.EqualTo(decoded.Toolpath.Moves().Sum(m => m.Deposited)).Within(1e-3));
    }

    [Test]
    public void A_layer_that_is_not_there_is_an_error()
        => Assert.That(Decode(Print).PauseAtLayer(9, Lifted).Diagnostics.Single().Code, Is.EqualTo("toolpath.no_layer"));

    [TestCase("G90\nG0 X10 Y10 Z0.2\nG1 X30\n")]
    [TestCase("")]
    public void Without_layers_there_is_none_to_pause_at(string text)
    {
        foreach (var layer in new[] { 0, 1 })
        {
            Assert.That(Decode(text).PauseAtLayer(layer, Lifted).Diagnostics.Single().Code, Is.EqualTo("toolpath.no_layer"));
            Assert.That(Decode(text).PauseAtLayer(layer, null).Diagnostics.Single().Code, Is.EqualTo("toolpath.no_layer"));
        }
    }

    // A cutter: nothing in the file extrudes.
    [TestCase(0, "G0 X10 Y20 Z0.2 F6000\n")]
    [TestCase(1, "G0 Z0.4 F600\n")]
    [TestCase(2, "G0 Z0.6\n")]
    public void A_file_without_E_pauses_where_the_layer_begins(int layer, string first)
    {
        const string Cut = "G90\n;LAYER:0\nG0 X10 Y20 Z0.2 F6000\nG1 X30 F1200\n;LAYER:1\nG0 Z0.4 F600\nG1 X10 F1200\n;LAYER:2\nG0 Z0.6\nG1 X30\n";
        Assert.That(Written(Cut, layer, null), Is.EqualTo(Cut.Replace(first, "M0\n" + first)));
        var lines = Written(Cut, layer, Lifted).Split('\n');
        Assert.That(System.Array.IndexOf(lines, "M0"), Is.InRange(System.Array.IndexOf(lines, $";LAYER:{layer}"),
            layer < 2 ? System.Array.IndexOf(lines, $";LAYER:{layer + 1}") : lines.Length));
    }

    private static Toolpath Decode(string text)
        => GCodeDecoder.Decode(Encoding.ASCII.GetBytes(text), new DecodeOptions { Flavor = FlavorTable.Marlin2 }).Value!.Toolpath;

    [Test]
    public void The_lift_counts_from_the_highest_place_of_a_extrusion_that_falls()
    {
        var text = Written("G90\nM83\n;LAYER:0\nG0 X10 Y20 Z3 F6000\nG1 X30 Z1 E1 F1200\n;LAYER:1\nG0 Z3.5 F600\nG1 X10 E1 F1200\n", 1, Lifted);
        Assert.That(text, Does.Contain("G0 Z8 F600\n"), "5 mm above Z 3");
    }

    private static string Written(string text, int layer, PrintSetup? setup)
    {
        var decoded = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(text), new DecodeOptions { Flavor = FlavorTable.Marlin2 }).Value!;
        return Encoding.ASCII.GetString(GCodeEditor.ToDocument(decoded, decoded.Toolpath.PauseAtLayer(layer, setup).Value!).Value!.ToBytes());
    }
}
