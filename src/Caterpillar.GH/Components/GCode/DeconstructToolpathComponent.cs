namespace Caterpillar.GH.Components.GCode;

/// <summary>Takes a toolpath apart, move by move.</summary>
public sealed class DeconstructToolpathComponent() : CaterpillarComponent(
    "Deconstruct Toolpath", "DeT",
        "Deconstructs a toolpath into its moves: end points, E, speeds, kinds, roles and sources, one branch per layer.", Panel.GCode, GH_Exposure.tertiary)
{
    public override Guid ComponentGuid => new("6d012a42-e489-4a36-80c4-6b3d1c1cde28");

    private protected override void Inputs(InputPorts ports) => ports.Toolpath();

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Point("Points", "P", "End point of each move. A move without a layer is in the branch of the layer before it. Arcs are straight moves.",
            GH_ParamAccess.tree);
        ports.Number("E Values", "E", "Change of E in each move, in mm of filament (or mm³ for volumetric E).", GH_ParamAccess.tree);
        ports.Number("Speeds", "V", "Speed of each move, in mm/s.", GH_ParamAccess.tree);
        ports.Text("Kinds", "K", "Kind of each move: Print, Travel, Wipe, Retract, Deretract, MovingDeretract, Prime or Dwell.", GH_ParamAccess.tree);
        ports.Text("Roles", "R", "Role of each move, such as OuterWall or Infill.", GH_ParamAccess.tree);
        ports.Integer("Sources", "S", "Line number in the file, from 1, or number of the step in the design, from 0. -1 = none.", GH_ParamAccess.tree);
        ports.Number("Areas", "A", "Area of the cross-section of each move, in mm². 0 = no extrusion, or unknown filament diameter.", GH_ParamAccess.tree);
        ports.Number("Widths", "W", "Line width of each move, in mm, for a stadium of the height of its layer. 0 = no extrusion.", GH_ParamAccess.tree);
        ports.Add(new Param_Curve { Hidden = true }, "Extrusions", "C", "Extrusions as curves, one for each run without a travel move.", GH_ParamAccess.tree);
    }

    private protected override void Solve(Run run)
    {
        var toolpath = run.Get<Toolpath>(0);
        var (units, root) = (run.Units, run.PathOf(0));
        var parts = run.Work("Deconstructing", [toolpath, units.ToMillimeters, root.ToString()], (_, _) => new ToolpathParts(toolpath, units, root));
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
