namespace Caterpillar.Cli;

/// <summary>Extrusion options for curves without settings of their own.</summary>
internal sealed class CurveSettingOptions
{
    private readonly Described<string?> _width = new("--width", "Extrusion width, in mm or % of the nozzle diameter.", "MM|%");

    private readonly Described<string?> _height = new("--height", "Extrusion height, in mm or % of the layer height.", "MM|%");

    private readonly Described<string?> _flow = new("--flow", "Flow ratio; 1 or 100% = unchanged.", "RATIO|%");

    private readonly Described<string?> _speed = new("--speed", "Printing speed, in mm/s or % of print_speed_mm_s.", "MM/S|%");

    private readonly Described<string?> _shape = new("--shape",
        "Cross-section of extrusions; rectangle = as in the Caterpillar paper. Default: bead_shape.", "rectangle|stadium|circle");

    private readonly Described<bool> _strokes = new("--pen", "Draw without extrusion: pen, brush or bare hot tool.");

    private readonly Described<bool> _steps = new("--steps", "Keep the values of each point up to the next one, instead of changing them evenly.");

    private readonly Described<string?> _dots = new("--dots", "Print each point as a dot of this volume, without lines between them.", "MM3");

    private readonly Described<string?> _dotSpeed = new("--dot-speed", "Filament speed for dots. Default: 2 mm/s.", "MM/S");

    private readonly Described<string?> _unit = new("--unit",
        "Length of one unit in CSV, OBJ, and JSON without \"units\", in mm or by name: um, cm, m, in, ft. Default: mm.", "MM|NAME");

    public CurveSettingOptions() => _shape.AcceptOnlyFromAmong("rectangle", "stadium", "circle");

    public Option[] All => [_width, _height, _flow, _speed, _shape, _strokes, _steps, _dots, _dotSpeed, _unit];

    public double UnitOf(ParseResult arguments) => Numbers.Unit(arguments.GetValue(_unit));

    public CurveOptions Of(ParseResult arguments, PrintSetup setup)
    {
        var plain = CurveOptions.For(setup);
        return plain with
        {
            Width = Numbers.MaybeAmount(arguments.GetValue(_width), "--width", setup.Printer.NozzleDiameter) ?? plain.Width,
            Height = Numbers.MaybeAmount(arguments.GetValue(_height), "--height", setup.Settings.LayerHeight) ?? plain.Height,
            Flow = Numbers.MaybeAmount(arguments.GetValue(_flow), "--flow", 1) ?? plain.Flow,
            Speed = Numbers.MaybeAmount(arguments.GetValue(_speed), "--speed", setup.Settings.PrintSpeed) ?? plain.Speed,
            Shape = arguments.GetValue(_shape) is { } shape ? Enum.Parse<BeadShape>(shape, true) : plain.Shape,
            Strokes = arguments.GetValue(_strokes),
            Steps = arguments.GetValue(_steps),
            Dots = Numbers.MaybeAtLeast(arguments.GetValue(_dots), "--dots", 0) ?? 0,
            DotSpeed = Numbers.MaybeAtLeast(arguments.GetValue(_dotSpeed), "--dot-speed", 1e-3) ?? plain.DotSpeed,
        };
    }
}
