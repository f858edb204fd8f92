using Caterpillar.Drawings;

namespace Caterpillar.GH.Components.Path;

/// <summary>Makes a path to deposit from any curve.</summary>
public sealed class ConstructPrintPathComponent() : CaterpillarComponent(
    "Construct Print Path", "PPath", "Creates a print path along any curve, exactly as drawn. Straight parts keep only their end points.", Panel.Path)
{
    public override Guid ComponentGuid => new("8afcdcac-2cb3-4ad3-ad72-aedf7b5930c7");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new Param_Curve(), "Curve", "C", "Curve to print.");
        ports.Bead();
        ports.Choice("Role", "R", "Role of the path.", Role.Unspecified);
        ports.Subdivision("S");
        ports.Boolean("Keep Arc", "A", "Keep horizontal arcs and circles as arcs.", false);
        ports.Integer("Layer", "L", "Layer number, from 0. -1 = no layer.", -1);
        ports.Setup("Used for the default bead. Default: generic.");
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Path", "P", "Print path.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var drawn = run.Get<Rg.Curve>(0);
        var units = run.Units;
        var (role, number) = (run.Choice<Role>(2), run.Get<int>(5));
        var (bead, setup) = SetupPort.Bead(run, 1, 6);
        var options = new CurveOptions { Subdivision = SubdivisionOptions.ByDistance(run.Positive(3)) with { KeepArcs = run.Get<bool>(4) } };
        var made = run.Cached([.. ModelMesh.Content(drawn), units.ToMillimeters, role, number, bead, options], () =>
        {
            var curve = RhinoCurves.ToCurve(drawn, units);
            var layer = number >= 0 ? new Layer(number, curve.Bounds.Max.Z) : null;
            var user = new UserCurve(curve) { Role = role, Layer = layer, Area = bead.Area, Height = bead.Height, Speed = bead.Speed };
            return CurvePaths.ToPaths([user], options);
        });
        run.Set(0, new PrintPathGoo(run.Require(made).Single(), setup));
    }
}
