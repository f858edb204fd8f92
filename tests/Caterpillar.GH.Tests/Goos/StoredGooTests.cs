using System;
using System.IO;
using System.Linq;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using GH_IO.Serialization;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Types;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Goos;

/// <summary>Data that a definition keeps.</summary>
public sealed class StoredGooTests
{
    private static readonly PrintSetup Setup = new() { Settings = new PrintSettings { LineWidth = 0.61 } };
    private static readonly PrintPath Path = new PrintPath([new Vec3(50, 50, 0.2), new Vec3(80, 50, 0.2)], new Bead(0.08, 0.2, 40)) { Role = Role.Infill };

    private static string Xml(GH_IO.GH_ISerializable item)
    {
        var archive = new GH_Archive();
        archive.AppendObject(item, "Item");
        return archive.Serialize_Xml();
    }

    private static T Reopened<T>(T item)
        where T : GH_IO.GH_ISerializable, new()
    {
        var archive = new GH_Archive();
        archive.Deserialize_Xml(Xml(item));
        var copy = new T();
        Assert.That(archive.ExtractObject(copy, "Item"), Is.True);
        Assert.That(Xml(copy), Is.EqualTo(Xml(item)), "The same bytes again.");
        return copy;
    }

    [Test]
    public void Paths_and_steps_keep_their_data_and_their_setup()
    {
        var path = Reopened(new PrintPathGoo(new PathStep(Path, new StepGroup(1)) { KeepStart = true }, Setup));
        Assert.That(path.Value.Points, Is.EqualTo(Path.Points));
        Assert.That((path.ToStep().Group, path.ToStep().KeepStart, path.Setup), Is.EqualTo(((StepGroup?)new StepGroup(1), true, Setup)));
        Assert.That(((EventStep)Reopened(new StepGoo(new FanEvent(0.5))).Value).Event, Is.EqualTo(new FanEvent(0.5)));
        Assert.That(((PathStep)Reopened(new StepGoo(path)).Value).Path.Role, Is.EqualTo(Role.Infill));
        Assert.That(Reopened(new PrintPathGoo()).Value, Is.Null);
    }

    [Test]
    public void A_planned_toolpath_writes_the_same_file()
    {
        var toolpath = new ToolpathGoo(Planner.Plan([Path], Setup).Value!, Setup);
        var back = Reopened(toolpath);
        Assert.That(back.Setup, Is.EqualTo(Setup));
        byte[] Written(ToolpathGoo goo) => Checks.SafeWriter.ToDocument(goo.Value, goo.Setup!).Value!.ToBytes();
        Assert.That(Written(back), Is.EqualTo(Written(toolpath)));
    }

    [Test]
    public void A_decoded_toolpath_keeps_its_file_and_its_edits()
    {
        const string Text = "; a file\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 Y10 E0.5 F1200 ; odd  spaces\nG1 X20 Y20 E0.5\n";
        var decoded = GCodeDecoder.Decode(GCodeDocument.FromText(Text)).Value!;
        var plain = Reopened(new ToolpathGoo(decoded));
        Assert.That(plain.DecodedGCode!.Document!.ToBytes(), Is.EqualTo(decoded.Document!.ToBytes()));
        Assert.That(ReferenceEquals(plain.Value, plain.DecodedGCode.Toolpath), Is.True);
        var edited = new ToolpathGoo(decoded).With(decoded.Toolpath.ScaleSpeed(new MoveFilter { Kinds = [MoveKind.Print] }, 2));
        var back = Reopened(edited);
        string Text2(ToolpathGoo goo) => GCodeEditor.ToDocument(goo.DecodedGCode!, goo.Value).Value!.Lines(1, 10).Aggregate((a, b) => a + "\n" + b);
        Assert.That(Text2(back), Is.EqualTo(Text2(edited)).And.Contains("F2400"));
    }

    [Test]
    public void Files_commands_and_formulas_come_back()
    {
        Assert.That(Reopened(new GCodeGoo { Value = GCodeDocument.FromText("G28\n", "a.gcode") }).Value.ToBytes(), Is.EqualTo(new byte[] { 71, 50, 56, 10 }));
        var command = TurtleCommand.Repeat(3, [TurtleCommand.Of(TurtleAction.Forward, 10), TurtleCommand.Of(TurtleAction.Forward, 20)]);
        Assert.That(Reopened(new TurtleCommandGoo { Value = command }).Value.ToString(), Is.EqualTo(command.ToString()));
        var field = new LayerFieldGoo();
        field.CastFrom("z + x / 10");
        Assert.That(Reopened(field).Value, Is.EqualTo(field.Value));
    }

    [Test]
    public void A_damaged_mesh_is_no_mesh_and_throws_nothing()
    {
        var floor = TriMesh.Create([new(0, 0, 1.0 / 3), new(9, 0, 2), new(0, 9, 2)], [0, 1, 2]);
        var packed = MeshBytes.Pack(floor);
        Assert.That(MeshBytes.Unpack(packed)!.Vertices, Is.EqualTo(floor.Vertices));
        for (var length = 0; length < packed.Length; length++)
            Assert.That(MeshBytes.Unpack(packed.Take(length).ToArray()), Is.Null, $"{length} bytes");
        for (var i = 0; i < packed.Length; i++)
        {
            // The highest bit of a number makes it negative, or too large.
            var damaged = (byte[])packed.Clone();
            damaged[i] ^= 0x80;
            Assert.That(() => MeshBytes.Unpack(damaged), Throws.Nothing, $"byte {i}");
        }
        var chunk = new GH_LooseChunk("test");
        new SetupGoo { Value = new PrintSetup() }.Write(chunk);
        chunk.SetByteArray("PrintedOn", packed.Take(20).ToArray());
        Assert.That(new SetupGoo().Read(chunk), Is.False, "A print without the object that it lies on would be another one.");
    }

    [Test]
    public void Parameters_keep_internalized_data_compactly()
    {
        var param = new PrintPathParam();
        for (var i = 0; i < 3; i++) param.PersistentData.Append(new PrintPathGoo(Path, Setup), new GH_Path(i));
        var back = Reopened(param);
        Assert.That(back.PersistentData.DataCount, Is.EqualTo(3));
        var long_ = new PrintPath(Enumerable.Range(0, 100_001).Select(i => new Vec3(i * 0.1, i % 2, 0.2)), new Bead(0.08, 0.2, 40));
        Assert.That(StepBytes.Pack(long_), Has.Length.LessThan(100_000 * 8), "A third of its numbers.");
        var document = new GH_Document();
        document.AddObject(back, false);
        var plan = new Canvas<PlanToolpathComponent>(document);
        plan.Input("Steps").AddSource(back);
        plan.Solve();
        Assert.That(plan.One<Toolpath>("Toolpath").Moves().Count(m => m.Kind == MoveKind.Print), Is.EqualTo(3));
    }

    [Test]
    public void A_toolpath_parameter_takes_the_name_of_a_file()
    {
        var file = System.IO.Path.Combine(System.IO.Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".gcode");
        File.WriteAllText(file, "M83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 Y10 E0.5 F1200\n");
        var made = typeof(ToolpathParam).GetMethod("Made", System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.NonPublic)!;
        Assert.That(((ToolpathGoo)made.Invoke(new ToolpathParam(), [file])!).Value.Count, Is.EqualTo(2));
        Assert.That(made.Invoke(new ToolpathParam(), ["no such file"]), Is.Null);
        File.Delete(file);
    }
}
