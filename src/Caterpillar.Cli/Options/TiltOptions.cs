namespace Caterpillar.Cli;

/// <summary>Options for machines that tilt their tool.</summary>
internal sealed class TiltOptions
{
    private readonly Described<string?> _tilt = new("--tilt",
        "Lean the tool of a printer with rotary_axes. normal: along the normals of curved layers. DX;DY;DZ: formulas in x, y and z for the direction from the "
            + "tip to the head. toward, from: to a point or to curves (CSV, JSON, SVG, OBJ lines), or away from them.",
        "normal|DX;DY;DZ|toward=X,Y,Z|toward=FILE|from=…");

    private readonly Described<double?> _most = new("--max-tilt", "With --tilt: maximum lean from vertical. Default: what the axes allow, up to 90.", "DEG");

    public Option[] All => [_tilt, _most];

    /// <summary>Finds wrong usage before files are read.</summary>
    /// <param name="arguments">The command line.</param>
    /// <param name="hasField">There are curved layers.</param>
    /// <exception cref="CliException">Options cannot be combined.</exception>
    public void Check(ParseResult arguments, bool hasField)
    {
        var text = arguments.GetValue(_tilt);
        if (arguments.GetValue(_most) is { } most && (text is null || most is not (> 0 and <= 180)))
            throw CliException.Usage("--max-tilt needs --tilt and 0 to 180 degrees.");
        if (text?.Trim() == "normal" && !hasField) throw CliException.Usage("--tilt normal needs --surface, --field or --deform.");
    }

    /// <summary>Where the tool points; null = upright.</summary>
    /// <param name="arguments">The command line.</param>
    /// <param name="placed">Transform of the models from the positions in their files.</param>
    /// <param name="setup">The printer.</param>
    /// <param name="session">Reads files.</param>
    public ToolAim? Read(ParseResult arguments, Affine placed, PrintSetup setup, Session session)
    {
        if (arguments.GetValue(_tilt)?.Trim() is not { } text) return null;
        if (setup.Printer.Kinematics is not { Tilts: true })
            throw CliException.Usage($"--tilt: {setup.Printer.Title} has no axis that tilts its tool. Give rotary_axes of the printer.");
        var aim = Aim(text, placed, session);
        return aim with { MaxTilt = arguments.GetValue(_most) ?? aim.MaxTilt };
    }

    private static ToolAim Aim(string text, Affine placed, Session session)
    {
        if (text == "normal") return new ToolAim();
        if (text.Split(';') is { Length: 3 } formulas)
            return session.ValueOrFail(ToolAim.Formulas(formulas, placed, new SourceLocation(Key: "--tilt")), ExitCode.Usage);
        if (text.Split('=', 2) is not [("toward" or "from") and var word, var place])
            throw CliException.Usage("--tilt needs normal, three formulas \"DX; DY; DZ\", "
                + "toward=X,Y,Z, from=X,Y,Z, or a file of curves in place of the point.");
        var numbers = place.Split(',').Select(t => NumberReader.TryParse(t, out var number) ? number : double.NaN).ToArray();
        var curves = numbers is [var x, var y, var z] && double.IsFinite(x + y + z) ? [new Polyline([placed.Apply(new Vec3(x, y, z))])]
            : Curves.ReadPolylines(place, placed, session);
        return ToolAim.Toward(curves, word == "from");
    }
}
