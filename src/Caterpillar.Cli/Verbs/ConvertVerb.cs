using Caterpillar.Checks;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Jobs;

namespace Caterpillar.Cli;

/// <summary>Decodes a G-code file and writes it again: edited, for another firmware, in another notation. Lines that need no change keep their bytes.</summary>
internal sealed class ConvertVerb : Verb
{
    private readonly Argument<string> _file = new("FILE") { Description = "G-code file, also binary (.bgcode) or packed with gzip, or - for standard input." };
    private readonly Described<string?> _out = new("--output", "File to write, binary where its name ends in .bgcode; - is standard output.", "FILE", "-o");

    private readonly Described<bool> _inPlace = new("--in-place", "Replace the input itself, instead of --output.");

    private readonly Described<string?> _from = CommonOptions.Flavor("--from",
        "Firmware the file was made for; detected from the file by default.", "FLAVOR");
    private readonly Described<string?> _to = CommonOptions.Flavor("--flavor", "Firmware to write for.", "FLAVOR");
    private readonly Described<string?> _e = new("--e", "Relative (M83) or absolute (M82) E.", "relative|absolute");
    private readonly Described<string?> _unit = new("--e-unit", "E in mm of filament or in mm³.", "mm|mm3");
    private readonly Described<double?> _diameter = new("--filament-diameter", "Filament diameter, if the file does not state it.", "MM");
    private readonly Described<string?> _arcs = new("--arcs", "Fit arcs to extrusions, or expand arcs into chords.", "fit|expand");
    private readonly Described<double> _tolerance = new("--tolerance",
        "Maximum deviation of fitted arcs and of chords.", "MM") { DefaultValueFactory = _ => 0.02 };
    private readonly Described<bool> _millimeters = new("--mm", "Convert inches to millimeters.");
    private readonly Described<double> _retraction = new("--retraction",
        "Retraction, in units of E, that replaces G10 and G11 where the target lacks them.", "E");
    private readonly Described<string?> _decimals = new("--decimals",
        "Maximum decimals of X, Y and Z, of E and of F, such as 3,5,0; later ones may be omitted.", "XYZ,E,F");
    private readonly ToolpathEditOptions _edits = new();
    private readonly SetupOptions _setup = new();
    private readonly Option<string?> _reason = WriteOptions.Override();

    public ConvertVerb()
        : base("convert", "Decode a G-code file and write it again: edited, for another firmware, in another notation.")
    {
        Arguments.Add(_file);
        Add([_out, _inPlace, _from, _to, _e, _unit, _diameter, _arcs, _tolerance, _millimeters, _retraction, _decimals]);
        Add([.. _edits.All, .. _setup.All, _reason]);
        _e.AcceptOnlyFromAmong("relative", "absolute");
        _unit.AcceptOnlyFromAmong("mm", "mm3");
        _arcs.AcceptOnlyFromAmong("fit", "expand");
        AllowBatches();
    }

    public override IReadOnlyList<(string Line, string Does)> Examples =>
    [
        ("convert part.gcode -o slow.gcode --speed 70% --role \"outer wall\"", "slower outer walls"),
        ("convert part.gcode -o nut.gcode --pause-at-layer 3", "a pause at a layer"),
        ("convert part.gcode -o klipper.gcode --flavor klipper --e relative", "for other firmware"),
        ("convert part.gcode -o twisted.gcode --deform \"r, theta + 2*z, z\" --axis middle", "twisted about its middle"),
    ];

    public override string[] Writes => ["G-code"];

    public override string? Ending => ".gcode";

    public override int Run(ParseResult arguments, Session session)
    {
        var file = arguments.GetValue(_file)!;
        var output = Output(file, arguments);
        var target = Target(arguments);
        var reading = new DecodeOptions
        {
            Flavor = CommonOptions.FlavorOf(arguments.GetValue(_from)), Memory = session.Memory,
            FilamentDiameter = Numbers.Diameter(arguments.GetValue(_diameter), "--filament-diameter"),
        };
        var document = Read(file, session);
        var decoding = session.GCodeOrFail(session.WithProgress("Reading", progress => GCodeDecoder.Decode(document, reading, progress, session.Cancel)));
        var job = Edited(new FileJob(decoding, reading), arguments, session) with { Code = _edits.Code(arguments), Target = target };
        // Summed up while the file is written.
        var summary = session.Quiet && !session.Collects ? null
            : Task.Run(() => (Edits: EditSummary.Of(decoding.Toolpath, job.Toolpath), Print: PrintFigures.Of(decoding, job.Toolpath)));
        var written = Write(output, job, arguments, session);
        session.Made(() => summary!.Result.Print, written.Lines, written.Bytes,
            print => $"{Session.NameOfOutput(output)}: {Changes(summary!.Result.Edits, job)}; "
                + $"{PrintSummary.Of(print)}; {NumberFormatter.Format(written.Lines)} lines, {PrintSummary.Size(written.Bytes)}");
        return ExitCode.Done;
    }

    public override bool ReplacesInput(ParseResult arguments) => arguments.GetValue(_inPlace);

    private static string Changes(string edits, FileJob job)
    {
        string[] parts =
        [
            edits, job.Code.Start is null ? "" : "start code replaced", job.Code.End is null ? "" : "end code replaced",
            job.Flavor != job.File.Flavor ? $"{job.File.Flavor.Title} became {job.Flavor.Title}" : job.Target is not null ? "in another notation" : "",
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

    private FileJob Edited(FileJob job, ParseResult arguments, Session session)
    {
        var tolerance = Tolerance(arguments);
        var edits = _edits.Of(job.Toolpath, tolerance, () => Pause(arguments, session), arguments, session);
        var edited = job.Edit(arguments.GetValue(_arcs) == "fit" ? edits with { FitArcs = new ArcFitOptions { Tolerance = tolerance } } : edits);
        // A layer that is not there was asked for on the command line.
        if (edited.Diagnostics.FirstOrDefault(d => d.Code == "toolpath.no_layer") is not { } none) return session.ValueOrFail(edited);
        session.Print(edited.Diagnostics.Where(d => d != none));
        throw new CliException(ExitCode.Usage, none.Message);
    }

    // Checked only if a printer is named: the one that the file was made for is unknown.
    private WrittenGCode Write(string output, FileJob job, ParseResult arguments, Session session)
    {
        var reason = arguments.GetValue(_reason);
        var isChecked = _setup.IsGiven(arguments);
        if (!isChecked && reason is not null) throw new CliException(ExitCode.Usage, "--override needs --printer: without it nothing is checked.");
        var setup = isChecked ? _setup.Resolve(arguments, session) : null;
        WrittenGCode? written = null;
        session.Write(output, (stream, _) =>
        {
            var result = session.WithProgress("Writing", progress => job.Write(stream, output, setup, reason, progress, session.Cancel));
            session.Print(result.Diagnostics);
            written = session.WrittenOrFail(result);
        });
        return written!;
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
            Flavor = CommonOptions.FlavorOf(arguments.GetValue(_to)),
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
        return decimals[0] is null && target.Flavor is null && target.RelativeE is null && target.Volumetric is null && !target.ExpandArcs
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
