namespace Caterpillar.Cli;

/// <summary>Edits a G-code file, or converts it to another flavor or notation. Lines that need no change keep their bytes.</summary>
internal sealed class ConvertVerb : Verb
{
    private readonly Argument<string> _file = new("FILE") { Description = CommonOptions.GCodeInput };
    private readonly Described<string?> _out = new("--output", WriteOptions.Description, "FILE", "-o");

    private readonly Described<bool> _inPlace = new("--in-place", "Replace the input file.");

    private readonly Described<string?> _from = CommonOptions.Flavor("--from-flavor", "G-code flavor of the input. Default: detected.");
    private readonly Described<string?> _to = CommonOptions.Flavor("--flavor", "G-code flavor of the output. Default: same as the input.");
    private readonly Described<string?> _e = new("--e-mode", "E mode: relative (M83) or absolute (M82).", "relative|absolute");
    private readonly Described<string?> _unit = new("--e-unit", "Unit of E: mm of filament, or mm³.", "mm|mm3");
    private readonly Described<double?> _diameter = CommonOptions.FilamentDiameter();
    private readonly Described<string?> _arcs = new("--arcs", "Fit arcs to extrusions, or expand arcs into straight moves.", "fit|expand");
    private readonly Described<double> _tolerance = new("--tolerance",
        "Maximum deviation of fitted, expanded or deformed paths.", "MM") { DefaultValueFactory = _ => 0.02 };
    private readonly Described<bool> _millimeters = new("--mm", "Convert inches to millimeters.");
    private readonly Described<double> _retraction = new("--retraction",
        "Retraction length, in units of E, that replaces G10 and G11 if the output flavor lacks them.", "E");
    private readonly Described<string?> _decimals = new("--decimals",
        "Maximum decimals of X, Y and Z, of E and of F, such as 3,5,0. The last ones may be omitted.", "XYZ,E,F");
    private readonly ToolpathEditOptions _edits = new();
    private readonly SetupOptions _setup = new("Without it, only whether a moved print stays on the bed is checked, as far as the file knows it.");
    private readonly Option<string?> _reason = WriteOptions.Override();

    public ConvertVerb()
        : base("convert", "Edit a G-code file, or convert it to another flavor or notation. With --printer, the result is checked.", ["G-code"], ".gcode")
    {
        Arguments.Add(_file);
        Add([_out, _inPlace, _from, _to, _e, _unit, _diameter, _arcs, _tolerance, _millimeters, _retraction, _decimals]);
        Add([.. _edits.All, .. _setup.All, _reason]);
        _e.AcceptOnlyFromAmong("relative", "absolute");
        _unit.AcceptOnlyFromAmong("mm", "mm3");
        _arcs.AcceptOnlyFromAmong("fit", "expand");
        AllowBatches();
    }

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
        if (target is null or { Flavor: null, Volumetric: null } && output != "-" && !BinaryGCode.IsName(output) && IsUnchecked(arguments))
        {
            if (_edits.AreNone(arguments)) return WhileDecoding(file, output, reading, target, null, session);
            if (target is null && StreamedEdits(file, reading, arguments, session) is { } edits)
            {
                if (!edits.IsCentered) return WhileDecoding(file, output, reading, null, new FollowingEditor(edits.ApplyTo), session);
                if (AboutCenter(file, output, reading, edits, session)) return ExitCode.Done;
            }
        }
        var decoding = session.Decode(file, reading with { KeepsText = true });
        var job = new FileJob(decoding, reading) { Code = _edits.Code(arguments), Target = target };
        job = _edits.Half(Edited(job, arguments, session), arguments, session);
        // While the file is being written.
        var summary = session.Quiet && !session.Collects ? null
            : Task.Run(() => (Edits: EditSummary.Of(decoding.Toolpath, job.Toolpath), Print: PrintFigures.Of(decoding, job.Toolpath)));
        var written = Write(output, job, arguments, session);
        return Made(output, written, () => summary!.Result.Print, () => Changes(summary!.Result.Edits, job), session);
    }

    public override bool ReplacesInput(ParseResult arguments) => arguments.GetValue(_inPlace);

    // Edits about the center of the print, which is known when all of it has been read. False if the check of what is written, which sees it at the same
    // time, finds something: what it says of it needs all moves.
    private static bool AboutCenter(string file, string output, DecodeOptions reading, FileEdits edits, Session session)
    {
        // What a device or a pipe has got cannot be taken back.
        if (FileLinks.MayBeSpecial(FileLinks.Target(Path.GetFullPath(output)))) return false;
        var sums = new ToolpathSums { OnlyLayers = true };
        var read = session.Read(file, reading with { KeepsMoves = false, Take = _ => { }, Sums = sums });
        if (read.Value is not { LayerNumbers: not null } before || !edits.CanFollow(before)) return false;
        var totals = sums.ToTotals(before.Toolpath.Tools);
        edits = edits with { Center = FileEdits.Foot(totals.PrintBounds) };
        var after = edits.Apply(before.Toolpath).Value!;
        var (check, findings) = PrintCheck.OnBedInParts(before, after, session.Cancel);
        var editor = new FollowingEditor((part, position) => check(edits.ApplyTo(part, position).With(layers: after.Layers)), before, after);
        try
        {
            WhileDecoding(file, output, reading, null, editor, session, () =>
            {
                if (findings().Count > 0) throw new CliException(ExitCode.Refused);
                session.GCodeOrFail(read);
                session.Print(edits.ScaleNotes(totals.DepositedE != 0 && edits.Flow != 0));
            });
        }
        catch (CliException found) when (found.Code == ExitCode.Refused)
        {
            return false;
        }
        return true;
    }

    // Nothing of it has to be kept. What a check refuses is read once more, and has its messages then.
    private static int WhileDecoding(
        string file, string output, DecodeOptions reading, ConvertOptions? target, FollowingEditor? editor, Session session, Action? check = null)
    {
        DecodedGCode? decoding = null;
        CountingStream? counted = null;
        var sums = editor?.Sums ?? new ToolpathSums();
        DecodedGCode Decode(DecodeOptions options)
            => check is null ? session.Decode(file, options) : session.Read(file, options).Value ?? throw new CliException(ExitCode.Refused);
        session.Write(output, stream =>
        {
            decoding = session.ValueOrFail(GCodeConverter.WhileDecoding(
                Decode, reading with { Sums = editor is null ? sums : null }, target, counted = new CountingStream(stream), editor));
            check?.Invoke();
        });
        IEnumerable<string> changes = editor is not null ? EditSummary.Of(editor.Difference) : target is not null ? ["notation converted"] : [];
        var (written, toolpath) = (new WrittenGCode(counted!.Bytes, counted.Lines, 0), editor?.Whole.After ?? decoding!.Toolpath);
        return Made(output, written, () => PrintFigures.Of(decoding!, toolpath, sums), () => Listed(changes), session);
    }

    private static int Made(string output, WrittenGCode written, Func<PrintFigures> print, Func<string> changes, Session session)
    {
        session.Made(print, written.Lines, written.Bytes, print => $"{Session.NameOfOutput(output)}: {changes()}; {PrintSummary.Of(print)}; "
            + $"{NumberFormatter.Format(written.Lines)} lines, {PrintSummary.Size(written.Bytes)}");
        return ExitCode.Done;
    }

    // The edits, if they can be made while the file is decoded. Its beginning and end, read twice, show whether comments mark the layers.
    private FileEdits? StreamedEdits(string file, DecodeOptions reading, ParseResult arguments, Session session)
    {
        if (!_edits.AreNone(arguments, orPlain: true) || !File.Exists(file) || new FileInfo(file).Length == 0) return null;
        if (session.Read(file, reading with { KeepsMoves = false, OnlyEnds = true }).Value is not { } head) return null;
        try
        {
            var edits = _edits.Of(head.Toolpath, Tolerance(arguments), () => Pausing(arguments, session), arguments, session);
            return edits.CanFollow(head) ? edits : null;
        }
        catch (CliException)
        {
            // What the file itself has to say comes first.
            return null;
        }
    }

    private bool IsUnchecked(ParseResult arguments)
        => arguments.GetValue(_arcs) != "fit" && arguments.GetValue(_reason) is null && !_setup.IsGiven(arguments);

    private static string Changes(IEnumerable<string> edits, FileJob job)
        => Listed(
        [
            .. edits, job.Code.Start is null ? "" : "start G-code replaced", job.Code.End is null ? "" : "end G-code replaced",
            job.Flavor != job.File.Flavor ? $"converted from {job.File.Flavor.Title} to {job.Flavor.Title}"
                : job.Target is not null ? "notation converted" : "",
        ]);

    private static string Listed(IEnumerable<string> changes)
        => string.Join(", ", changes.Where(c => c.Length > 0)) is { Length: > 0 } listed ? listed : "nothing changed";

    private string Output(string file, ParseResult arguments)
    {
        var output = arguments.GetValue(_out);
        if (!arguments.GetValue(_inPlace)) return output ?? throw CliException.Usage("The output is missing. Give --output FILE or --in-place.");
        if (output is not null) throw CliException.Usage("--in-place cannot be combined with --output.");
        if (file == "-") throw CliException.Usage("--in-place needs a file, not standard input.");
        return !file.EndsWith(".gz", StringComparison.OrdinalIgnoreCase) ? file
            : throw CliException.Usage($"--in-place cannot write gzip files such as {file}. Use --output.");
    }

    private FileJob Edited(FileJob job, ParseResult arguments, Session session)
    {
        var tolerance = Tolerance(arguments);
        var edits = _edits.Of(job.Toolpath, tolerance, () => Pausing(arguments, session), arguments, session);
        var edited = job.Edit(arguments.GetValue(_arcs) == "fit" ? edits with { FitArcs = tolerance } : edits);
        // A missing layer is an error of the command line.
        if (edited.Diagnostics.FirstOrDefault(d => d.Code == "toolpath.no_layer") is not { } none) return session.ValueOrFail(edited);
        session.Print(edited.Diagnostics.Where(d => d != none));
        throw CliException.Usage(none.Message);
    }

    // Checked only if a printer is given, since the printer of the file is unknown, except that a moved print must stay on the bed.
    private WrittenGCode Write(string output, FileJob job, ParseResult arguments, Session session)
    {
        var reason = arguments.GetValue(_reason);
        var isChecked = _setup.IsGiven(arguments);
        if (!isChecked && !job.IsMoved && reason is not null)
            throw CliException.Usage("--override needs --printer. Without it, only moved prints are checked.");
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

    // The maximum height is known only of a given printer.
    private PrintSetup Pausing(ParseResult arguments, Session session)
    {
        const double Unlimited = 100_000;
        var setup = _setup.Resolve(arguments, session);
        return _setup.IsGiven(arguments) ? setup : setup with { Printer = setup.Printer with { BuildVolume = setup.Printer.BuildVolume.WithZ(Unlimited) } };
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
                : throw CliException.Usage("--retraction needs a length of 0 to 1000."),
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
        if (parts.Length > 3) throw CliException.Usage("--decimals needs at most three numbers: for X, Y and Z, for E and for F.");
        for (var i = 0; i < parts.Length; i++)
        {
            decimals[i] = NumberReader.TryParseInt(parts[i].Trim(), out var count) && count is >= 0 and <= 9 ? count
                : throw CliException.Usage("--decimals needs whole numbers from 0 to 9, such as 3,5,0.");
        }
        return decimals;
    }

    private double Tolerance(ParseResult arguments)
        => arguments.GetValue(_tolerance) is > 0 and < 1000 and var tolerance ? tolerance
            : throw CliException.Usage("--tolerance needs a length above 0 and below 1000 mm.");
}
