using System.Linq;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Components.Simulate;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>The stages that many definitions share: a setup at the start, then a plan, a look at it, and a file.</summary>
internal static class Stages
{
    private static readonly string[] Printers = ["ender3", "generic", "klipper_256", "pen_plotter", "potter_super", "prusa_mk3s"];

    /// <summary>A setup with a printer chosen from a list.</summary>
    public static PrintSetupComponent Setup(this Sketch s, string printer = "generic", params (string Input, object Source)[] wires)
    {
        s.Stage("Setup");
        return s.Component<PrintSetupComponent>([("Printer", s.Choice("Printer", printer, Printers)), .. wires]);
    }

    /// <summary>A component that knows the setup.</summary>
    public static T With<T>(this Sketch s, PrintSetupComponent setup, params (string Input, object Source)[] wires)
        where T : GH_Component, new()
        => s.Component<T>([.. wires, ("Setup", setup)]);

    /// <summary>Plans steps, shows the result, and saves it.</summary>
    public static Sketch Print(this Sketch s, object steps, string color = "Role")
    {
        s.Stage("Plan");
        return s.Finish(s.Component<PlanToolpathComponent>(("Steps", steps)), color);
    }

    /// <summary>Shows a toolpath, and saves it.</summary>
    public static Sketch Finish(this Sketch s, GH_Component toolpath, string color = "Role")
    {
        s.Stage("Look");
        s.Component<ToolpathPreviewComponent>(("Toolpath", toolpath), ("Color By", new Pick(color)));
        s.Figures(toolpath);
        return s.Write(toolpath);
    }

    /// <summary>Time and material of a toolpath.</summary>
    public static void Figures(this Sketch s, GH_Component toolpath)
        => s.Show("Time and material", s.Component<StatisticsComponent>(("Toolpath", toolpath)), "Summary", 6, 300);

    /// <summary>Writes G-code, shows its first lines, and saves it when the button is pressed.</summary>
    public static Sketch Write(this Sketch s, GH_Component toolpath)
    {
        s.Stage("Save");
        var write = s.Component<GenerateGCodeComponent>(("Toolpath", toolpath));
        s.Show("First lines", s.Component<GCodeTextComponent>(("G-code", write), ("Count", s.Slider("Lines", 12, 1, 100, 0))), "Lines", 14, 270);
        return s.Save(write);
    }

    /// <summary>Saves when the button is pressed.</summary>
    public static Sketch Save(this Sketch s, GH_Component code)
    {
        s.Stage("Save");
        s.Component<SaveGCodeComponent>(("G-code", code), ("File", s.Text("File", "example.gcode", width: 140)), ("Save", s.Button("Save")),
            ("Overwrite", s.Toggle("Overwrite")));
        return s;
    }
}
