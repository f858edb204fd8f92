using Caterpillar.Drawings;
using Caterpillar.Geometry;
using Caterpillar.GH.Base;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel.Parameters;

namespace Caterpillar.GH.Components.Path;

/// <summary>Makes a path to deposit from any curve.</summary>
public sealed class ConstructPrintPathComponent() : CaterpillarComponent(
    "Construct Print Path", "PPath", "Makes a path to deposit along any curve, exactly as drawn; straight parts keep only their end points.", Panel.Path)
{
    public override Guid ComponentGuid => new("8afcdcac-2cb3-4ad3-ad72-aedf7b5930c7");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new Param_Curve(), "Curve", "C", "Curve to print along, in document units.");
        ports.Add(new BeadParam(), "Bead", "B", "Extrusion to deposit; 0.45 × 0.2 mm by default.", optional: true);
        ports.Choice("Role", "R", "What the path is for.", Role.Unspecified);
        ports.Number("Subdivision", "S", "Maximum length of the segments of curved parts, in mm.", 1);
        ports.Boolean("Keep Arc", "A", "True keeps horizontal arcs and circles as arcs.", false);
        ports.Integer("Layer", "L", "Number of the layer, from 0; -1 for none.", -1);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Path", "P", "The path.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var drawn = run.Get<Rg.Curve>(0);
        var units = run.Units;
        var (role, number) = (run.Choice<Role>(2), run.Get<int>(5));
        var bead = run.Maybe<BeadGoo>(1) is { IsValid: true } given ? given.Value : (Bead?)null;
        var options = new CurveOptions { Shape = BeadShape.Stadium,
            Subdivision = SubdivisionOptions.ByDistance(run.Positive(3)) with { KeepArcs = run.Get<bool>(4) } };
        var made = run.Cached([.. ModelMesh.Content(drawn), units.ToMillimeters, role, number, bead, options], () =>
        {
            var curve = RhinoCurves.ToCurve(drawn, units);
            var user = new UserCurve(curve) { Role = role, Layer = number >= 0 ? new Layer(number, curve.Bounds.Max.Z) : null };
            if (bead is { } b) user = user with { Area = b.Area, Height = b.Height, Speed = b.Speed };
            return CurvePaths.ToPaths([user], options);
        });
        run.Set(0, new PrintPathGoo(run.Require(made).Single()));
    }
}
