using System.CommandLine;
using Caterpillar.Drawings;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Cli.Commands;

/// <summary>Strand options for curves without settings of their own.</summary>
internal sealed class CurveSettingOptions
{
    private readonly Option<string?> _width = new("--width") { Description = "Width of the strand: mm, or percent of the nozzle.", HelpName = "MM|%" };

    private readonly Option<string?> _height = new("--height") { Description = "Height of the strand: mm, or percent of the layer height.", HelpName = "MM|%" };

    private readonly Option<string?> _multiplier = new("--multiplier") { Description = "Flow multiplier; 1 or 100% for the plain bead.",
        HelpName = "NUMBER|%" };

    private readonly Option<string?> _speed = new("--speed") { Description = "Print speed: mm/s, or percent of the speed in the settings.",
        HelpName = "MM/S|%" };

    private readonly Option<string?> _shape =
        new("--shape") { Description = "Cross-section of width and height: rectangle (the Caterpillar paper), stadium or circle.", HelpName = "SHAPE" };

    private readonly Option<bool> _strokes = new("--strokes") { Description = "Draw without extruding: pen, brush, bare hot tool." };

    private readonly Option<bool> _steps =
        new("--steps") { Description = "Values along a curve hold from their point to the next, instead of changing evenly." };

    private readonly Option<string?> _dots = new("--dots") { Description = "Every point becomes a dot of this volume; nothing is drawn between them.",
        HelpName = "MM3" };

    private readonly Option<string?> _dotSpeed = new("--dot-speed") { Description = "Speed of the filament for dots; 2 mm/s by default.", HelpName = "MM/S" };

    private readonly Option<string?> _unit = new("--unit") { Description = "Millimeters per unit of CSV, OBJ, and JSON without \"units\".", HelpName = "MM" };

    public void AddTo(Verb verb)
    {
        _shape.AcceptOnlyFromAmong("rectangle", "stadium", "circle");
        foreach (Option option in new Option[] { _width, _height, _multiplier, _speed, _shape, _strokes, _steps, _dots, _dotSpeed,
            _unit }) verb.Options.Add(option);
    }

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
            Multiplier = OptionValues.OptionalAmount(arguments.GetValue(_multiplier), "--multiplier", 1) ?? plain.Multiplier,
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
