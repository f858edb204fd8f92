namespace Caterpillar.GH.Components.Path;

/// <summary>Where the curves of print paths lie.</summary>
public enum CurveBase
{
    Bed,
    AsDrawn,
}

/// <summary>Makes a path to deposit from any curve.</summary>
public sealed class ConstructPrintPathComponent() : CaterpillarComponent(
    "Construct Print Path", "PPath", "Creates a print path along any curve, exactly as drawn. Straight parts keep only their end points.", Panel.Path)
{
    private const int MostLayers = 100_000;

    public override Guid ComponentGuid => new("8afcdcac-2cb3-4ad3-ad72-aedf7b5930c7");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new Param_Curve(), "Curve", "C", "Curve to print.");
        ports.Bead();
        ports.Choice("Role", "R", "Role of the path.", Role.Unspecified);
        ports.Subdivision("S");
        ports.Boolean("Keep Arc", "A", "Keep horizontal arcs and circles as arcs.", false);
        ports.Integer("Layer", "L", "Layer number, from 0. -1 = no layer.", -1);
        ports.Setup("Used for the default bead and the height of the first layer. Default: generic.");
        ports.Choice("Base", "Ba", "A curve that is flat at Z 0 is printed at the height of the first layer (Bed), or like all others as drawn.",
            CurveBase.Bed);
        ports.Integer("Layer Count", "N", "Number of layers to stack of a curve that is flat at Z 0, counted from 0. 0 = one path.", 0);
        VertexNumbers.Declare(ports);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Path", "P", "Print path. With a Layer Count, the first layer.");
        ports.Diagnostics();
        ports.Add(new PrintPathParam { Hidden = true }, "Layers", "Ls", "All layers from below, one branch per curve. Plan Toolpath prints the curves layer by "
            + "layer. Empty without a Layer Count.", GH_ParamAccess.list);
    }

    private protected override void Solve(Run run)
    {
        var drawn = run.Get<Rg.Curve>(0);
        var units = run.Units;
        var (role, number) = (run.Choice<Role>(2), run.Get<int>(5));
        var bead = run.Maybe<BeadGoo>(1) is { IsValid: true } goo ? goo.Value : (Bead?)null;
        var numbers = new VertexNumbers(run);
        var (connected, setup) = (run.Maybe<PrintSetup>(6), SetupPort.Of(run, 6));
        var options = Options(run, bead, connected, setup);
        var made = run.Cached([.. ModelMesh.Content(drawn), units.ToMillimeters, role, number, bead, options, .. numbers.Key], () =>
        {
            var curve = RhinoCurves.ToCurve(drawn, units);
            var layer = number >= 0 ? new Layer(number, curve.Bounds.Max.Z) : null;
            var user = numbers.On(Of(new UserCurve(curve) { Role = role, Layer = layer }, bead, numbers, setup.Settings.BeadShape));
            return CurvePaths.ToPaths([user], options with { Steps = numbers.IsStepped });
        });
        var paths = run.Require(made);
        // What depends on nothing of a setup does not remember one.
        var used = bead is null ? setup : connected;
        var layers = options.Layers == 0 ? [] : paths.Select(p => new PrintPathGoo(new PathStep(p, new StepGroup(p.Layer!.Index)), used)).ToArray();
        run.Set(0, layers.FirstOrDefault() ?? new PrintPathGoo(paths.Single(), used));
        run.SetList(2, layers);
    }

    private static CurveOptions Options(Run run, Bead? bead, PrintSetup? connected, PrintSetup setup)
    {
        var layers = run.Get<int>(8);
        if (layers is < 0 or > MostLayers) throw new InputProblem($"Layer Count must be from 0 to {NumberFormatter.Format(MostLayers)}.");
        var division = SubdivisionOptions.ByDistance(run.Positive(3)) with { KeepArcs = run.Get<bool>(4) };
        var options = CurveOptions.For(setup) with { Subdivision = division, Layers = layers };
        if (run.Choice<CurveBase>(7) == CurveBase.AsDrawn)
            return layers == 0 ? options with { FlatHeight = 0 } : throw new InputProblem("Layer Count needs Base at Bed: the layers start on the bed.");
        if (bead is not { Height: > 0 and var height }) return options;
        return options with { Height = height, FlatHeight = connected is null ? height : options.FlatHeight };
    }

    private static UserCurve Of(UserCurve curve, Bead? given, VertexNumbers numbers, BeadShape shape)
    {
        if (given is not { } bead) return curve;
        curve = curve with { Speed = bead.Speed, Height = bead.Height > 0 || !numbers.SetsArea ? bead.Height : null };
        return numbers.SetsArea ? curve with { Width = bead.Width(shape) } : curve with { Area = bead.Area };
    }
}
