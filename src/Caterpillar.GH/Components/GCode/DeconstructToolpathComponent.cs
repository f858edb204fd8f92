using Caterpillar.GH.Base;
using Caterpillar.GH.Params;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;

namespace Caterpillar.GH.Components.GCode;

/// <summary>Takes a toolpath apart, move by move.</summary>
public sealed class DeconstructToolpathComponent() : CaterpillarComponent(
    "Deconstruct Toolpath", "DeTP", "Takes a toolpath apart: for each move its end, material, speed, kind, role and source, one branch per layer.", Panel.GCode)
{
    public override Guid ComponentGuid => new("6d012a42-e489-4a36-80c4-6b3d1c1cde28");

    private protected override void Inputs(InputPorts ports) => ports.Add(new ToolpathParam(), "Toolpath", "T", "Toolpath to take apart.");

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Point("Points", "P", "End of each move, in document units. A move without a layer is listed with the layer before it.", GH_ParamAccess.tree);
        ports.Number("Amounts", "E", "Change of E of each move, in mm of filament (or mm³ if the machine counts volume).", GH_ParamAccess.tree);
        ports.Number("Speeds", "V", "Speed of each move, in mm/s.", GH_ParamAccess.tree);
        ports.Text("Kinds", "K", "What the move does: Print, Travel, Wipe, Retract, Restore, Moving Restore, Prime or Dwell.", GH_ParamAccess.tree);
        ports.Text("Roles", "R", "What each extrusion is for, such as OuterWall or Infill.", GH_ParamAccess.tree);
        ports.Integer("Sources", "S", "Line number in the file, from 1, or number of the step of the design, from 0; -1 if there is none.",
            GH_ParamAccess.tree);
        ports.Number("Areas", "A", "Cross-section of each extrusion in mm²; 0 for moves that print nothing, or if the filament diameter is unknown.",
            GH_ParamAccess.tree);
        ports.Number("Widths", "W", "Width of each extrusion in mm, with round sides and the height of its layer; 0 if there is none.", GH_ParamAccess.tree);
        ports.Add(new Param_Curve { Hidden = true }, "Extrusions", "C", "What is printed as curves, in document units: one for each run without a travel.",
            GH_ParamAccess.tree);
    }

    private protected override void Solve(Run run)
    {
        var toolpath = run.Get<Toolpath>(0);
        var (units, root) = (run.Units, run.PathOf(0));
        var parts = run.Work("Taking apart", [toolpath, units.ToMillimeters, root.ToString()], (_, _) => new ToolpathParts(toolpath, units, root));
        run.SetTree(0, parts.Points);
        run.SetTree(1, parts.Amounts);
        run.SetTree(2, parts.Speeds);
        run.SetTree(3, parts.Kinds);
        run.SetTree(4, parts.Roles);
        run.SetTree(5, parts.Sources);
        run.SetTree(6, parts.Areas);
        run.SetTree(7, parts.Widths);
        run.SetTree(8, parts.Extrusions);
    }
}
