using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Threading.Tasks;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Dialects;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Cli.Commands;

/// <summary>Decodes a G-code file and writes it again: edited, for another firmware, in another notation. Lines that need no change keep their bytes.</summary>
internal sealed class ConvertVerb : Verb
{
    private readonly Argument<string> _file = new("FILE") { Description = "G-code file, also binary (.bgcode) or packed with gzip, or - for standard input." };
    private readonly Option<string?> _out = new("--output", "-o")
    {
        Description = "File to write, binary where its name ends in .bgcode; - is standard output.",
        HelpName = "FILE",
    };

    private readonly Option<bool> _inPlace = new("--in-place") { Description = "Replace the input itself, instead of --output." };

    private readonly Option<string?> _from =
        CommonOptions.WithDialects(new("--from") { Description = "Firmware the file was made for; detected from the file by default.",
        HelpName = "DIALECT" });
    private readonly Option<string?> _to = CommonOptions.WithDialects(new("--dialect") { Description = "Firmware to write for.", HelpName = "DIALECT" });
    private readonly Option<string?> _e = new("--e") { Description = "Relative (M83) or absolute (M82) E.", HelpName = "relative|absolute" };
    private readonly Option<string?> _unit = new("--e-unit") { Description = "E in mm of filament or in mm³.", HelpName = "mm|mm3" };
    private readonly Option<double?> _diameter = new("--filament-diameter") { Description = "Filament diameter, if the file does not state it.",
        HelpName = "MM" };
    private readonly Option<string?> _arcs = new("--arcs") { Description = "Fit arcs to strands, or expand arcs into chords.", HelpName = "fit|expand" };
    private readonly Option<double> _tolerance = new("--tolerance") { Description = "Maximum deviation of fitted arcs and of chords.", HelpName = "MM",
        DefaultValueFactory = _ => 0.02 };
    private readonly Option<bool> _millimeters = new("--mm") { Description = "Convert inches to millimeters." };
    private readonly Option<double> _retraction =
        new("--retraction") { Description = "Retraction, in units of E, that replaces G10 and G11 where the target lacks them.", HelpName = "E" };
    private readonly Option<string?> _decimals =
        new("--decimals") { Description = "Maximum decimals of X, Y and Z, of E and of F, such as 3,5,0; later ones may be omitted.", HelpName = "XYZ,E,F" };
    private readonly ToolpathEditOptions _edits = new();
    private readonly SetupOptions _setup = new();
    private readonly Option<string?> _reason = WriteOptions.Override();

    public ConvertVerb()
        : base("convert", "Decode a G-code file and write it again: edited, for another firmware, in another notation.")
    {
        Arguments.Add(_file);
        foreach (var option in new Option[]
        {
            _out, _inPlace, _from, _to, _e, _unit, _diameter, _arcs, _tolerance, _millimeters, _retraction, _decimals,
        }) Options.Add(option);
        _edits.AddTo(this);
        _setup.AddTo(this);
        Options.Add(_reason);
        _e.AcceptOnlyFromAmong("relative", "absolute");
        _unit.AcceptOnlyFromAmong("mm", "mm3");
        _arcs.AcceptOnlyFromAmong("fit", "expand");
        AllowBatches();
    }

    public override IReadOnlyList<(string Line, string Does)> Examples =>
    [
        ("convert part.gcode -o slow.gcode --speed 70% --role \"outer wall\"", "slower outer walls"),
        ("convert part.gcode -o nut.gcode --pause-at-layer 3", "a pause at a layer"),
        ("convert part.gcode -o klipper.gcode --dialect klipper --e relative", "for other firmware"),
        ("convert part.gcode -o twisted.gcode --deform \"r, theta + 2*z, z\" --axis middle", "twisted about its middle"),
    ];

    public override string[] Writes => ["G-code"];

    public override string? Ending => ".gcode";

    public override int Run(ParseResult arguments, Session session)
    {
        var file = arguments.GetValue(_file)!;
        var output = Output(file, arguments);
        var target = Target(arguments);
        var from = CommonOptions.DialectOf(arguments.GetValue(_from));
        var document = Read(file, session);
        var decoding = session.GCodeOrFail(session.WithProgress("Reading",
            p => GCodeDecoder.Decode(document,
                new DecodeOptions { Dialect = from, Memory = session.Memory,
                    FilamentDiameter = Numbers.Diameter(arguments.GetValue(_diameter), "--filament-diameter") }, p,
                session.Cancel)));
        var original = decoding;
        var edited = _edits.Edit(decoding.Toolpath, Tolerance(arguments), () => Pause(arguments, session), arguments, session);
        if (arguments.GetValue(_arcs) == "fit") edited = edited.FitArcs(new ArcFitOptions { Tolerance = Tolerance(arguments) });
        var code = _edits.Code(arguments);
        // Summed up while the file is written.
        var summary = session.Quiet && !session.Collects ? null
            : Task.Run(() => (Edits: EditSummary.Of(original.Toolpath, edited), Print: PrintFigures.Of(original, edited)));
        var dialect = decoding.Dialect;
        var stage = ReferenceEquals(edited, decoding.Toolpath) && code.Start is null && code.End is null ? null
            : Editing(decoding, edited, code, session);
        if (target is not null)
        {
            stage = Converting(stage is null ? decoding : Again(session.ValueOrFail(stage.ToDocument()), dialect, arguments, session), target, session);
            dialect = target.Dialect ?? dialect;
        }
        var (lines, bytes) = Write(output, document, stage, dialect, arguments, session);
        session.Made(() => summary!.Result.Print, lines, bytes,
            print => $"{Session.NameOfOutput(output)}: {Changes(summary!.Result.Edits, original, dialect, target is not null, code)}; "
                + $"{PrintSummary.Of(print)}; {NumberFormatter.Format(lines)} lines, {PrintSummary.Size(bytes)}");
        return ExitCode.Done;
    }

    public override bool ReplacesInput(ParseResult arguments) => arguments.GetValue(_inPlace);

    private static string Changes(string edits, DecodedGCode before, DialectRules after, bool converted, EditOptions code)
    {
        string[] parts =
        [
            edits, code.Start is null ? "" : "start code replaced", code.End is null ? "" : "end code replaced",
            after != before.Dialect ? $"{before.Dialect.Title} became {after.Title}" : converted ? "in another notation" : "",
        ];
        var changes = string.Join(", ", parts.Where(p => p.Length > 0));
        return changes.Length > 0 ? changes : "nothing changed";
    }

    private string Output(string file, ParseResult arguments)
    {
        var output = arguments.GetValue(_out);
        if (!arguments.GetValue(_inPlace)) return output ?? throw new CliException(ExitCode.Usage, "Say where to write: --output FILE, or --in-place.");
        if (output is not null) throw new CliException(ExitCode.Usage, "--in-place and --output cannot go together.");
        if (file == "-") throw new CliException(ExitCode.Usage, "--in-place needs a file, not standard input.");
        return !file.EndsWith(".gz", StringComparison.OrdinalIgnoreCase) ? file
            : throw new CliException(ExitCode.Usage, $"--in-place: {file} is packed, and G-code is written unpacked; use --output.");
    }

    private static GCodeDocument Read(string file, Session session)
    {
        using var stream = session.OpenRead(file);
        return session.ValueOrFail(GCodeDocument.Read(stream, Session.NameOf(file), session.Memory, session.Cancel));
    }

    private DecodedGCode Again(GCodeDocument text, DialectRules dialect, ParseResult arguments, Session session)
        => GCodeDecoder.Decode(text, new DecodeOptions { Dialect = dialect, Memory = session.Memory,
            FilamentDiameter = Numbers.Diameter(arguments.GetValue(_diameter), "--filament-diameter") }, null, session.Cancel).Value!;

    private static Stage Editing(DecodedGCode decoding, Toolpath edited, EditOptions code, Session session) => new(
        stream => session.WithProgress("Editing", p => GCodeEditor.Write(decoding, edited, code, stream, p, session.Cancel)),
        () => session.WithProgress("Editing", p => GCodeEditor.ToDocument(decoding, edited, code, p, session.Cancel)));

    private static Stage Converting(DecodedGCode decoding, ConvertOptions target, Session session) => new(
        stream => session.WithProgress("Converting", p => GCodeConverter.Convert(decoding, target, stream, p, session.Cancel)),
        () => session.WithProgress("Converting", p => GCodeConverter.ToDocument(decoding, target, p, session.Cancel)));

    // The last stage writes into the file itself, unless the whole is needed before: to be checked, to become binary.
    private (int Lines, long Bytes) Write(string output, GCodeDocument document, Stage? stage, DialectRules dialect, ParseResult arguments, Session session)
    {
        if (stage is not null && !_setup.IsGiven(arguments) && arguments.GetValue(_reason) is null && !BinaryGCode.IsName(output))
        {
            CountingStream? counted = null;
            session.Write(output, stream =>
            {
                var problems = stage.Write(counted = new CountingStream(stream));
                session.Print(problems);
                if (problems.Any(p => p.Severity == Severity.Error)) throw new CliException(ExitCode.BadInput);
            });
            return (counted!.Lines, counted.Bytes);
        }
        var written = Checked(stage is null ? document : session.ValueOrFail(stage.ToDocument()), dialect, arguments, session);
        session.WriteGCode(output, written);
        return (written.LineCount, written.Length);
    }

    // Checked only if a printer is named: the one that the file was made for is unknown.
    private GCodeDocument Checked(GCodeDocument text, DialectRules dialect, ParseResult arguments, Session session)
    {
        if (!_setup.IsGiven(arguments))
            return arguments.GetValue(_reason) is null ? text
                : throw new CliException(ExitCode.Usage, "--override needs --printer: without it nothing is checked.");
        var setup = _setup.Resolve(arguments, session);
        var decoding = Again(text, dialect, arguments, session);
        return session.ValueOrFail(session.WithProgress("Checking",
            p => SafeWriter.ToDocument(decoding, decoding.Toolpath, setup, arguments.GetValue(_reason), null, p, session.Cancel)), ExitCode.Refused);
    }

    // How high a printer goes is known only of one that is named.
    private Pause Pause(ParseResult arguments, Session session)
    {
        var pause = PauseMoves.Of(_setup.Resolve(arguments, session));
        return _setup.IsGiven(arguments) ? pause : pause with { MaxHeight = double.PositiveInfinity };
    }

    // Null if nothing is to be converted.
    private ConvertOptions? Target(ParseResult arguments)
    {
        var decimals = Decimals(arguments);
        var target = new ConvertOptions
        {
            Dialect = CommonOptions.DialectOf(arguments.GetValue(_to)),
            RelativeE = arguments.GetValue(_e) is { } e ? e == "relative" : null,
            Volumetric = arguments.GetValue(_unit) is { } unit ? unit == "mm3" : null,
            FilamentDiameter = Numbers.Diameter(arguments.GetValue(_diameter), "--filament-diameter"),
            ExpandArcs = arguments.GetValue(_arcs) == "expand",
            ChordTolerance = Tolerance(arguments),
            Millimeters = arguments.GetValue(_millimeters),
            RetractionLength = arguments.GetValue(_retraction) is >= 0 and <= 1000 and var retraction ? retraction
                : throw new CliException(ExitCode.Usage, "--retraction needs a length of 0 to 1000."),
            DecimalsXyz = decimals[0],
            DecimalsE = decimals[1],
            DecimalsF = decimals[2],
        };
        return decimals[0] is null && target.Dialect is null && target.RelativeE is null && target.Volumetric is null && !target.ExpandArcs
            && !target.Millimeters ? null : target;
    }

    private int?[] Decimals(ParseResult arguments)
    {
        var decimals = new int?[3];
        if (arguments.GetValue(_decimals) is not { } text) return decimals;
        var parts = text.Split(',');
        if (parts.Length > 3) throw new CliException(ExitCode.Usage, "--decimals takes at most three numbers: of X, Y and Z, of E and of F.");
        for (var i = 0; i < parts.Length; i++)
        {
            if (!NumberReader.TryParseInt(parts[i].Trim(), out var count)
                || count is < 0 or > 9)
            {
                throw new CliException(ExitCode.Usage, "--decimals needs whole numbers from 0 to 9, such as 3,5,0.");
            }
            decimals[i] = count;
        }
        return decimals;
    }

    private double Tolerance(ParseResult arguments)
        => arguments.GetValue(_tolerance) is > 0 and < 1000 and var tolerance ? tolerance
            : throw new CliException(ExitCode.Usage, "--tolerance needs a positive number of mm.");

    /// <summary>A step of the work whose result goes to a stream (and nothing where there are errors) or into memory.</summary>
    private sealed record Stage(Func<Stream, IReadOnlyList<Diagnostic>> Write, Func<Result<GCodeDocument>> ToDocument);
}
