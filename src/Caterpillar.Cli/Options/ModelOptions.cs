using Caterpillar.Jobs;
using Caterpillar.Slicing;

namespace Caterpillar.Cli;

/// <summary>Options that scale, turn and place models. They act in the order in which they stand here, whatever the order on the command line.</summary>
internal sealed class ModelOptions
{
    private readonly Described<string?> _scale = new("--scale",
        "Scale the models: by a factor, by one for each axis, or so that the longest side (one length) or the box (three) has a size.",
        "FACTOR|%|X,Y,Z|LENGTHmm|X,Y,Zmm");

    private readonly Described<string?> _rotate = new("--rotate",
        "Turn the models, counter-clockwise from above; or about X, then Y, then Z.", "DEGREES|X,Y,Z");

    private readonly Described<bool> _layFlat = new("--lay-flat", "Turn each model so that its largest flat face is on the bed.");
    private readonly Described<int> _copies = new("--copies", "Print so many of each model, arranged on the bed.", "N") { DefaultValueFactory = _ => 1 };

    private readonly Described<bool> _arrange = new("--arrange",
        "Put the models beside each other, from the middle of the bed outwards; with print_sequence=by_object so far apart that the head passes.");

    private readonly Described<string> _spacing = new("--spacing",
        "Smallest distance between arranged models in mm.", "MM") { DefaultValueFactory = _ => NumberFormatter.Format(new ArrangeOptions().Spacing, 9) };

    private readonly Described<string?> _place = new("--place", "Put the middle of the models at a point of the bed.", "X,Y");
    private readonly Described<bool> _center = new("--center", "Put the middle of the models in the middle of the bed (what happens anyway).");
    private readonly Described<bool> _keepPosition = new("--keep-position", "Print where the model stands in its file, instead of the middle of the bed.");

    public Option[] All => [_scale, _rotate, _layFlat, _copies, _arrange, _spacing, _place, _center, _keepPosition];

    /// <summary>Wrong usage is found before files are read.</summary>
    /// <exception cref="CliException">Options do not go together.</exception>
    public void Check(ParseResult arguments)
    {
        var copies = arguments.GetValue(_copies);
        if (copies is < 1 or > 10_000) throw new CliException(ExitCode.Usage, "--copies needs a number from 1 to 10000.");
        var arrange = arguments.GetValue(_arrange) || copies > 1;
        string[] given =
        [
            .. arrange ? [arguments.GetValue(_arrange) ? "--arrange" : "--copies"] : (string[])[],
            .. arguments.GetValue(_place) is null ? (string[])[] : ["--place"],
            .. arguments.GetValue(_center) ? ["--center"] : (string[])[],
            .. arguments.GetValue(_keepPosition) ? ["--keep-position"] : (string[])[],
        ];
        if (given.Length > 1) throw new CliException(ExitCode.Usage, $"{given[0]} and {given[1]} both say where the models stand: give one.");
        _ = Placing(arguments);
    }

    /// <summary>The option given that does more than move all models together, or null.</summary>
    public string? Turns(ParseResult arguments)
        => arguments.GetValue(_scale) is not null ? "--scale" : arguments.GetValue(_rotate) is not null ? "--rotate" : MovesApart(arguments);

    /// <summary>A sentence for those who may have meant a length by a large factor, or nothing.</summary>
    public string ScaleAdvice(ParseResult arguments)
        => arguments.GetValue(_scale)?.Trim() is { } text && NumberReader.TryParse(text, out var factor) && factor >= 5
            ? $" --scale {text} is a factor; --scale {text}mm makes the longest side that long." : "";

    /// <summary>The models as they are printed. What does not fit is printed as a warning.</summary>
    /// <param name="models">The models.</param>
    /// <param name="isPart">Which of them are printed; the others keep their places to these.</param>
    /// <param name="arguments">The options.</param>
    /// <param name="setup">The printer.</param>
    /// <param name="session">Takes warnings.</param>
    /// <exception cref="CliException">There is no place for all of them, or the head cannot pass between them.</exception>
    public IReadOnlyList<NamedMesh> Placed(
        IReadOnlyList<NamedMesh> models, IReadOnlyList<bool> isPart, ParseResult arguments, PrintSetup setup, Session session)
    {
        if (isPart.Contains(false) && MovesApart(arguments) is { } option)
        {
            var name = models[isPart.ToList().IndexOf(false)].Name;
            throw new CliException(ExitCode.Usage, $"{option} would move {name}, which is not printed, away from its part: place the parts with --place.");
        }
        var placed = Placing(arguments).Place(models, setup, isPart, session.Cancel);
        session.Print(placed.Diagnostics);
        return placed.Value ?? throw new CliException(ExitCode.Refused);
    }

    private string? MovesApart(ParseResult arguments)
        => arguments.GetValue(_arrange) ? "--arrange" : arguments.GetValue(_copies) > 1 ? "--copies" : arguments.GetValue(_layFlat) ? "--lay-flat" : null;

    private ModelPlacing Placing(ParseResult arguments)
    {
        var placing = new ModelPlacing { Center = arguments.GetValue(_place) is { } place ? Place(place) : null };
        if (arguments.GetValue(_scale) is { } scale) placing = Scaled(placing, scale);
        return placing with
        {
            Rotate = arguments.GetValue(_rotate) is { } rotate ? Angles(rotate) : null, LayFlat = arguments.GetValue(_layFlat),
            Copies = arguments.GetValue(_copies), Arrange = arguments.GetValue(_arrange), Spacing = Spacing(arguments),
            KeepPosition = arguments.GetValue(_keepPosition),
        };
    }

    private static ModelPlacing Scaled(ModelPlacing placing, string text)
    {
        var plain = text.Trim();
        var isSize = plain.EndsWith("mm", StringComparison.Ordinal);
        var numbers = (isSize ? plain[..^2] : plain).Split(',').Select(n => Numbers.Factor(n, "--scale", 1e-6)).ToArray();
        return (isSize, numbers) switch
        {
            (false, [var all]) => placing with { Scale = new Vec3(all, all, all) },
            (false, [var x, var y, var z]) => placing with { Scale = new Vec3(x, y, z) },
            (true, [var longest]) => placing with { LongestSide = longest },
            (true, [var x, var y, var z]) => placing with { Size = new Vec3(x, y, z) },
            _ => throw new CliException(ExitCode.Usage, "--scale needs a factor or a length, or one for each of X,Y,Z."),
        };
    }

    private static Vec3 Angles(string text) => Numbers.List(text, "--rotate") switch
    {
        [var z] => new Vec3(0, 0, z),
        [var x, var y, var z] => new Vec3(x, y, z),
        _ => throw new CliException(ExitCode.Usage, "--rotate needs degrees about Z, or X,Y,Z."),
    };

    private static Vec3 Place(string text)
    {
        if (Numbers.List(text, "--place").Length != 2) throw new CliException(ExitCode.Usage, "--place needs X,Y in mm.");
        return Numbers.Vector(text, "--place");
    }

    private double Spacing(ParseResult arguments)
        => NumberReader.TryParse(arguments.GetValue(_spacing), out var spacing) && spacing is >= 0 and < 1e6 ? spacing
            : throw new CliException(ExitCode.Usage, "--spacing needs a distance from 0 mm on.");
}
