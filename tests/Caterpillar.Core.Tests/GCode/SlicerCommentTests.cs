using System.Linq;
using System.Text;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Layers, roles and objects as each slicer says them: two layers, an outer wall and infill.</summary>
public class SlicerCommentTests
{
    [TestCase("Cura", ";LAYER:0\n;TYPE:WALL-OUTER\n;MESH:part.stl\n", ";TYPE:FILL\n", ";LAYER:1\n", "part.stl")]
    [TestCase("PrusaSlicer", ";LAYER_CHANGE\n;Z:.2\n;HEIGHT:.2\n; printing object part id:0\n;TYPE:External perimeter\n;WIDTH:.45\n", ";TYPE:Internal infill\n",
        "; stop printing object part id:0\n;LAYER_CHANGE\n;Z:.4\n;HEIGHT:.2\n; printing object part id:0\n", "part id:0")]
    [TestCase("OrcaSlicer", ";LAYER_CHANGE\n;Z:0.2\n;HEIGHT:0.2\n;TYPE:Outer wall\n", ";TYPE:Sparse infill\n", ";LAYER_CHANGE\n;Z:0.4\n;HEIGHT:0.2\n", "")]
    [TestCase("BambuStudio", "; CHANGE_LAYER\n; Z_HEIGHT: 0.2\n; LAYER_HEIGHT: 0.2\n; FEATURE: Outer wall\n", "; FEATURE: Sparse infill\n",
        "; CHANGE_LAYER\n; Z_HEIGHT: 0.4\n; LAYER_HEIGHT: 0.2\n", "")]
    [TestCase("Simplify3D 4", "; layer 1, Z = 0.200\n; feature outer perimeter\n", "; feature infill\n", "; layer 2, Z = 0.400\n", "")]
    [TestCase("Simplify3D 3", "; layer 1, Z = 0.200\n; outer perimeter\n", "; infill\n", "; layer 2, Z = 0.400\n", "")]
    [TestCase("ideaMaker", ";LAYER:0\n;Z:0.200\n;HEIGHT:0.200\n;TYPE:WALL-OUTER\n", ";TYPE:FILL\n", ";LAYER:1\n;Z:0.400\n;HEIGHT:0.200\n", "")]
    [TestCase("KISSlicer", "; BEGIN_LAYER_OBJECT z=0.200 z_thickness=0.200\n; 'Perimeter Path', 2.5 [feed mm/s], 30.0 [head mm/s]\n",
        "; 'Sparse Infill Path', 2.5 [feed mm/s], 30.0 [head mm/s]\n", "; BEGIN_LAYER_OBJECT z=0.400 z_thickness=0.200\n", "")]
    [TestCase("Klipper objects", ";LAYER_CHANGE\n;Z:0.2\n;HEIGHT:0.2\nEXCLUDE_OBJECT_START NAME=part\n;TYPE:External perimeter\n", ";TYPE:Internal infill\n",
        ";LAYER_CHANGE\n;Z:0.4\n;HEIGHT:0.2\n", "part")]
    public void Layers_roles_and_objects(string slicer, string first, string infill, string second, string part)
    {
        var text = "M83\nG1 X0 Y-5 Z0.2\nG1 X50 E1\n" + first + "G1 X0 Y0 Z0.2 F3000\nG1 X10 E1\n" + infill + "G1 Y10 E1\n" + second + "G1 Z0.4\nG1 Y0 E1\n";
        var toolpath = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(text), new DecodeOptions { Flavor = FlavorTable.Slicer }).Value!.Toolpath;
        var prints = toolpath.Moves().Where(m => m.Kind == MoveKind.Print).ToArray();
        Assert.That(prints.Select(m => m.Role), Is.EqualTo(new[] { Role.Unspecified, Role.OuterWall, Role.Infill, Role.Infill }), slicer);
        Assert.That(prints[0].Layer, Is.EqualTo(-1), "the purge line is before the first layer");
        var layers = prints.Skip(1).Select(m => toolpath.Layers[m.Layer]).ToArray();
        Assert.That(layers.Select(l => l.Z), Is.EqualTo(new[] { 0.2, 0.2, 0.4 }).Within(1e-12), slicer);
        Assert.That(layers.Select(l => l.Thickness), Is.EqualTo(new[] { 0.2, 0.2, 0.2 }).Within(1e-9), slicer);
        Assert.That(layers[2].Index, Is.EqualTo(layers[0].Index + 1), slicer);
        Assert.That(layers.Select(l => l.Object), Is.All.EqualTo(part), slicer);
    }

    [Test]
    public void Slic3r_states_it_after_the_moves()
    {
        const string Text = "M83\nG1 Z0.300 F7800 ; move to next layer (0)\nG1 X10 E1 ; perimeter\nG1 Y10 E1 ; infill\nG1 Z0.600 F7800 ; move to next layer "
            + "(1)\nG1 Y0 E1 ; infill\n";
        var toolpath = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(Text), new DecodeOptions { Flavor = FlavorTable.Slicer }).Value!.Toolpath;
        var prints = toolpath.Moves().Where(m => m.Kind == MoveKind.Print).ToArray();
        Assert.That(prints.Select(m => m.Role), Is.EqualTo(new[] { Role.InnerWall, Role.Infill, Role.Infill }));
        Assert.That(prints.Select(m => toolpath.Layers[m.Layer].Index), Is.EqualTo(new[] { 0, 0, 1 }));
        Assert.That(prints.Select(m => toolpath.Layers[m.Layer].Z), Is.EqualTo(new[] { 0.3, 0.3, 0.6 }));
    }

    [Test]
    public void Without_comments_layers_follow_from_heights()
    {
        const string Text = "M83\nG1 Z0.3\nG1 X10 E1\nG1 Z0.6\nG1 X0 E1\nG1 Z0.3\nG1 X20 E1\n";
        var toolpath = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(Text), new DecodeOptions { Flavor = FlavorTable.Slicer }).Value!.Toolpath;
        Assert.That(toolpath.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => toolpath.Layers[m.Layer].Index), Is.EqualTo(new[] { 0, 1, 0 }));
        Assert.That(toolpath.Layers, Is.EqualTo(new[] { new Layer(0, 0.3, 0.3), new Layer(1, 0.6, 0.3) }));
    }
}
