using Caterpillar.Drawings;

namespace Caterpillar.Cli;

/// <summary>Extrusion options for curves without settings of their own.</summary>
internal sealed class CurveSettingOptions
{
    private readonly Described<string?> _width = new("--width", "Width of the extrusion: mm, or percent of the nozzle.", "MM|%");

    private readonly Described<string?> _height = new("--height", "Height of the extrusion: mm, or percent of the layer height.", "MM|%");

    private readonly Described<string?> _flow = new("--flow", "Flow multiplier; 1 or 100% for the plain bead.", "NUMBER|%");

    private readonly Described<string?> _speed = new("--speed", "Print speed: mm/s, or percent of the speed in the settings.", "MM/S|%");

    private readonly Described<string?> _shape = new("--shape",
        "Cross-section of width and height: rectangle (the Caterpillar paper), stadium or circle.", "SHAPE");

    private readonly Described<bool> _strokes = new("--pen", "Draw without extruding: pen, brush, bare hot tool.");

    private readonly Described<bool> _steps = new("--steps", "Values along a curve hold from their point to the next, instead of changing evenly.");

    private readonly Described<string?> _dots = new("--dots", "Every point becomes a dot of this volume; nothing is drawn between them.", "MM3");

    private readonly Described<string?> _dotSpeed = new("--dot-speed", "Speed of the filament for dots; 2 mm/s by default.", "MM/S");

    private readonly Described<string?> _unit = new("--unit", "Millimeters per unit of CSV, OBJ, and JSON without \"units\".", "MM");

    public CurveSettingOptions() => _shape.AcceptOnlyFromAmong("rectangle", "stadium", "circle");

    public Option[] All => [_width, _height, _flow, _speed, _shape, _strokes, _steps, _dots, _dotSpeed, _unit];

    public double UnitOf(ParseResult arguments)
    {
        var unit = OptionValues.OptionalNumber(arguments.GetValue(_unit), "--unit", 0) ?? 1;
        return unit > 0 ? unit : throw new CliException(ExitCode.Usage, "--unit must be above 0.");
    }

    public CurveOptions Of(ParseResult arguments, PrintSetup setup)
    {
        var plain = CurveOptions.From(setup.Settings);
        return plain with
        {
            Width = OptionValues.OptionalAmount(arguments.GetValue(_width), "--width", setup.Printer.NozzleDiameter) ?? plain.Width,
            Height = OptionValues.OptionalAmount(arguments.GetValue(_height), "--height", setup.Settings.LayerHeight) ?? plain.Height,
            Flow = OptionValues.OptionalAmount(arguments.GetValue(_flow), "--flow", 1) ?? plain.Flow,
            Speed = OptionValues.OptionalAmount(arguments.GetValue(_speed), "--speed", setup.Settings.PrintSpeed) ?? plain.Speed,
            Shape = arguments.GetValue(_shape) switch
            {
                "rectangle" => BeadShape.Rectangle,
                "stadium" => BeadShape.Stadium,
                "circle" => BeadShape.Circle,
                _ => plain.Shape,
            },
            Strokes = arguments.GetValue(_strokes),
            Steps = arguments.GetValue(_steps),
            Dots = OptionValues.OptionalNumber(arguments.GetValue(_dots), "--dots", 0) ?? 0,
            DotSpeed = OptionValues.OptionalNumber(arguments.GetValue(_dotSpeed), "--dot-speed", 1e-3) ?? plain.DotSpeed,
        };
    }
}
