using Caterpillar.Display;
using Caterpillar.Files;
using Caterpillar.GCode;

namespace Caterpillar.Cli;

/// <summary>Draws what a G-code file prints.</summary>
internal sealed class ImageVerb : Verb
{
    private readonly Argument<string> _file = new("FILE") { Description = "G-code, also binary (.bgcode) or packed with gzip; - is standard input." };

    private readonly Described<string?> _out = new("--output",
        "ToolpathImage (PNG); - is standard output. By default the name of the input with .png, in the current folder.", "FILE.png", "-o");

    private readonly Described<int?> _layer = new("--layer", "Draw only this layer, by its number in the file, or counted from 0.", "N");

    private readonly Described<int?> _upTo = new("--to-layer", "Draw only the layers up to this one.", "N");

    private readonly Described<string?> _view = new("--view",
        "Direction of view: top, front, or azimuth,elevation in degrees; -60,28 by default, top for flat drawings.", "VIEW");

    private readonly Described<ColorBy> _color = new("--color", "What the colors show.") { DefaultValueFactory = _ => ColorBy.Role };

    private readonly Described<bool> _travel = new("--travel", "Draw travels as thin lines.");

    private readonly Described<int> _width = new("--width", "Width in pixels; the height is three quarters of it.") { DefaultValueFactory = _ => 960 };

    public ImageVerb()
        : base("image", "Draw an image of paths or of one layer.")
    {
        Arguments.Add(_file);
        Add([_out, _layer, _upTo, _view, _color, _travel, _width]);
        AllowBatches();
    }

    public override IReadOnlyList<(string Line, string Does)> Examples =>
    [
        ("image part.gcode -o part.png", "all layers"),
        ("image part.gcode --layer 3 --view top --color speed -o layer.png", "one layer from above, colored by speed"),
    ];

    public override string[] Writes => ["an image"];

    public override string? Ending => ".png";

    public override int Run(ParseResult arguments, Session session)
    {
        var file = arguments.GetValue(_file)!;
        var width = arguments.GetValue(_width);
        if (width is < 16 or > 8000) throw new CliException(ExitCode.Usage, "--width needs 16 to 8000 pixels.");
        var view = arguments.GetValue(_view) is { } named ? ViewOf(named) : (View?)null;
        var decoding = session.Decode(file, new DecodeOptions { Memory = session.Memory });
        var toolpath = decoding.Toolpath;
        // Pens and lasers move, and lay nothing.
        var drawing = !toolpath.Moves().Any(m => m.Deposited > 0 && m.Role != Role.Purge);
        var options = new ToolpathImageOptions
        {
            Width = width,
            Height = width * 3 / 4,
            View = view ?? (drawing ? View.Top : View.ThreeQuarter),
            // Some firmware tells strokes from travels.
            Strokes = drawing && !toolpath.Moves().Any(m => m.Kind == MoveKind.Print && m.Role != Role.Purge),
            ColorBy = arguments.GetValue(_color),
            Memory = session.Memory,
            Travel = arguments.GetValue(_travel),
            Filter = Filter(arguments, toolpath),
        };
        var image = session.WithProgress("Drawing", progress => ToolpathImage.Draw(toolpath, options, progress, session.Cancel));
        var png = PngWriter.ToBytes(image);
        var target = arguments.GetValue(_out) ?? Path.GetFileNameWithoutExtension(file == "-" ? "image" : file) + ".png";
        session.Write(target, stream => stream.Write(png, 0, png.Length));
        session.Say(() => $"{Session.NameOfOutput(target)}: {width} × {options.Height} pixels; "
            + $"{Session.NameOf(file)}: {PrintSummary.Of(PrintFigures.Of(decoding, toolpath))}");
        return ExitCode.Done;
    }

    private MoveFilter Filter(ParseResult arguments, Toolpath toolpath)
    {
        var only = arguments.GetValue(_layer);
        if ((only ?? arguments.GetValue(_upTo)) is not { } last) return new MoveFilter();
        var layers = toolpath.NumbersOfLayers();
        return layers.Contains(last)
            ? new MoveFilter { FirstLayer = only, LastLayer = last }
            : throw new CliException(ExitCode.BadInput, layers.Count == 0
                ? "The file has no layers."
                : $"There is no layer {last}; the file has layers {layers[0]} to {layers[^1]}.");
    }

    private static View ViewOf(string text)
    {
        if (text == "top") return View.Top;
        if (text == "front") return View.Front;
        var parts = text.Split(',');
        if (parts.Length == 2 && Basics.NumberReader.TryParse(parts[0].Trim(), out var azimuth)
            && Basics.NumberReader.TryParse(parts[1].Trim(), out var elevation))
        {
            return new View(azimuth, elevation);
        }
        throw new CliException(ExitCode.Usage, $"--view {text}: expected top, front, or azimuth,elevation in degrees.");
    }
}
