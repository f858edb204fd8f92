namespace Caterpillar.Cli;

/// <summary>Measures exact plane sections of models.</summary>
internal sealed class SectionsVerb : Verb
{
    private const int MaxHeights = 1_000_000;

    private readonly Argument<string[]> _models = new("MODEL")
    {
        Description = CommonOptions.MeshInput,
        Arity = ArgumentArity.OneOrMore,
    };

    private readonly Described<string?> _heights = new("--heights", "Heights of the planes, in mm.", "Z,Z,...");

    private readonly Described<string?> _every = new("--every",
        "Distance of planes, instead of --heights. The first is at half of it above Z = 0.", "MM");

    private readonly Described<string> _gap = new("--gap",
        "Widest gap to close in contours of broken meshes.",
        "MM") { DefaultValueFactory = _ => NumberFormatter.Format(new SectionOptions().GapMm, 9) };

    private readonly Described<bool> _json = new("--json", "Print JSON instead of a table.");

    private readonly Described<string> _output = new("--output", "Output file; - = standard output.", "FILE", "-o") { DefaultValueFactory = _ => "-" };

    public SectionsVerb()
        : base("sections", "Measure exact plane sections of models: length, area and contours.", ["JSON", "a table"])
    {
        Arguments.Add(_models);
        Add([_heights, _every, _gap, _json, _output]);
    }

    public override int Run(ParseResult arguments, Session session)
    {
        var heights = Heights(arguments);
        var every = heights is null ? Every(arguments) : 0;
        var options = new SectionOptions { GapMm = Numbers.AtLeast(arguments.GetValue(_gap)!, "--gap", 0) };
        var reports = new List<SectionReport>();
        foreach (var model in arguments.GetValue(_models)!)
        {
            var bytes = session.ReadBytes(model);
            var name = Session.NameOf(model);
            var report = session.WithProgress(name, progress => Measure(bytes, name, model, heights, every, options, progress, session));
            reports.Add(session.ValueOrFail(report));
        }
        session.WriteText(arguments.GetValue(_output)!, text =>
        {
            if (arguments.GetValue(_json)) text.Write(SectionReport.ToJson(reports));
            else TextTable.Write(text, Table(reports));
        });
        return ExitCode.Done;
    }

    private static Result<SectionReport> Measure(
        byte[] bytes, string name, string model, double[]? heights, double every, SectionOptions options, IProgress<double>? progress, Session session)
    {
        var read = MeshReader.Read(bytes, name, new MeshReadOptions { Memory = session.Memory }, progress.Part(0, 0.5), session.Cancel);
        if (read.Value is null) return new Result<SectionReport>(null, read.Diagnostics);
        var mesh = TriMesh.Merge(read.Value.Select(m => m.Mesh));
        var report = SectionReport.Of(model, mesh, heights ?? Middles(mesh.Bounds.Max.Z, every), options, progress.Part(0.5, 1), session.Cancel);
        return new Result<SectionReport>(report.Value, [.. read.Diagnostics, .. report.Diagnostics]);
    }

    private double[]? Heights(ParseResult arguments)
    {
        var text = arguments.GetValue(_heights);
        if (text is null) return null;
        if (arguments.GetValue(_every) is not null) throw CliException.Usage("--heights cannot be combined with --every.");
        return text.Split(',').Select(word => Numbers.AtLeast(word.Trim(), "--heights", double.NegativeInfinity)).ToArray();
    }

    private double Every(ParseResult arguments)
    {
        var text = arguments.GetValue(_every) ?? throw CliException.Usage("The planes are missing. Give --heights 0.1,0.3 or --every 0.2.");
        var every = Numbers.AtLeast(text, "--every", 0);
        return every > 0 ? every : throw CliException.Usage("--every must be above 0.");
    }

    private static double[] Middles(double top, double every)
    {
        var count = top > 0 ? Math.Ceiling(top / every - 0.5) : 0;
        if (count > MaxHeights)
            throw CliException.Usage($"--every {NumberFormatter.Format(every, 9)} gives more than {NumberFormatter.Format(MaxHeights)} planes.");
        return Enumerable.Range(0, (int)Math.Max(0, count)).Select(i => (i + 0.5) * every).ToArray();
    }

    private static List<string[]> Table(List<SectionReport> reports)
    {
        var rows = new List<string[]>();
        foreach (var report in reports)
        {
            if (rows.Count > 0) rows.Add([]);
            rows.Add([report.Model]);
            rows.Add(["Z mm", "LENGTH mm", "AREA mm²", "OUTER", "HOLES", "OPEN ENDS"]);
            foreach (var s in report.Sections)
            {
                rows.Add([
                    NumberFormatter.Format(s.Z, 6), NumberFormatter.Format(s.Length, 6), NumberFormatter.Format(s.Area, 6),
                    NumberFormatter.Format(s.Outer), NumberFormatter.Format(s.Holes), NumberFormatter.Format(s.Open),
                ]);
            }
        }
        return rows;
    }
}
