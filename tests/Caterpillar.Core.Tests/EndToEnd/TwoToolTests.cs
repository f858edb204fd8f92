using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Slicing;
using Caterpillar.Tests.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.EndToEnd;

/// <summary>A small print with two tools and a purge tower, written, read back, checked and simulated.</summary>
public class TwoToolTests
{
    private static readonly string[] Values =
    [
        "tool_offsets_mm=0,0,0; 18,0,0", "purge_tower=true", "purge_tower_width_mm=12", "purge_tower_brim_width_mm=0", "purge_volume_mm3=4",
        "standby_temperature_c=160", "wall_count=1", "bottom_layers=0", "top_layers=0", "infill_density_percent=0", "tool_change_time_s=8",
        "setup_comments=false",
    ];

    [TestCase("ender3")]
    [TestCase("klipper_256")]
    public void The_program_is_the_one_that_was_checked_by_hand(string printer) => Golden.Check($"slice/two_tools_{printer}.gcode", Written(printer).Text);

    [TestCase("ender3", "T0", "T1")]
    [TestCase("klipper_256", "ACTIVATE_EXTRUDER EXTRUDER=extruder", "ACTIVATE_EXTRUDER EXTRUDER=extruder1")]
    public void Each_change_retracts_goes_to_the_tower_cools_changes_heats_and_purges(string printer, string first, string second)
    {
        var lines = Encoding.ASCII.GetString(Written(printer).Text).Split('\n').Where(l => !l.StartsWith(";Z") && !l.StartsWith(";HEIGHT")).ToArray();
        var changes = Enumerable.Range(0, lines.Length).Where(i => lines[i] == first || lines[i] == second).ToArray();
        Assert.That(changes.Select(i => lines[i]), Is.EqualTo(new[] { second, first }));
        foreach (var at in changes)
        {
            var (old, now) = lines[at] == second ? (0, 1) : (1, 0);
            Assert.That(lines[at - 1], Is.EqualTo($"M104 T{old} S160"));
            var last = lines.Take(at).Last(l => l.Contains(" E"));
            Assert.That(last, Does.StartWith("G1 E-").And.Not.Contain(" X"), "retracted");
            Assert.That(lines[at - 2], Does.StartWith("G0 "), "on the tower");
            // PLA from the second layer on, PETG on the first one.
            var next = lines.Skip(at + 1).SkipWhile(l => l.StartsWith("G") || l == "M83").ToArray();
            Assert.That(next[0], Is.EqualTo($"M109 T{now} S{(now == 0 ? 210 : 235)}"));
            Assert.That(next.First(l => l.StartsWith(";TYPE")), Is.EqualTo(";TYPE:Wipe tower"));
        }
        Assert.That(lines, Does.Contain("M104 T1 S0").Or.Contain("M104 T0 S0"), "the tool that is not current is turned off");
    }

    [TestCase("ender3")]
    [TestCase("klipper_256")]
    public void Read_back_it_has_its_tools_its_tower_and_its_times(string printer)
    {
        var (text, setup) = Written(printer);
        var file = GCodeDecoder.Decode(text, new DecodeOptions { Flavor = setup.Printer.Flavor }).Value!;
        Assert.That(PrintCheck.Run(file, setup).Where(d => d.Severity > Severity.Note), Is.Empty);
        var statistics = PrintStatistics.Of(Timeline.Of(file.Toolpath, setup));
        Assert.That(statistics.Tools.Select(t => t.Tool), Is.EqualTo(new[] { 0, 1 }));
        Assert.That(statistics.Tools.Select(t => t.Filament), Has.All.GreaterThan(1));
        Assert.That(statistics.Roles.Select(r => r.Role), Does.Contain(Role.PrimeTower));
        Assert.That(statistics.Waits.ToolChanges, Is.EqualTo(16).Within(1e-9));
        Assert.That(statistics.Waits.Heating, Is.GreaterThan(20));
    }

    private static (byte[] Text, PrintSetup Setup) Written(string printer)
    {
        string[] own = printer == "ender3" ? [] : ["thumbnails_px=", "tool_change_gcode=ACTIVATE_EXTRUDER EXTRUDER=extruder{if tool > 0}{tool}{endif}"];
        var setup = new ProfileLibrary().Setup(printer, "pla", null, [.. Values, .. own], ["petg"]).OrThrow();
        var middle = setup.Printer.BuildBounds.Center;
        SliceModel Part(double x, int tool)
        {
            var block = Solids.Block(middle.X + x, middle.Y, 0, middle.X + x + 5, middle.Y + 5, 0.4);
            return new SliceModel(new NamedMesh("part " + tool, block), setup.Settings with { PartTool = tool });
        }
        using var job = PrintJob.Slice([Part(0, 0), Part(8, 1)], setup).OrThrow();
        using var stream = new MemoryStream();
        var written = job.Write(stream, "two.gcode");
        Assert.That(written.Value, Is.Not.Null, string.Join("\n", written.Diagnostics));
        Assert.That(written.Diagnostics.Where(d => d.Severity > Severity.Note), Is.Empty);
        return (stream.ToArray(), setup);
    }
}
