using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>A scaled file extrudes what its extrusions need, and its comments say so.</summary>
public class ScaleTests
{
    [Test]
    public void Comments_of_PrusaSlicer_follow()
    {
        const string Text = "M83\n;LAYER_CHANGE\n;Z:.2\n;HEIGHT:.2\n;BEFORE_LAYER_CHANGE\n;0.2\nG1 X0 Y0 Z.2\n;AFTER_LAYER_CHANGE\n;0.2\n;TYPE:Perimeter\n"
            + ";WIDTH:0.449999\nG1 X10 E1\n;LAYER_CHANGE\n;Z:.4\n;HEIGHT:.2\nG1 Z.4\n;HEIGHT:.3\nG1 X0 E1\n; 17\n";
        var scaled = Scale(Text, Affine.Scale(2));
        Assert.That(scaled, Is.EqualTo("M83\n;LAYER_CHANGE\n;Z:0.4\n;HEIGHT:0.4\n;BEFORE_LAYER_CHANGE\n;0.4\nG1 X0 Y0 Z.4\n;AFTER_LAYER_CHANGE\n;0.4\n"
            + ";TYPE:Perimeter\n;WIDTH:0.899998\nG1 X20 E8\n;LAYER_CHANGE\n;Z:0.8\n;HEIGHT:0.4\nG1 Z.8\n;HEIGHT:0.6\nG1 X0 E8\n; 17\n"));
    }

    [TestCase("; layer 1, Z = 0.200\n", "; layer 1, Z = 0.1\n")]
    [TestCase("; BEGIN_LAYER_OBJECT z=0.200 z_thickness=0.200\n", "; BEGIN_LAYER_OBJECT z=0.1 z_thickness=0.1\n")]
    [TestCase("; CHANGE_LAYER\n; Z_HEIGHT: 0.2\n; LAYER_HEIGHT: 0.2\n; LINE_WIDTH: 0.42\n",
        "; CHANGE_LAYER\n; Z_HEIGHT: 0.1\n; LAYER_HEIGHT: 0.1\n; LINE_WIDTH: 0.21\n")]
    public void Comments_of_other_slicers_follow(string comments, string expected)
        => Assert.That(Scale("M83\n" + comments + "G1 X0 Y0 Z0.2\nG1 X10 E1\n", Affine.Scale(0.5)),
            Is.EqualTo("M83\n" + expected + "G1 X0 Y0 Z0.1\nG1 X5 E0.125\n"));

    [Test]
    public void A_lifted_print_has_its_heights_and_keeps_its_widths()
        => Assert.That(Scale("M83\n;LAYER_CHANGE\n;Z:0.2\n;HEIGHT:0.2\n;WIDTH:0.45\nG1 X0 Y0 Z0.2\nG1 X10 E1\n", Affine.Move(new Vec3(0, 0, 5))),
            Is.EqualTo("M83\n;LAYER_CHANGE\n;Z:5.2\n;HEIGHT:0.2\n;WIDTH:0.45\nG1 X0 Y0 Z5.2\nG1 X10 E1\n"));

    [Test]
    public void A_moved_print_keeps_its_comments()
        => Assert.That(Scale("M83\n;LAYER_CHANGE\n;Z:.20\n;WIDTH:0.450\nG1 X0 Y0 Z0.2\nG1 X10 E1\n", Affine.Move(new Vec3(5, 0, 0))),
            Is.EqualTo("M83\n;LAYER_CHANGE\n;Z:.20\n;WIDTH:0.450\nG1 X5 Y0 Z0.2\nG1 X15 E1\n"));

    [TestCase("cu_plate_marlin_absE.gcode")]
    [TestCase("ps_spot_marlin2_relE.gcode.gz")]
    public void The_file_extrudes_the_cube_of_the_scale(string file)
    {
        var before = GCodeDecoder.Decode(GCodeFiles.Document(file)).Value!;
        var edited = before.Toolpath.Transform(new MoveFilter().InLayersOf(before.Toolpath), Affine.Scale(0.5));
        var after = GCodeDecoder.Decode(GCodeEditor.ToDocument(before, edited).Value!).Value!;
        double Printed(DecodedGCode g) => g.Toolpath.Moves().Where(m => m.Layer >= 0).Sum(m => m.Deposited);
        Assert.That(Printed(after), Is.EqualTo(Printed(before) / 8).Within(0.001 * Printed(before)));
        Assert.That(after.Toolpath.CountLayers(), Is.EqualTo(before.Toolpath.CountLayers()));
        var top = after.Toolpath.Layers[after.Toolpath.Layers.Count - 1];
        Assert.That(top.Z, Is.EqualTo(before.Toolpath.Layers[before.Toolpath.Layers.Count - 1].Z / 2).Within(1e-6));
        Assert.That(after.Report.Retractions, Is.EqualTo(before.Report.Retractions));
    }

    private static string Scale(string text, Affine map)
    {
        var decoded = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(text)).Value!;
        var result = GCodeEditor.ToDocument(decoded, decoded.Toolpath.Transform(map));
        Assert.That(result.HasErrors, Is.False);
        return Encoding.ASCII.GetString(result.Value!.ToBytes());
    }
}
