namespace Caterpillar.Cli;

/// <summary>Checks G-code files against a printer.</summary>
internal sealed class CheckVerb : Verb
{
    private readonly Argument<string[]> _files = new("FILE")
    {
        Description = CommonOptions.GCodeInput,
        Arity = ArgumentArity.OneOrMore,
    };

    private readonly Option<string?> _flavor = CommonOptions.Flavor();
    private readonly Described<string?> _onto = new("--onto",
        "Object that is printed on, at its position in the file. It supports extrusions, and collisions with it are reported.", "FILE");

    private readonly SetupOptions _setup = new("Default: the setup in the file, or generic.");
    private readonly Option<int> _threads = CommonOptions.Threads();
    private readonly Described<bool> _json = new("--json", "Print the findings as a JSON array.");

    public CheckVerb()
        : base("check", "Check G-code files against a printer: print area, collisions, extrusions, speeds, flow and temperatures.")
    {
        Arguments.Add(_files);
        Add([.. _setup.All, _flavor, _onto, _threads, _json]);
        AllowBatches();
    }

    public override int Run(ParseResult arguments, Session session)
    {
        var setup = _setup.Resolve(arguments, session);
        if (arguments.GetValue(_onto) is { } onto) setup = setup with { PrintedOn = Meshes.ReadAsOne(onto, session) };
        var isChosen = _setup.IsGiven(arguments) || arguments.GetValue(_setup.Settings) is not null;
        var options = CommonOptions.Decoding(arguments.GetValue(_flavor), setup.Material.FilamentDiameter, arguments.GetValue(_threads), session);
        var all = new List<Diagnostic>();
        var used = new List<string>();
        var harmless = new List<Diagnostic>();
        foreach (var file in arguments.GetValue(_files)!)
        {
            var name = Session.NameOf(file);
            var decoded = Decoded(file, options, session, harmless);
            var written = isChosen ? null : FileSetup.Of(decoded.Settings);
            var own = written is null ? setup : _setup.Changed(written, arguments, session) with { PrintedOn = setup.PrintedOn };
            used.Add(written is null ? own.Printer.Title : $"{own.Printer.Title}, the printer of the setup in the file");
            all.AddRange(session.WithProgress("Checking " + name, progress => PrintCheck.Run(decoded, own, progress, session.Cancel)));
        }
        session.WriteText("-", text =>
        {
            if (arguments.GetValue(_json)) text.Write(Json.Text(FindingSummary.ToJson(all)));
            else all.ForEach(finding => text.WriteLine(finding.ToString()));
        });
        session.Found(all);
        session.Say(() => $"{(all.Count == 0 ? "Nothing found. " : "")}Checked for {string.Join("; ", used.Distinct())}.");
        foreach (var note in harmless) session.Say(note.ToString);
        return all.Any(d => d.Severity == Severity.Error) ? ExitCode.Refused : ExitCode.Done;
    }

    private static DecodedGCode Decoded(string file, DecodeOptions options, Session session, List<Diagnostic> harmless)
    {
        var decoded = session.Read(file, options);
        harmless.AddRange(decoded.Diagnostics.Where(d => d.Code == Session.Harmless));
        // The check says it with its severity.
        return session.GCodeOrFail(new Result<DecodedGCode>(decoded.Value, decoded.Diagnostics.Where(d => d.Code != CommandLog.NotUnderstood).ToArray()));
    }
}
