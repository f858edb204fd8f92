namespace Caterpillar.Cli;

/// <summary>Options that scale, rotate and place models. They act in this order, not in the order of the command line.</summary>
internal sealed class ModelOptions
{
    private readonly Described<string?> _unit = new("--unit",
        "Length of one unit in STL, OBJ and PLY, in mm or by name: um, cm, m, in, ft. Surfaces, curves and other files are in mm. Default: mm.", "MM|NAME");

    private readonly Described<string?> _scale = new("--scale",
        "Scale the models. One number: factor. Three: factors for X, Y and Z. With mm: longest side, or size in X, Y and Z.",
        "FACTOR|%|X,Y,Z|LENGTHmm|X,Y,Zmm");

    private readonly Described<string?> _rotate = new("--rotate", "Rotate the models about Z, counterclockwise from above, or about X, then Y, then Z.",
        "DEGREES|X,Y,Z");

    private readonly Described<bool> _layFlat = new("--lay-flat", "Rotate each model so that its largest flat face is on the bed.");
    private readonly Described<int> _copies = new("--copies", "Number of copies of each model, arranged on the bed.", "N") { DefaultValueFactory = _ => 1 };

    private readonly Described<bool> _arrange = new("--arrange",
        "Arrange the models next to each other, from the center of the bed outward. With print_sequence=by_object, the head can pass between them.");

    private readonly Described<string> _spacing = new("--spacing",
        "Minimum distance between arranged models.", "MM") { DefaultValueFactory = _ => NumberFormatter.Format(new ArrangeOptions().Spacing, 9) };

    private readonly Described<string?> _center = new("--center", "Center of the models on the bed. Default: center of the bed.", "X,Y");
    private readonly Described<bool> _keepPosition = new("--keep-position", "Keep the position of the models in their files.");

    public Option[] All => [_unit, _scale, _rotate, _layFlat, _copies, _arrange, _spacing, _center, _keepPosition];

    /// <summary>Finds wrong usage before files are read.</summary>
    /// <exception cref="CliException">Options cannot be combined.</exception>
    public void Check(ParseResult arguments)
    {
        var copies = arguments.GetValue(_copies);
        if (copies is < 1 or > 10_000) throw CliException.Usage("--copies needs a number from 1 to 10000.");
        var arrange = arguments.GetValue(_arrange) || copies > 1;
        string[] given =
        [
            .. arrange ? [arguments.GetValue(_arrange) ? "--arrange" : "--copies"] : (string[])[],
            .. arguments.GetValue(_center) is null ? (string[])[] : ["--center"],
            .. arguments.GetValue(_keepPosition) ? ["--keep-position"] : (string[])[],
        ];
        if (given.Length > 1) throw CliException.Usage($"{given[0]} cannot be combined with {given[1]}: both place the models.");
        _ = Placing(arguments);
        _ = UnitOf(arguments);
    }

    /// <summary>Length of one unit of the models in mm.</summary>
    /// <exception cref="CliException">It is not a unit.</exception>
    public double UnitOf(ParseResult arguments) => Numbers.Unit(arguments.GetValue(_unit));

    /// <summary>A hint if a large factor may have been meant as a length, or nothing.</summary>
    public string ScaleAdvice(ParseResult arguments)
        => arguments.GetValue(_scale)?.Trim() is { } text && NumberReader.TryParse(text, out var factor) && factor >= 5
            ? $" --scale {text} is a factor. For a longest side of {text} mm, use --scale {text}mm." : "";

    /// <summary>The models at their print positions. Prints a warning for models that do not fit.</summary>
    /// <param name="models">The models.</param>
    /// <param name="isPart">The models that are printed. The others keep their positions relative to them.</param>
    /// <param name="arguments">The options.</param>
    /// <param name="setup">The printer.</param>
    /// <param name="session">Prints warnings.</param>
    /// <exception cref="CliException">They do not all fit, or the head cannot pass between them.</exception>
    public IReadOnlyList<NamedMesh> Placed(
        IReadOnlyList<NamedMesh> models, IReadOnlyList<bool> isPart, ParseResult arguments, PrintSetup setup, Session session)
    {
        if (isPart.Contains(false) && MovesApart(arguments) is { } option)
        {
            var name = models[isPart.ToList().IndexOf(false)].Name;
            throw CliException.Usage($"{option} would move {name}, which is not printed, away from its part. Place the models with --center.");
        }
        var placed = Placing(arguments).Place(models, setup, isPart, session.Cancel);
        session.Print(placed.Diagnostics);
        return placed.Value ?? throw new CliException(ExitCode.Refused);
    }

    private string? MovesApart(ParseResult arguments)
        => arguments.GetValue(_arrange) ? "--arrange" : arguments.GetValue(_copies) > 1 ? "--copies" : arguments.GetValue(_layFlat) ? "--lay-flat" : null;

    private ModelPlacing Placing(ParseResult arguments)
    {
        var placing = new ModelPlacing { Center = arguments.GetValue(_center) is { } center ? Center(center) : null };
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
            _ => throw CliException.Usage("--scale needs a factor or a length, or three of them: X,Y,Z."),
        };
    }

    private static Vec3 Angles(string text) => Numbers.List(text, "--rotate") switch
    {
        [var z] => new Vec3(0, 0, z),
        [var x, var y, var z] => new Vec3(x, y, z),
        _ => throw CliException.Usage("--rotate needs degrees about Z, or three angles: X,Y,Z."),
    };

    private static Vec3 Center(string text)
    {
        if (Numbers.List(text, "--center").Length != 2) throw CliException.Usage("--center needs X,Y in mm.");
        return Numbers.Vector(text, "--center");
    }

    private double Spacing(ParseResult arguments)
        => NumberReader.TryParse(arguments.GetValue(_spacing), out var spacing) && spacing is >= 0 and < 1e6 ? spacing
            : throw CliException.Usage("--spacing needs a distance of 0 mm or more.");
}
