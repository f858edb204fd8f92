namespace Caterpillar.GH.Components.GCode;

/// <summary>Makes a toolpath of moves.</summary>
public sealed class ConstructToolpathComponent() : CaterpillarComponent(
    "Construct Toolpath", "ConT", "Creates a toolpath from its moves, as Deconstruct Toolpath gives them: one branch per layer. Nothing is added.", Panel.GCode,
    GH_Exposure.tertiary)
{
    public override Guid ComponentGuid => new("a1f4d7e3-2b90-4c68-9e5d-6c37b8f0a214");

    private protected override void Inputs(InputPorts ports)
    {
        const string Each = " One for all moves, or one for each point.";
        Tree(new Param_Point(), "Points", "P", "End point of each move. The last index of a branch is the number of its layer.");
        Tree(new Param_Number(), "E Values", "E", "Change of E in each move, in mm of filament (or mm³ for volumetric E)." + Each);
        Tree(new Param_Number(), "Speeds", "V", "Speed of each move, in mm/s." + Each);
        Tree(new Param_String(), "Kinds", "K", "Kind of each move, such as Print, Travel or Retract." + Each + " Default: from E and the points.", true);
        Tree(new Param_String(), "Roles", "R", "Role of each move, such as OuterWall." + Each + " Default: none.", true);
        ports.Setup("Filament diameter and E unit must match the moves. Default: generic.");

        void Tree(IGH_Param param, string name, string nick, string description, bool optional = false)
            => ports.Add(param, name, nick, description, GH_ParamAccess.tree, optional);
    }

    private protected override void Outputs(OutputPorts ports) => ports.Add(new ToolpathParam(), "Toolpath", "T", "Toolpath of the points, in their order.");

    private protected override void Solve(Run run)
    {
        var points = run.Tree<GH_Point>(0);
        if (points.Paths.Select(p => string.Join(";", p.Indices.Take(p.Length - 1))).Distinct().Count() > 1)
            throw new InputProblem("Points are those of several toolpaths. Use a Construct Toolpath for each.");
        var (amounts, speeds) = (run.Tree<GH_Number>(1), run.Tree<GH_Number>(2));
        var (kinds, roles) = (run.MaybeTree<GH_String>(3), run.MaybeTree<GH_String>(4));
        var setup = SetupPort.Of(run, 5);
        var units = run.Units;
        var moves = new MoveTrees(points, amounts, speeds, kinds, roles);
        // Grasshopper clears trees after the solution.
        var made = run.Wait("Constructing", (_, cancel) => moves.Build(setup, units, cancel));
        if (moves.Dwells > 0)
        {
            run.Report(GH_RuntimeMessageLevel.Warning,
                $"{NumberFormatter.Format(moves.Dwells)} dwells are left out: their durations are events. Add them with Insert At Layer.");
        }
        run.Set(0, new ToolpathGoo(made, setup));
        run.Summarize($"{NumberFormatter.Format(made.Count)} moves");
    }
}
