using System.Collections.Generic;
using System.CommandLine;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;

namespace Caterpillar.Cli.Commands;

/// <summary>Options that scale, turn and place models. They act in the order in which they stand here, whatever the order on the command line.</summary>
internal sealed class ModelOptions
{
    private readonly Option<string?> _scale = new("--scale")
    {
        Description = "Scale the models: by a factor, by one for each axis, or so that the longest side (one length) or the box (three) has a size.",
        HelpName = "FACTOR|%|X,Y,Z|LENGTHmm|X,Y,Zmm",
    };

    private readonly Option<string?> _rotate = new("--rotate")
    {
        Description = "Turn the models, counter-clockwise from above; or about X, then Y, then Z.", HelpName = "DEGREES|X,Y,Z",
    };

    private readonly Option<bool> _layFlat = new("--lay-flat") { Description = "Turn each model so that its largest flat face is on the bed." };
    private readonly Option<int> _copies = new("--copies")
    {
        Description = "Print so many of each model, arranged on the bed.", HelpName = "N", DefaultValueFactory = _ => 1,
    };

    private readonly Option<bool> _arrange = new("--arrange")
    {
        Description = "Put the models beside each other, from the middle of the bed outwards; with print_sequence=by_object so far apart that the head passes.",
    };

    private readonly Option<string> _spacing = new("--spacing")
    {
        Description = "Smallest distance between arranged models in mm.", HelpName = "MM",
        DefaultValueFactory = _ => NumberFormatter.Format(new ArrangeOptions().Spacing, 9),
    };

    private readonly Option<string?> _place = new("--place") { Description = "Put the middle of the models at a point of the bed.", HelpName = "X,Y" };
    private readonly Option<bool> _center = new("--center") { Description = "Put the middle of the models in the middle of the bed (what happens anyway)." };
    private readonly Option<bool> _keepPosition =
        new("--keep-position") { Description = "Print where the model stands in its file, instead of the middle of the bed." };

    public void AddTo(Verb verb)
    {
        foreach (var option in new Option[] { _scale, _rotate, _layFlat, _copies, _arrange, _spacing, _place, _center, _keepPosition })
            verb.Options.Add(option);
    }

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
        if (arguments.GetValue(_place) is { } place) _ = Place(place);
        if (arguments.GetValue(_scale) is { } scale) _ = Scaled([], scale);
        if (arguments.GetValue(_rotate) is { } rotate) _ = Angles(rotate);
        _ = Spacing(arguments);
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
        if (arguments.GetValue(_scale) is { } scale) models = Scaled(models, scale);
        if (arguments.GetValue(_rotate) is { } rotate) models = ModelPlacement.Rotated(models, Angles(rotate));
        if (arguments.GetValue(_layFlat)) models = ModelPlacement.LaidFlat(models);
        var copies = arguments.GetValue(_copies);
        var byObject = setup.Settings.PrintSequence == PrintSequence.ByObject;
        if (arguments.GetValue(_arrange) || copies > 1)
        {
            var options = new ArrangeOptions { Spacing = Spacing(arguments), OneAfterTheOther = byObject };
            models = session.ValueOrFail(ModelArranger.Arrange(models.Copies(copies), setup.Printer, options, session.Cancel), ExitCode.Refused);
        }
        else if (!arguments.GetValue(_keepPosition))
        {
            var center = arguments.GetValue(_place) is { } place ? Place(place) : setup.Printer.BuildBounds.Center;
            // Bodies that are not printed move along with the parts.
            var box = ModelPlacement.BoxOf(Parts());
            if (!box.IsEmpty) models = models.Moved(new Vec3(center.X - box.Center.X, center.Y - box.Center.Y, -box.Min.Z));
        }
        session.Print(ModelCheck.Fit(Parts(), setup.Printer));
        if (!byObject) return models;
        var clearance = ModelCheck.Clearance(Parts(), setup.Printer);
        session.Print(clearance);
        return clearance.Any(d => d.Severity == Severity.Error) ? throw new CliException(ExitCode.Refused) : models;

        IReadOnlyList<NamedMesh> Parts() => isPart.Contains(false) ? models.Where((_, i) => isPart[i]).ToArray() : models;
    }

    private string? MovesApart(ParseResult arguments)
        => arguments.GetValue(_arrange) ? "--arrange" : arguments.GetValue(_copies) > 1 ? "--copies" : arguments.GetValue(_layFlat) ? "--lay-flat" : null;

    private static IReadOnlyList<NamedMesh> Scaled(IReadOnlyList<NamedMesh> models, string text)
    {
        var plain = text.Trim();
        var isSize = plain.EndsWith("mm", System.StringComparison.Ordinal);
        var numbers = (isSize ? plain[..^2] : plain).Split(',').Select(n => Numbers.Factor(n, "--scale", 1e-6)).ToArray();
        return (isSize, numbers) switch
        {
            (false, [var all]) => ModelPlacement.Scaled(models, new Vec3(all, all, all)),
            (false, [var x, var y, var z]) => ModelPlacement.Scaled(models, new Vec3(x, y, z)),
            (true, [var longest]) => ModelPlacement.ScaledTo(models, longest),
            (true, [var x, var y, var z]) => ModelPlacement.ScaledTo(models, new Vec3(x, y, z)),
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
