using System.Collections.Generic;
using System.Linq;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Components.Simulate;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>The stages that many definitions share: a setup at the begin, a plan, a look at it and a file at the end.</summary>
internal static class Stages
{
    /// <summary>Printer, material and settings as far as a definition has them.</summary>
    public sealed record Machine(object? Printer = null, object? Material = null, object? Settings = null);

    /// <summary>A printer chosen from a list, in a stage of its own.</summary>
    public static Machine Setup(this Sketch s, string printer = "generic")
    {
        s.Stage("Setup");
        var component = s.Component<PrinterComponent>(("Name", s.Choice("Printer", printer, "ender3", "generic", "klipper_256", "pen_plotter", "prusa_mk3s")));
        return new Machine(component);
    }

    /// <summary>A component with the setup at whichever of its ports take it.</summary>
    public static T With<T>(this Sketch s, Machine? machine, params (string Input, object Source)[] wires)
        where T : GH_Component, new()
    {
        var component = s.Component<T>(wires);
        foreach (var (name, source) in new[] { ("Printer", machine?.Printer), ("Material", machine?.Material), ("Settings", machine?.Settings) })
        {
            if (source is not null && component.Params.Input.Any(p => p.Name == name && p.SourceCount == 0)) s.Wire(component, name, source);
        }
        return component;
    }

    /// <summary>Plans steps, shows the result, and saves it.</summary>
    public static Sketch Print(this Sketch s, object steps, Machine? machine, string color = "Role")
    {
        s.Stage("Plan");
        return s.Finish(s.With<PlanToolpathComponent>(machine, ("Steps", steps)), color);
    }

    /// <summary>Shows a toolpath, and saves it.</summary>
    public static Sketch Finish(this Sketch s, GH_Component toolpath, string color = "Role", Machine? machine = null)
    {
        s.Stage("Look");
        s.Choose(s.Component<ToolpathPreviewComponent>(("Toolpath", toolpath)), "Color By", color);
        s.Figures(toolpath);
        return s.Write(toolpath, machine);
    }

    /// <summary>Time and material of a toolpath.</summary>
    public static void Figures(this Sketch s, GH_Component toolpath)
        => s.Show("Time and material", s.Component<StatisticsComponent>(("Toolpath", toolpath)), "Summary", 6, 300);

    /// <summary>Writes G-code, shows its first lines, and saves it when the button is pressed.</summary>
    public static Sketch Write(this Sketch s, GH_Component toolpath, Machine? machine = null)
    {
        s.Stage("Save");
        var write = s.With<GenerateGCodeComponent>(machine, ("Toolpath", toolpath));
        s.Show("First lines", s.Component<GCodeTextComponent>(("G-code", write), ("Count", s.Slider("Lines", 12, 1, 100, 0))), "Lines", 12, 250);
        var save = s.Component<SaveGCodeComponent>(("G-code", write), ("File", s.Text("File", "example.gcode", width: 140)), ("Save", s.Button("Save")),
            ("Overwrite", s.Toggle("Overwrite")));
        s.Show("Saved as", save, "Path", 2, 250);
        return s;
    }
}
