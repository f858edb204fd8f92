namespace Caterpillar.Cli;

/// <summary>User curves as infill: <c>--infill-curves web.svg</c>.</summary>
internal sealed class InfillCurveOptions
{
    private const double Tolerance = 0.01;

    private readonly Described<string?> _file = new("--infill-curves",
        "Infill of each layer from curves (CSV, JSON, OBJ, SVG), clipped to its walls. Coordinates: X and Y of the model files.", "FILE");

    public Option[] All => [_file];

    /// <summary>The setup, with the pattern for curves if any are given.</summary>
    public PrintSetup Resolve(ParseResult arguments, PrintSetup setup)
        => arguments.GetValue(_file) is null ? setup : setup with { Settings = setup.Settings with { InfillPattern = InfillPattern.Curves } };

    /// <summary>The curves of the file, or null if none is given.</summary>
    public IReadOnlyList<Polyline>? Read(ParseResult arguments, PrintSetup setup, Session session)
    {
        if (arguments.GetValue(_file) is not { } file) return null;
        var curves = Curves.Read(file, session);
        var options = CurveOptions.From(setup.Settings) with { Subdivision = SubdivisionOptions.ByTolerance(Tolerance), Memory = session.Memory };
        var paths = session.ValueOrFail(CurvePaths.ToPaths(curves, options, null, session.Cancel));
        return paths.Select(p => new Polyline(p.Points.Select(v => v.WithZ(0)), p.IsClosed)).ToArray();
    }

    /// <summary>A model with curves that are transformed with it.</summary>
    /// <exception cref="CliException">It is tilted.</exception>
    public static SliceModel With(SliceModel model, IReadOnlyList<Polyline>? curves)
    {
        if (curves is null || model.Settings.InfillPattern != InfillPattern.Curves) return model;
        var map = model.Mesh.Placed;
        if (!map.IsUpright) throw CliException.Usage("--infill-curves cannot be rotated about X and Y with the model.");
        var points = InfillPoint.Of(curves.Select(c => new Polyline(c.Points.Select(v => map.Apply(v)), c.IsClosed)));
        return new SliceModel(model.Mesh, model.Settings with { InfillCurves = points });
    }
}
