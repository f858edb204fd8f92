namespace Caterpillar.Cli;

/// <summary>The option for infill lines that follow directions of the surface.</summary>
internal sealed class InfillAlong
{
    private readonly Described<string?> _along = new("--infill-along",
        "With --surface: direction of infill lines. curvature: along the strongest principal curvature of the surface. across: along the other one. both: "
            + "along both. DX;DY: two formulas in x and y, such as \"-y; x\". FILE: along curves (CSV, JSON, SVG, OBJ lines). infill_density_percent sets "
            + "their distance.",
        "curvature|across|both|DX;DY|FILE");

    public Option[] All => [_along];

    public bool IsGiven(ParseResult arguments) => arguments.GetValue(_along) is not null;

    /// <summary>The lines over the models, or null without the option.</summary>
    public IReadOnlyList<Polyline>? Lines(
        ParseResult arguments, PlanSurface surface, IReadOnlyList<NamedMesh> models, PrintSetup setup, Session session)
    {
        if (arguments.GetValue(_along) is not { } text) return null;
        var percent = setup.Settings.InfillDensityPercent;
        if (percent is <= 0 or >= 100)
        {
            session.Print([new Diagnostic(Severity.Warning, "curved.no_infill_lines",
                $"--infill-along has no effect: infill_density_percent is {NumberFormatter.Format(percent, 2)}. Set it above 0 and below 100.")]);
            return null;
        }
        var spacing = setup.Settings.LineWidth * 100 / percent;
        var plan = Bounds.Of(models.SelectMany(m => new[] { m.Mesh.Bounds.Min, m.Mesh.Bounds.Max }));
        var placed = models[0].Placed;
        var back = placed.Inverse;
        switch (text.Trim())
        {
            case "curvature": return SurfaceLines.AlongCurvature(surface, plan, spacing, false, session.Cancel);
            case "across": return SurfaceLines.AlongCurvature(surface, plan, spacing, true, session.Cancel);
            case "both":
                return [.. SurfaceLines.AlongCurvature(surface, plan, 2 * spacing, false, session.Cancel),
                    .. SurfaceLines.AlongCurvature(surface, plan, 2 * spacing, true, session.Cancel)];
        }
        if (text.Split(';') is [var x, var y])
        {
            var source = new SourceLocation(Key: "--infill-along");
            var byX = session.ValueOrFail(PlanSurface.Formula(x, source), ExitCode.Usage);
            var byY = session.ValueOrFail(PlanSurface.Formula(y, source), ExitCode.Usage);
            Vec3 Direction(Vec3 d) => new(byX.Height(d.X, d.Y), byY.Height(d.X, d.Y));
            return SurfaceLines.Along(surface, plan, p => placed.ApplyDirection(Direction(back.Apply(p))), spacing, session.Cancel);
        }
        if (!File.Exists(text))
            throw CliException.Usage($"--infill-along {text}: expected curvature, across, both, two formulas \"DX; DY\", or a file of curves.");
        var curves = Curves.ReadPolylines(text, placed, session);
        return SurfaceLines.AlongCurves(surface, plan, curves.Where(c => c.Count > 1).ToArray(), spacing, session.Cancel);
    }
}
