namespace Caterpillar.Cli;

/// <summary>Draws an image of a print.</summary>
internal sealed class ImageVerb : Verb
{
    private readonly Argument<string> _file = new("FILE") { Description = CommonOptions.GCodeInput };

    private readonly Described<string?> _out = new("--output",
        "Output PNG file; - = standard output. " + CommonOptions.DefaultOutput, "FILE.png", "-o");

    private readonly Described<int?> _layer = new("--layer", "Draw only this layer: its number in the file, or counted from 0.", "N");

    private readonly Described<int?> _upTo = new("--to-layer", "Draw only layers up to this one.", "N");

    private readonly Described<string?> _view = new("--view",
        "View direction, or azimuth and elevation in degrees. Default: -60,28, or top for flat drawings.", "top|front|AZIMUTH,ELEVATION");

    private readonly Described<string?> _region = new("--region", "Part of the bed that fills the image, mm. Default: all that is drawn.", "X0,Y0,X1,Y1");

    private readonly Described<ColorBy> _color = new("--color", "Property that colors show. Default: role.", "role|speed|height|layer|progress");

    private readonly Described<bool> _travel = new("--travel", "Draw travel moves as thin lines.");

    private readonly Described<int> _width = new("--width", "Image width. The height is 3/4 of it.", "PIXELS") { DefaultValueFactory = _ => 960 };

    public ImageVerb()
        : base("image", "Draw an image of a print, or of one layer.", ["an image"], ".png")
    {
        Arguments.Add(_file);
        Add([_out, _layer, _upTo, _view, _region, _color, _travel, _width]);
        AllowBatches();
    }

    public override int Run(ParseResult arguments, Session session)
    {
        var file = arguments.GetValue(_file)!;
        var width = arguments.GetValue(_width);
        if (width is < 16 or > 8000) throw CliException.Usage("--width needs 16 to 8000 pixels.");
        var view = arguments.GetValue(_view) is { } named ? ViewOf(named) : (View?)null;
        var decoding = session.Decode(file, new DecodeOptions { Memory = session.Memory });
        var toolpath = decoding.Unrolled();
        // Pens and lasers move without extrusion.
        var drawing = !toolpath.Moves().Any(m => m.Deposited > 0 && m.Role != Role.Purge);
        var options = new ToolpathImageOptions
        {
            Width = width,
            Height = width * 3 / 4,
            View = view ?? (drawing ? View.Top : View.ThreeQuarter),
            Region = arguments.GetValue(_region) is { } region ? RegionOf(region) : default,
            // Some firmware distinguishes pen moves from travel moves.
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
                : $"Layer {last} not found. The file has layers {layers[0]} to {layers[^1]}.");
    }

    private static Bounds RegionOf(string text)
    {
        var v = Numbers.List(text, "--region");
        return v.Length == 4 && v[0] < v[2] && v[1] < v[3]
            ? new Bounds(new Vec3(v[0], v[1]), new Vec3(v[2], v[3]))
            : throw CliException.Usage("--region needs X0,Y0,X1,Y1 in mm: the lowest corner, then the highest.");
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
        throw CliException.Usage($"--view {text}: expected top, front, or azimuth,elevation in degrees.");
    }
}
