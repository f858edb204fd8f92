using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using NUnit.Framework;

namespace Caterpillar.Tests.Jobs;

/// <summary>The start code of an upper half, from what the file says before it.</summary>
public class UpperHalfTests
{
    private const string Lower = ";LAYER_CHANGE\n;Z:0.2\n;HEIGHT:0.2\nG1 X50 Y50 Z0.2 F3000\nG1 X70 E0.7\nG1 Y70 E0.7\n;LAYER_CHANGE\n;Z:0.4\n;HEIGHT:0.2\n";
    private const string Upper = "G1 Z0.4\nG1 X50 E0.7\n;LAYER_CHANGE\n;Z:0.6\n;HEIGHT:0.2\nG1 Z0.6\nG1 X70 E0.7\nM104 S0\nM84\n";

    private static string[] Written(string start, string within = "")
    {
        var job = new FileJob(GCodeDecoder.Decode(GCodeDocument.FromText(start + Lower + within + Upper)).OrThrow()).KeepAbove(0.3);
        Assert.That(job.Diagnostics.Select(d => d.Code), Is.EqualTo(new[] { "cut.place_nozzle" }));
        using var stream = new MemoryStream();
        job.OrThrow().Write(stream, "upper.gcode", null).OrThrow();
        return Encoding.UTF8.GetString(stream.ToArray()).Split('\n').SkipWhile(l => l != "G28 X Y").Skip(1).TakeWhile(l => l != "M82").ToArray();
    }

    [TestCase("M104 S200\nG28\nM109 S200\nM83\n", "", "M109 S200")]
    [TestCase("M140 S60\nG28\nM190 S60\nM109 S200\nM83\n", "M140 S55\n", "M190 S55|M109 S200")]
    [TestCase("G28\nM109 S200\nM83\n", "M104 S190\n", "M109 S190")]
    [TestCase("G28\nM109 T0 S200\nM109 T1 S210\nT1\nM83\n", "", "M109 T0 S200|M109 T1 S210|T1")]
    [TestCase("G28\nM109 S200\nM83\nM106 S255\nM204 P900\nM900 K0.1\n", "M106 S128\nM204 P700\n", "M109 S200|M900 K0.1|M106 S128|M204 P700")]
    [TestCase("G28\nM109 S200\nM83\nM106 P1 S9\nM106 S255\n", "M107\n", "M109 S200|M106 P1 S9|M107")]
    [TestCase("START_PRINT BED_TEMP=65 EXTRUDER_TEMP=215\nM83\n", "", "M190 S65|M109 S215")]
    [TestCase("START_PRINT BED=65 NOZZLE=215\nM83\n", "M220 S90\n", "M190 S65|M109 S215|M220 S90")]
    public void Temperatures_tools_and_settings_are_the_last_of_their_kind(string start, string within, string expected)
        => Assert.That(string.Join("|", Written(start, within)), Is.EqualTo(expected));

    [TestCase("G28\nM83\n", 0.3, "cut.no_temperature")]
    [TestCase("G28\nM109 S200\nM83\n", 0.7, "cut.outside")]
    [TestCase("G28\nM109 S200\nM83\n", 0.1, "cut.outside")]
    public void What_cannot_go_on_is_an_error(string start, double z, string code)
        => Assert.That(new FileJob(GCodeDecoder.Decode(GCodeDocument.FromText(start + Lower + Upper)).OrThrow()).KeepAbove(z).Diagnostics.Single().Code,
            Is.EqualTo(code));

    [Test]
    public void The_end_code_of_a_lower_half_stays_above_it()
    {
        var end = Upper.Replace("M84\n", "G1 X0 Y0 Z2\nM84\n");
        var job = new FileJob(GCodeDecoder.Decode(GCodeDocument.FromText("G28\nM109 S200\nM83\n" + Lower + end)).OrThrow()).KeepBelow(0.3).OrThrow();
        using var stream = new MemoryStream();
        job.Write(stream, "lower.gcode", null).OrThrow();
        var read = GCodeDecoder.Decode(GCodeDocument.FromText(Encoding.UTF8.GetString(stream.ToArray()))).OrThrow().Toolpath;
        foreach (var toolpath in new[] { job.Toolpath, read }) Assert.That(toolpath[toolpath.Count - 1].End, Is.EqualTo(new Vec3(0, 0, 5.2)));
    }

    [Test]
    public void Both_halves_have_the_extrusions_of_the_whole()
    {
        var job = new FileJob(GCodeDecoder.Decode(GCodeDocument.FromText("G28\nM109 S200\nM83\n" + Lower + Upper)).OrThrow());
        double E(FileJob half) => half.Toolpath.Moves().Sum(m => m.Deposited);
        Assert.That(E(job.KeepBelow(0.3).OrThrow()), Is.EqualTo(1.4).Within(1e-9));
        Assert.That(E(job.KeepAbove(0.3).OrThrow()), Is.EqualTo(1.4).Within(1e-9));
        using var stream = new MemoryStream();
        job.KeepBelow(0.3).OrThrow().Write(stream, "lower.gcode", null).OrThrow();
        Assert.That(Encoding.UTF8.GetString(stream.ToArray()), Does.EndWith("M104 S0\nM84\n").And.Contain("G1 Y70 E0.7").And.Not.Contain("Z0.6"));
    }
}
