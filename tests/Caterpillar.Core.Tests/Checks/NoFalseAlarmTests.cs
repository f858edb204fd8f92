using System;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Prints by slicers have no errors but those of a smaller printer.</summary>
public class NoFalseAlarmTests
{
    [TestCase("cu_bowl_surface_mode.gcode.gz")]
    [TestCase("cu_cheburashka_marlin_relE_zhop.gcode.gz")]
    [TestCase("cu_plate_marlin_absE.gcode")]
    [TestCase("cu_spot_griffin_raft_treesupport.gcode.gz")]
    [TestCase("cu_torus_ultigcode_volE_fwr.gcode.gz")]
    [TestCase("cu_tube_spiralize.gcode")]
    [TestCase("ps_cheburashka_rrf_zhop_wipe.gcode.gz")]
    [TestCase("ps_fandisk_marlin2_absE.gcode.gz")]
    [TestCase("ps_homer_raft_support_brim.gcode.gz")]
    [TestCase("ps_igea_spiral_vase.gcode.gz")]
    [TestCase("ps_nested_makerware.gcode")]
    [TestCase("ps_overlap_two_tools.gcode")]
    [TestCase("ps_plate_mach3_A.gcode")]
    [TestCase("ps_plate_smoothie_volE_fwr.gcode")]
    [TestCase("ps_spot_marlin2_relE.gcode.gz")]
    [TestCase("ps_torus_sequential.gcode.gz")]
    [TestCase("s3r_beetle_dirty_teacup.gcode.gz")]
    [TestCase("s3r_fandisk_reprap_absE.gcode.gz")]
    [TestCase("s3r_nested_smoothie_volE_fwr.gcode")]
    [TestCase("s3r_plate_machinekit_A.gcode")]
    [TestCase("s3r_torus_repetier_relE_zhop.gcode.gz")]
    public void A_planar_print_by_a_slicer_collides_with_nothing(string name)
    {
        var file = GCodeDecoder.Decode(TestData.ReadBytes(TestData.Shared("gcode/" + name)), new DecodeOptions { FilamentDiameter = 1.75 }).Value!;
        var setup = new PrintSetup { Printer =
            new Printer { BuildVolume = new Vec3(500, 500, 300), Origin = BedOrigin.Center, ToolOffsets = new(Vec3.Zero, Vec3.Zero) } };
        var errors = PrintCheck.Run(file, setup).Where(d => d.Severity == Severity.Error
            && !d.Code.StartsWith("limit.", StringComparison.Ordinal) && !d.Code.StartsWith("bed.", StringComparison.Ordinal));
        Assert.That(errors, Is.Empty);
    }

    [TestCaseSource(nameof(Printers))]
    public void Every_shipped_printer_writes_a_small_print_without_a_word(string name)
    {
        var setup = new ProfileLibrary().Setup(name).OrThrow();
        var (center, settings) = (setup.Printer.BuildBounds.Center, setup.Settings);
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        var volume = setup.Extrusion.VolumePerE;
        for (var k = 0; k < 3; k++)
        {
            var z = settings.FirstLayerHeight + k * settings.LayerHeight;
            var layer = builder.AddLayer(new Layer(k, z, k == 0 ? settings.FirstLayerHeight : settings.LayerHeight));
            builder.Add(new Vec3(center.X - 20, center.Y, z + 2), 0, 0, settings.TravelSpeed, MoveKind.Travel, Role.Unspecified, layer, 0, 0);
            builder.Add(new Vec3(center.X - 20, center.Y, z), 0, 0, setup.Printer.ZHopSpeed, MoveKind.Travel, Role.Unspecified, layer, 0, 0);
            var e = volume is { } unit ? 40 * settings.LineWidth * settings.LayerHeight / unit : 0;
            builder.Add(new Vec3(center.X + 20, center.Y, z), e, e, Math.Min(settings.PrintSpeed, 20), MoveKind.Print, Role.OuterWall, layer, 0, 0);
        }
        var written = SafeWriter.ToDocument(builder.Build([new ToolpathTool(volume)]), setup);
        Assert.That(written.Diagnostics.Where(d => d.Severity != Severity.Note), Is.Empty);
    }

    private static string[] Printers() => new ProfileLibrary().Names<Printer>().ToArray();
}
