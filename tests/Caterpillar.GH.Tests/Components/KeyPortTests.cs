using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Components.Slice;
using Caterpillar.GH.Params;
using Caterpillar.GH.Plugin;
using Caterpillar.GH.Tests.Host;
using Caterpillar.GH.Tests.Plugin;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using GH_IO.Serialization;
using Grasshopper;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Components;

/// <summary>Ports whose name is a key, and ports that follow choices.</summary>
[Category("Host")]
public sealed class KeyPortTests
{
    private static readonly PrintPath Line = new([new(0, 0, 1), new(10, 0, 1)], new Bead(0.2, 0, 30));

    private static string[] Names(GH_Component component) => component.Params.Input.Select(p => p.NickName).ToArray();

    [Test]
    public void A_port_that_is_added_and_renamed_gets_the_type_and_the_texts_of_its_key()
    {
        var canvas = new Canvas<PrintSettingsComponent>();
        Assert.That(canvas.AddKey("infill_density_percent"), Is.InstanceOf<Param_Number>());
        Assert.That(canvas.AddKey("wall_count"), Is.InstanceOf<Param_Integer>());
        Assert.That(canvas.AddKey("spiral_vase"), Is.InstanceOf<Param_Boolean>());
        var pattern = (ChoiceParam)canvas.AddKey("infill_pattern");
        Assert.That(pattern.Choices.Select(c => c.Key), Has.Member("gyroid").And.Member("grid"));
        Assert.That(pattern.HasNamedValues);
        Assert.That(canvas.AddKey("height_ranges_mm").Access, Is.EqualTo(GH_ParamAccess.list));
        Assert.That(canvas.Component.Params.Input[6].Description, 
            Does.Contain("infill_density_percent: 0 to 100 %").And.Contain("Default: as in the profile."));
        Assert.That(canvas.Solve().Errors.Concat(canvas.Warnings), Is.Empty, "Without values it is the profile.");
        Assert.That(canvas.One<PrintSettings>("Settings"), Is.EqualTo(new ProfileLibrary().Settings("standard").OrThrow()));
        canvas.Feed("infill_density_percent", 33.5).Feed("wall_count", 4).Feed("infill_pattern", "Gyroid").Feed("height_ranges_mm", "1, 2, 0.1", "2, 3, 0.15");
        Assert.That(canvas.Solve().Errors, Is.Empty);
        var settings = canvas.One<PrintSettings>("Settings");
        Assert.That((settings.InfillDensityPercent, settings.WallCount, settings.InfillPattern, settings.LayerRanges.Count),
            Is.EqualTo((33.5, 4, InfillPattern.Gyroid, 2)));
        pattern.RemoveAllSources();
        // What a click in the menu does.
        pattern.SetPersistentData(pattern.Choices.Single(c => c.Key == "grid").Value);
        canvas.Component.ExpireSolution(false);
        Assert.That(canvas.Solve().One<PrintSettings>("Settings").InfillPattern, Is.EqualTo(InfillPattern.Grid));
    }

    [Test]
    public void Wrong_names_values_and_repeated_keys_are_answered()
    {
        var canvas = new Canvas<PrintSettingsComponent>();
        canvas.AddKey("wal_count");
        Assert.That(canvas.Solve().Warnings.Single(), Does.Contain("Did you mean wall_count?").And.Contain("Rename the port."));
        Assert.That(canvas.One<PrintSettings>("Settings"), Is.Not.Null, "A port without a value does no harm.");
        canvas.Feed("wal_count", "3");
        Assert.That(canvas.Solve().Errors, Has.One.Contains("Did you mean wall_count?"));
        Assert.That(canvas.All("Settings"), Is.EqualTo(new object?[] { null }));
        var foreign = new Canvas<PrintSettingsComponent>().Key("nozzle_diameter_mm", "0.6");
        Assert.That(foreign.Solve().Errors, Has.One.Contains("It is a key of printers."));
        Assert.That(new Canvas<PrintSettingsComponent>().Key("infill_density_percent", 120).Solve().Errors, Has.Some.Contains("0 to 100"));
        Assert.That(new Canvas<PrintSettingsComponent>().Feed("Layer Height", 0.3).Key("layer_height_mm", 0.2).Solve().Errors,
            Has.One.Contains("Two ports set layer_height_mm"));
        Assert.That(new Canvas<MaterialComponent>().Feed("Profile", "petg").Feed("Nozzle Temperature", 233).Solve().One<Material>("Material"),
            Is.EqualTo(new ProfileLibrary().Material("petg").OrThrow() with { NozzleTemperature = 233 }));
        Assert.That(new Canvas<PrintSettingsComponent>().Solve().Component.Params.Input.Select(p => p.Name), Has.None.EqualTo("key"));
    }

    [Test]
    public void Widths_take_percentages_of_the_nozzle_as_text_and_numbers_in_mm()
    {
        var canvas = new Canvas<PrintSettingsComponent>().Key("line_width_mm", "110%").Key("outer_wall_line_width_mm", "120 %")
            .Key("infill_line_width_mm", 0.55).Key("top_surface_line_width_mm", "0.41").Key("support_line_width_mm", 1);
        Assert.That(canvas.Solve().Errors, Is.Empty);
        var settings = new PrintSetup { Printer = new Printer { NozzleDiameter = 0.6 }, Settings = canvas.One<PrintSettings>("Settings") }.Settings;
        double[] widths = [settings.LineWidth, settings.OuterWallLineWidth, settings.InfillLineWidth, settings.TopSurfaceLineWidth, settings.SupportLineWidth];
        Assert.That(widths, Is.EqualTo(new[] { 0.66, 0.72, 0.55, 0.41, 1 }).Within(1e-12));
        Assert.That(new Canvas<PrintSettingsComponent>().Key("line_width_mm", "wide").Solve().Errors, Has.One.Contains("a percentage of the nozzle diameter"));
    }

    [Test]
    public void Tools_at_heights_the_place_of_the_tower_and_flow_by_temperature_are_lists()
    {
        var settings = new Canvas<PrintSettingsComponent>().Key("tool_changes_mm", "2, 1", "5, 0").Key("purge_tower_place_mm", "20, 150").Solve();
        Assert.That(settings.Errors, Is.Empty);
        Assert.That(settings.One<PrintSettings>("Settings").ToolChanges, Is.EqualTo(new[] { new ToolChange(2, 1), new ToolChange(5, 0) }));
        Assert.That(settings.One<PrintSettings>("Settings").PurgeTowerPlace.Single(), Is.EqualTo(new Vec3(20, 150)));
        var material = new Canvas<MaterialComponent>().Key("material_flow_limits", "200, 8", "220, 14").Solve();
        Assert.That(material.One<Material>("Material").FlowLimits, Is.EqualTo(new[] { new FlowLimit(200, 8), new FlowLimit(220, 14) }));
    }

    [Test]
    public void Usual_ports_stay_and_added_ones_go_with_the_minus()
    {
        var canvas = new Canvas<PrintSettingsComponent>();
        var count = canvas.Component.Params.Input.Count;
        Assert.That(() => canvas.Component.Params.Insert(2), Throws.InvalidOperationException);
        Assert.That(() => canvas.Component.Params.Remove(1), Throws.InvalidOperationException);
        canvas.Component.Params.Insert(count);
        canvas.Component.Params.Insert(count + 1);
        Assert.That(Names(canvas.Component).Skip(count), Is.EqualTo(new[] { "key", "key2" }), "Names are not repeated.");
        canvas.Component.Params.Remove(count);
        Assert.That(Names(canvas.Component).Skip(count), Is.EqualTo(new[] { "key2" }));
        // The name of a usual port is the user's: it stays the port of its key.
        canvas.Component.Params.Rename(canvas.Input("Layer Height"), "h");
        canvas.Feed("Layer Height", 0.35).Solve();
        Assert.That(canvas.One<PrintSettings>("Settings").LayerHeight, Is.EqualTo(0.35));
    }

    [Test]
    public void A_renamed_port_keeps_its_wire_and_its_id()
    {
        var canvas = new Canvas<PrintSettingsComponent>().Key("wall_count", 3);
        var before = canvas.Input("wall_count");
        canvas.Component.Params.Rename(before, "infill_density_percent");
        canvas.Document.RunSchedule();
        var after = canvas.Input("infill_density_percent");
        Assert.That((after.InstanceGuid, after.SourceCount, after.GetType()), Is.EqualTo((before.InstanceGuid, 1, typeof(Param_Number))));
        Assert.That(canvas.Solve().One<PrintSettings>("Settings").InfillDensityPercent, Is.EqualTo(3));
        canvas.Component.Params.Rename(after, "wall_count");
        canvas.Document.RunSchedule();
        Assert.That(canvas.Solve().One<PrintSettings>("Settings").WallCount, Is.EqualTo(3), "Undone, it is what it was.");
    }

    [Test]
    public void Added_ports_are_saved_opened_copied_and_undone()
    {
        Instances.ComponentServer.Load(typeof(PluginInfo).Assembly);
        var canvas = new Canvas<PrintSettingsComponent>().Key("wall_count", 5).Key("infill_pattern", "gyroid").Key("infill_density_percent", 12.5);
        canvas.AddKey("not_a_key");
        var settings = canvas.Solve().One<PrintSettings>("Settings");
        Assert.That(settings.WallCount, Is.EqualTo(5));
        var copy = Copied(canvas.Document);
        var component = copy.Objects.OfType<PrintSettingsComponent>().Single();
        Assert.That(Names(component), Is.EqualTo(Names(canvas.Component)));
        Assert.That(component.Params.Input.Select(p => p.GetType()), Is.EqualTo(canvas.Component.Params.Input.Select(p => p.GetType())));
        Assert.That(component.Params.Input.Select(p => p.Description), Is.EqualTo(canvas.Component.Params.Input.Select(p => p.Description)));
        copy.NewSolution(true);
        Assert.That(component.Params.Output[0].VolatileData.AllGoos().Single()!.ScriptVariable(), Is.EqualTo(settings));
        // An undo restores the state before, in the object itself.
        var before = new GH_LooseChunk("undo");
        canvas.Component.Write(before);
        canvas.Component.Params.Remove(6);
        canvas.Component.Params.Rename(canvas.Input("infill_density_percent"), "skirt_loops");
        canvas.Document.RunSchedule();
        Assert.That(canvas.Solve().One<PrintSettings>("Settings").WallCount, Is.Not.EqualTo(5));
        canvas.Component.Read(before);
        foreach (var port in canvas.Component.Params) port.RelinkProxySources(canvas.Document);
        canvas.Component.ExpireSolution(false);
        Assert.That(canvas.Solve().One<PrintSettings>("Settings"), Is.EqualTo(settings));
    }

    [Test]
    public void Ports_follow_the_choice_between_solutions_and_connected_ones_stay()
    {
        var canvas = new Canvas<LayerFieldComponent>();
        Assert.That(canvas.Component.Params.Input.Select(p => p.Name),
            Is.EqualTo(new[] { "Kind", "Sources", "Surfaces", "Blend From", "Blend To", "Origin", "Tolerance" }));
        canvas.Feed("Blend To", 3.0).Feed("Kind", "Cone").Solve();
        Assert.That(canvas.Component.Params.Input, Has.Count.EqualTo(7), "Not while solving.");
        Assert.That(canvas.Document.RunSchedule());
        Assert.That(canvas.Component.Params.Input.Select(p => p.Name), Is.EqualTo(new[] { "Kind", "Blend To", "Angle", "Origin" }));
        Assert.That(canvas.Document.RunSchedule(), Is.False, "They are as they should be.");
        canvas.Feed("Angle", 20.0).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.All("Field").Single(), Is.Not.Null);
        canvas.Feed("Kind", "Vertical", "Overhangs").Solve();
        canvas.Document.RunSchedule();
        Assert.That(canvas.Component.Params.Input.Select(p => p.Name), Has.Member("Surfaces").And.Member("Angle"), "Items may choose different ones.");
    }

    [Test]
    public void Ports_of_choices_are_saved_opened_and_keep_their_values()
    {
        Instances.ComponentServer.Load(typeof(PluginInfo).Assembly);
        var canvas = new Canvas<DeformComponent>().Feed("Print Paths", Line).Feed("System", "Cylindrical");
        var radius = (Param_String)canvas.Input("R");
        radius.SetPersistentData("2 * r");
        var path = canvas.Solve().One<PrintPath>("Print Paths");
        Assert.That(path.End.X, Is.EqualTo(20).Within(1e-9));
        var copy = Copied(canvas.Document);
        var component = copy.Objects.OfType<DeformComponent>().Single();
        Assert.That(component.Params.Input.Select(p => (p.Name, p.Description, p.Access, p.Optional)),
            Is.EqualTo(canvas.Component.Params.Input.Select(p => (p.Name, p.Description, p.Access, p.Optional))));
        Assert.That(((ChoiceParam)component.Params.Input.Single(p => p.Name == "System")).Choices, Has.Count.EqualTo(2));
        ((Param_GenericObject)component.Params.Input[0].Sources[0]).SetPersistentData(Line);
        copy.NewSolution(true);
        Assert.That(copy.RunSchedule(), Is.False, "The ports of the file fit the choice.");
        Assert.That(((PrintPath)component.Params.Output[0].VolatileData.AllGoos().Single()!.ScriptVariable()!).End.X, Is.EqualTo(20).Within(1e-9));
        canvas.Feed("System", "Cartesian");
        Chosen.Follow(canvas.Component);
        Assert.That(canvas.Component.Params.Input.Select(p => p.Name), Has.Member("X").And.None.EqualTo("R"));
        canvas.Feed("System", "Cylindrical");
        Chosen.Follow(canvas.Component);
        Assert.That(canvas.Input("R"), Is.SameAs(radius), "It comes back with its value.");
    }

    [Test]
    public void Every_choice_shows_its_ports_once_in_the_declared_order()
    {
        foreach (var type in PluginTypes.Components.Where(t => t.IsSubclassOf(typeof(Caterpillar.GH.Base.ChosenPortsComponent))))
        {
            var component = (Caterpillar.GH.Base.ChosenPortsComponent)PluginTypes.Make<GH_Component>(type);
            var order = component.Declared.Select(d => d.Param.Name).ToList();
            Assert.That(order, Is.Unique, type.Name);
            foreach (var choice in component.Params.Input.OfType<ChoiceParam>().ToArray())
            {
                foreach (var value in choice.Choices)
                {
                    choice.SetPersistentData(value.Value);
                    Chosen.Follow(component);
                    var shown = component.Params.Input.Select(p => order.IndexOf(p.Name)).ToArray();
                    Assert.That(shown, Is.Ordered.And.Unique.And.None.Negative, $"{type.Name} {value.Key}");
                }
            }
        }
    }

    [Test]
    public void Short_segments_are_joined_and_the_rest_stays()
    {
        var path = new PrintPath([new(0, 0), new(10, 0), new(10.1, 0), new(10.2, 0), new(20, 0)], new Bead(0.2, 0.2, 30));
        var canvas = new Canvas<MergePathsComponent>().Feed("Print Paths", path).Feed("Minimum Length", 0.5).Solve();
        var joined = canvas.One<PrintPath>("Print Paths");
        Assert.That(joined.Points.Select(p => p.X), Is.EqualTo(new[] { 0.0, 10, 10.2, 20 }));
        Assert.That(joined.Volume, Is.EqualTo(path.Volume).Within(1e-12));
        var ring = new PrintPath([new(0, 0), new(1, 0), new(1, 1)], [new Bead(0.2), new Bead(0.2), new Bead(0.2)], true);
        Assert.That(PathMerging.JoinShort(ring, 10), Is.SameAs(ring), "A ring stays a ring.");
        Assert.That(() => PathMerging.JoinShort(ring, double.NaN), Throws.ArgumentException);
    }

    private static GH_Document Copied(GH_Document document)
    {
        var archive = new GH_Archive();
        archive.AppendObject(document, "Definition");
        var read = new GH_Archive();
        read.Deserialize_Xml(archive.Serialize_Xml());
        var copy = new GH_Document();
        Assert.That(read.ExtractObject(copy, "Definition"), Is.True);
        return copy;
    }
}
