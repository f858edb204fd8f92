using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Goos;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Parameters;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Tests.Host;

/// <summary>For each component a set of inputs with which it solves without an error; for tests that go through all of them.</summary>
internal static class Recipes
{
    private static readonly PrintPath Path = new([new Vec3(50, 50, 0.2), new Vec3(80, 50, 0.2), new Vec3(80, 70, 0.2)], new Bead(0.08, 0.2, 40));

    private static readonly Lazy<ToolpathGoo> Planned = new(() => new ToolpathGoo(
        Planner.Plan([Path with { Layer = new Layer(0, 0.2, 0.2) }], new PrintSetup()).Value!, new PrintSetup()));

    private static readonly Lazy<string> Header = new(() =>
    {
        var file = System.IO.Path.Combine(System.IO.Path.GetTempPath(), "caterpillar-header.gcode");
        System.IO.File.WriteAllText(file, "M104 S200\nG28\nM83\n");
        return file;
    });

    private static readonly Lazy<string> CurveFile = new(() =>
    {
        var file = System.IO.Path.Combine(System.IO.Path.GetTempPath(), "caterpillar-curves.csv");
        System.IO.File.WriteAllText(file, "x,y,z\n10,10,0.2\n30,10,0.2\n30,30,0.2\n");
        return file;
    });

    /// <summary>Values by the name of the port, the type of the component first where names are ambiguous.</summary>
    private static readonly Dictionary<string, Func<object?[]>> Values = new(StringComparer.Ordinal)
    {
        ["Axiom"] = () => ["F"],
        ["Rules"] = () => ["F -> F+F"],
        ["Generations"] = () => [2],
        ["Radius"] = () => [10.0],
        ["Bottom Radius"] = () => [10.0],
        ["Top Radius"] = () => [8.0],
        ["Height"] = () => [1.0],
        ["Pitch"] = () => [0.5],
        ["Vertical Pitch"] = () => [0.5],
        ["Horizontal Pitch"] = () => [0.5],
        ["Program"] = () => ["forward 10"],
        ["Script"] = () => ["forward 10"],
        ["Steps"] = () => [new StepGoo(Path)],
        ["Commands"] = () => [TurtleCommand.Of(TurtleAction.Forward, 1)],
        ["Toolpath"] = () => [Planned.Value],
        ["Toolpaths"] = () => [Planned.Value],
        ["G-code"] = () => ["M83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 Y10 E0.5 F1200\n"],
        ["File"] = () => [System.IO.Path.Combine(System.IO.Path.GetTempPath(), "caterpillar-never-written.gcode")],
        ["Layers"] = () => [0],
        ["Points"] = () => [new Rg.Point3d(10, 10, 0.2)],
        ["E Values"] = () => [1.0],
        ["Speeds"] = () => [20.0],
        ["ViewerPageComponent.File"] = () => [System.IO.Path.Combine(System.IO.Path.GetTempPath(), "caterpillar-never-written.html")],
        ["TiltToolComponent.Toolpath"] = () => [new ToolpathGoo(Planned.Value.Value, new ProfileLibrary().Setup("five_axis_head").OrThrow())],
        ["DeconstructSetupComponent.Setup"] = () => ["generic"],
        ["Curve"] = () => [new Rg.LineCurve(new Rg.Point3d(0, 0, 0), new Rg.Point3d(10, 0, 0))],
        ["ImportProfileComponent.File"] = () => [Header.Value],
        ["Print Path"] = () => [Path],
        ["Print Paths"] = () => [Path],
        ["Geometry"] = () => [Shapes.Box()],
        ["ProjectPathsComponent.Geometry"] = () => [Shapes.Box(40, 40, 60)],
        ["Field"] = () => ["z"],
        ["LayerFieldComponent.Expressions"] = () => ["1 + x / 20"],
        ["ReadModelComponent.File"] = () => [System.IO.Path.Combine(Caterpillar.Tests.TestData.Repository, "examples", "models", "bracket.stl")],
        ["ReadCurvesComponent.File"] = () => [CurveFile.Value],
        ["ModulateComponent.Expression"] = () => ["0.5"],
    };

    /// <summary>The component in a definition, with all its required inputs connected.</summary>
    public static GH_Component Make(Type type, GH_Document document)
    {
        var component = (GH_Component)Activator.CreateInstance(type)!;
        document.AddObject(component, false);
        foreach (var port in component.Params.Input)
        {
            var key = type.Name + "." + port.Name;
            var known = Values.TryGetValue(key, out var make) || (!CanDoWithout(component, port) && Values.TryGetValue(port.Name, out make));
            if (known) Connect(document, port, make!());
            else if (!CanDoWithout(component, port)) throw new InvalidOperationException($"Add a value for {key} to Recipes.");
        }
        if (type == typeof(Caterpillar.GH.Components.Design.TurtleProgramComponent)) Connect(document, component.Params.Input[0], Values["Script"]());
        if (type == typeof(DecodeGCodeComponent)) Connect(document, component.Params.Input[1], Values["G-code"]());
        return component;
    }

    /// <summary>Feeds a port through a wire.</summary>
    public static void Connect(GH_Document document, IGH_Param port, params object?[] items)
    {
        port.RemoveAllSources();
        Add(document, port, items);
    }

    /// <summary>Adds another wire to a port.</summary>
    public static void Add(GH_Document document, IGH_Param port, params object?[] items)
    {
        var source = new Param_GenericObject { NickName = port.Name };
        var path = new GH_Path(0);
        source.PersistentData.EnsurePath(path);
        foreach (var item in items) source.PersistentData.Append(item is null ? null! : Casting.Wrap(item), path);
        document.AddObject(source, false);
        port.AddSource(source);
    }

    /// <summary>True for a port that has a default or is optional.</summary>
    public static bool CanDoWithout(GH_Component component, IGH_Param port)
        => !((Caterpillar.GH.Base.CaterpillarComponent)component).IsRequired(component.Params.Input.IndexOf(port));

    public static string[] Errors(GH_Component component) => component.RuntimeMessages(GH_RuntimeMessageLevel.Error).ToArray();
}
