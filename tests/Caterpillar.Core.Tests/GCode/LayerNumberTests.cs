using System.Linq;
using System.Text;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Layers are counted by their numbers: objects, and travels between them, make no more of them.</summary>
public class LayerNumberTests
{
    private const string TwoObjects = "M83\n;LAYER:0\nG0 X0 Y0 Z0.2\n;MESH:a\nG1 X10 E1\n;MESH:NONMESH\nG0 X20\n;MESH:b\nG1 X30 E1\n;MESH:NONMESH\n"
        + "G0 X40\n;LAYER:1\nG0 X0 Z0.4\n;MESH:a\nG1 X10 E1\n;MESH:b\nG1 X30 E1\n";

    [Test]
    public void Travels_outside_of_objects_make_no_layers()
    {
        var toolpath = Decode(TwoObjects);
        Assert.That(toolpath.CountLayers(), Is.EqualTo(2));
        Assert.That(toolpath.Layers.Select(l => (l.Index, l.Object)), Is.EqualTo(new[] { (0, "a"), (0, "b"), (1, "a"), (1, "b") }));
        Assert.That(toolpath.Moves().Select(m => toolpath.NumberOfLayer(m)), Is.EqualTo(new int?[] { 0, 0, 0, 0, 0, 1, 1, 1 }));
    }

    [Test]
    public void A_skirt_outside_of_the_objects_is_in_their_layer()
    {
        var toolpath = Decode("M83\n;LAYER:0\nG0 X0 Y0 Z0.2\nG1 X5 E1\n;MESH:a\nG1 X10 E1\n;LAYER:1\n;MESH:NONMESH\nG0 Z0.4\n;MESH:a\nG1 X30 E1\n");
        Assert.That(toolpath.NumbersOfLayers(), Is.EqualTo(new[] { 0, 1 }));
        Assert.That(toolpath.Layers.Select(l => (l.Index, l.Object, l.Z)), Is.EqualTo(new[] { (0, "", 0.2), (0, "a", 0.2), (1, "a", 0.4) }));
    }

    [Test]
    public void A_layer_without_extrusions_keeps_its_number()
    {
        var toolpath = Decode("M83\n;LAYER:0\nG1 X5 Z0.2 E1\n;LAYER:1\nG0 X7\n;LAYER:2\nG1 X10 E1\n");
        Assert.That(toolpath.NumbersOfLayers(), Is.EqualTo(new[] { 0, 2 }), "two marks without an extrusion between them are one");
    }

    [TestCase("cu_cheburashka_marlin_relE_zhop.gcode.gz", 126)]
    [TestCase("cu_plate_marlin_absE.gcode", 24)]
    [TestCase("cu_spot_griffin_raft_treesupport.gcode.gz", 106)]
    [TestCase("cu_torus_ultigcode_volE_fwr.gcode.gz", 33)]
    [TestCase("cu_tube_spiralize.gcode", 67)]
    [TestCase("ps_homer_raft_support_brim.gcode.gz", 234)]
    [TestCase("ps_spot_marlin2_relE.gcode.gz", 127)]
    [TestCase("ps_torus_sequential.gcode.gz", 20)]
    [TestCase("s3r_torus_repetier_relE_zhop.gcode.gz", 33)]
    public void Files_of_slicers_have_the_layers_that_were_sliced(string file, int layers)
    {
        var toolpath = GCodeDecoder.Decode(GCodeFiles.Document(file)).Value!.Toolpath;
        Assert.That(toolpath.CountLayers(), Is.EqualTo(layers));
        var numbers = toolpath.NumbersOfLayers();
        var printed = toolpath.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => toolpath.NumberOfLayer(m)).OfType<int>().Distinct().ToArray();
        Assert.That(printed, Is.EquivalentTo(numbers), "something is printed in each layer");
    }

    [Test]
    public void Templates_number_layers_alike()
    {
        var toolpath = Decode(TwoObjects);
        var setup = new PrintSetup(new Printer { LayerChangeGCode = new("; layer {layer} of {layer_count}") }, new Material(), new PrintSettings());
        var text = Encoding.ASCII.GetString(NewFile.Of(toolpath, SetupFormat.Of(setup, toolpath).Value));
        Assert.That(text, Does.Contain("; layer 1 of 2"));
        Assert.That(text, Does.Not.Contain("; layer 2 of"));
    }

    private static Toolpath Decode(string text)
        => GCodeDecoder.Decode(Encoding.ASCII.GetBytes(text), new DecodeOptions { Flavor = FlavorTable.Marlin2 }).Value!.Toolpath;
}
