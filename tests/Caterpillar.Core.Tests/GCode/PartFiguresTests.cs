using System.Linq;
using Caterpillar.GCode;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Figures of a file of which layers were removed: by hand for four equal layers.</summary>
public class PartFiguresTests
{
    // Each layer takes 0.02 s up and 2 s along 20 mm, and 1 mm of filament.
    private static readonly DecodedGCode File = GCodeDecoder.Decode(GCodeDocument.FromText("G28\nM83\nG1 F600\n" + string.Concat(
        Enumerable.Range(0, 4).Select(i => $";LAYER:{i}\nG1 Z0.{2 * (i + 1)}\nG1 X{(i % 2 == 0 ? 20 : 0)} E1\n")))).Value!;

    // Line 6 is the extrusion of the first layer, line 7 begins the second.
    private const int AfterFirst = 7;

    [TestCase(";TIME:1000", ";TIME:500")]
    [TestCase(";PRINT.TIME:1000", ";PRINT.TIME:500")]
    [TestCase("; estimated printing time (normal mode) = 1h 0m 40s", "; estimated printing time (normal mode) = 30m 20s")]
    [TestCase("; model printing time: 1h 0m 40s; total estimated time: 2d 0h 0m 0s", "; model printing time: 30m 20s; total estimated time: 1d 0h 0m 0s")]
    [TestCase(";Filament used: 4.0m", ";Filament used: 2m")]
    [TestCase("; filament used [mm] = 4.00", "; filament used [mm] = 2")]
    [TestCase(";LAYER_COUNT:4", ";LAYER_COUNT:2")]
    [TestCase("; total layer number: 4", "; total layer number: 2")]
    [TestCase(";MAXZ:0.8", ";MAXZ:0.4")]
    [TestCase("; printed in 1000 s", "; printed in 1000 s")]
    [TestCase(";TIME_ELAPSED:250", ";TIME_ELAPSED:250")]
    [TestCase("M73 P25 R12", "M73 P50 R4")]
    [TestCase("M73 P25", "M73 P50")]
    public void Of_the_lower_half_totals_are_half_and_what_is_left_is_a_third(string line, string expected)
        => Assert.That(Half(0, 1, false).Image(line, AfterFirst), Is.EqualTo(expected));

    [TestCase(";LAYER:2", ";LAYER:0", TestName = "the third layer becomes the first")]
    [TestCase(";LAYER:3", ";LAYER:1", TestName = "and the fourth the second")]
    [TestCase("SET_PRINT_STATS_INFO CURRENT_LAYER=3", "SET_PRINT_STATS_INFO CURRENT_LAYER=1", TestName = "counted from one")]
    [TestCase("; layer num/total_layer_count: 4/4", "; layer num/total_layer_count: 2/2", TestName = "with the count")]
    [TestCase(";MAXZ:0.8", ";MAXZ:0.8", TestName = "the height stays")]
    public void The_layers_of_the_upper_half_are_counted_from_the_first(string line, string expected)
        => Assert.That(Half(2, 3, true).Image(line, 12), Is.EqualTo(expected));

    [Test]
    public void Without_a_cut_nothing_changes()
    {
        var same = new PartFigures(File.Toolpath, File.Toolpath, true);
        Assert.That(same.IsActive, Is.False);
        Assert.That(same.Image(";TIME:1000", AfterFirst), Is.EqualTo(";TIME:1000"));
    }

    private static PartFigures Half(int first, int last, bool counts)
        => new(File.Toolpath, File.Toolpath.Keep(new MoveFilter { FirstLayer = first, LastLayer = last }), counts);
}
