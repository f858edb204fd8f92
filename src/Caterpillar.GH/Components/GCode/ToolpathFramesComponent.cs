namespace Caterpillar.GH.Components.GCode;

/// <summary>Gives the planes of a toolpath for robots.</summary>
public sealed class ToolpathFramesComponent() : CaterpillarComponent(
    "Toolpath Frames", "Frames", "Gives a plane, the speed and the flow of every move, one branch per layer, for plug-ins that program robots. Arcs are "
        + "straight moves.", Panel.GCode, GH_Exposure.tertiary)
{
    public override Guid ComponentGuid => new("7c2e9f04-6a3d-4d85-b1f7-58e0a9d3c642");

    private protected override void Inputs(InputPorts ports) => ports.Toolpath();

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new Param_Plane(), "Planes", "Pl", "Plane at the end of each move: its origin is the nozzle tip, X points along the motion, and Z from the "
            + "tip along the tool.", GH_ParamAccess.tree);
        ports.Number("Speeds", "V", "Speed of each move, in mm/s.", GH_ParamAccess.tree);
        ports.Number("Flows", "F", "Flow of each move, in mm³/s. 0 = no extrusion, or unknown filament diameter.", GH_ParamAccess.tree);
        ports.Text("Kinds", "K", "Kind of each move, such as Print or Travel.", GH_ParamAccess.tree);
    }

    private protected override void Solve(Run run)
    {
        var toolpath = run.Get<Toolpath>(0);
        var (units, root) = (run.Units, run.PathOf(0));
        var frames = run.Work("Framing", [toolpath, units.ToMillimeters, root.ToString()],
            (_, cancel) => new ToolpathFrames(toolpath, units, root, cancel));
        run.SetTree(0, frames.Planes);
        run.SetTree(1, frames.Speeds);
        run.SetTree(2, frames.Flows);
        run.SetTree(3, frames.Kinds);
    }
}
