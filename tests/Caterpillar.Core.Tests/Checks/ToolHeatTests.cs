using System.Linq;
using System.Text;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Temperatures and materials of several tools, as the checks and the statistics see them.</summary>
public class ToolHeatTests
{
    private static readonly PrintSetup Setup = new()
    {
        Printer = new Printer { ToolOffsets = new(Vec3.Zero, new Vec3(18, 0, 0)) },
        Material = new Material { Density = 1, CostPerKg = 10 },
        ToolMaterials = new(new Material { Density = 2, CostPerKg = 100, FilamentDiameter = 2.85 }),
    };

    private const string Start = "M190 S60\nG28\nM109 S210\nM83\nG1 X50 Y50 Z0.2 F3000\nG1 X60 E0.4 F1200\n";

    [TestCase("T1\nG1 X70 E0.4\n", false, true)]
    [TestCase("T1\nM109 S240\nG1 X70 E0.4\n", false, false)]
    [TestCase("M104 T1 S240\nT1\nG1 X70 E0.4\n", false, false)]
    [TestCase("T1\nG1 X70 E0.4\n", true, false)]
    public void A_nozzle_of_its_own_needs_heat_of_its_own(string code, bool shared, bool isCold)
    {
        var setup = Setup with { Printer = Setup.Printer with { SharedNozzle = shared } };
        var codes = PrintCheck.Run(Decode(Start + code + "M104 T0 S0\nM104 T1 S0\nM104 S0\nM140 S0\n"), setup).Select(d => d.Code).ToArray();
        Assert.That(codes.Contains(CheckCodes.ColdExtrusion), Is.EqualTo(isCold), string.Join(" ", codes));
    }

    [Test]
    public void A_nozzle_that_is_left_on_is_found()
    {
        var codes = PrintCheck.Run(Decode(Start + "T1\nM109 S240\nG1 X70 E0.4\nM104 S0\nM140 S0\n"), Setup).Select(d => d.Code);
        Assert.That(codes, Does.Contain(CheckCodes.HeatLeftOn));
    }

    [Test]
    public void Each_nozzle_is_checked_against_the_hot_end()
    {
        var hot = Setup with { ToolMaterials = new(new Material { NozzleTemperature = 500 }) };
        var found = PrintCheck.Run(Decode(Start + "M104 S0\nM140 S0\n"), hot);
        Assert.That(found.Select(d => d.Code), Does.Contain(CheckCodes.NozzleTemperature));
    }

    [Test]
    public void Mass_and_cost_are_those_of_the_material_of_each_tool()
    {
        var file = Decode("; filament_diameter = 1.75,2.85\nM83\nG1 X10 E100 F600\nT1\nG1 X20 E50\n");
        var statistics = PrintStatistics.Of(Timeline.Of(file.Toolpath, Setup));
        double first = 100 * ExtrusionModel.FilamentAreaOf(1.75) / 1000, second = 50 * ExtrusionModel.FilamentAreaOf(2.85) / 1000 * 2;
        Assert.That(statistics.Tools.Select(t => t.Mass), Is.EqualTo(new double?[] { first, second }).Within(1e-9));
        Assert.That(statistics.Mass, Is.EqualTo(first + second).Within(1e-9));
        Assert.That(statistics.Cost, Is.EqualTo(first / 1000 * 10 + second / 1000 * 100).Within(1e-9));
        Assert.That(statistics.Filament, Is.EqualTo(150).Within(1e-9));
    }

    private static DecodedGCode Decode(string text) => GCodeDecoder.Decode(Encoding.ASCII.GetBytes(text)).Value!;
}
