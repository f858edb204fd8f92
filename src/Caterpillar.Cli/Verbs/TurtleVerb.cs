namespace Caterpillar.Cli;

/// <summary>Runs a turtle program and writes its G-code.</summary>
internal sealed class TurtleVerb : Verb
{
    private readonly Argument<string> _script =
        new("SCRIPT") { Description = "Turtle program (see docs/turtle.md); - = standard input." };

    private readonly Described<string[]> _values = new("--var", "Value of a parameter of the program (param NAME = ...). Repeatable.", "NAME=VALUE");

    private readonly Described<int> _seed = new("--seed", "Random seed.", "N") { DefaultValueFactory = _ => 0 };

    private readonly Described<string> _plan = CommonOptions.Plan("drawn");

    private readonly Described<string[]> _folders = new("--include",
        "Another folder with files that the program may include or read as images. Repeatable.", "FOLDER");

    private readonly OntoOptions _onto = new();

    private readonly Described<bool> _commands = new("--commands", "List the commands of the language.");

    private readonly WriteOptions _write = new();

    private readonly SetupOptions _setup = new("Default: set by the program, or generic.");

    public TurtleVerb()
        : base("turtle", "Turn a turtle program or L-system into G-code.", ["G-code"], ".gcode")
    {
        _script.Arity = ArgumentArity.ZeroOrOne;
        Arguments.Add(_script);
        Add([.. _write.All, _values, _seed, _plan, _folders, _commands, .. _onto.OfDrawings, .. _setup.All]);
        AllowBatches();
    }

    public override int Run(ParseResult arguments, Session session)
    {
        if (arguments.GetValue(_commands))
        {
            session.WriteText("-", text => TextTable.Write(text,
                TurtleCommands.All.Select(c => new[] { c.Usage, c.Help, string.Join(" ", c.Aliases) }).ToList()));
            return ExitCode.Done;
        }
        var file = arguments.GetValue(_script) ?? throw CliException.Usage("The turtle program is missing. See: caterpillar turtle --help");
        _onto.Check(arguments);
        var target = _write.FileFor(arguments, file);
        var variables = Variables(arguments.GetValue(_values) ?? []);
        var text = Encoding.UTF8.GetString(session.ReadBytes(file));
        var script = session.ValueOrFail(TurtleScript.Compile(text, Session.NameOf(file), Files(file, arguments.GetValue(_folders) ?? [])));
        var setup = _setup.Resolve(arguments, session, script.Profiles);
        var limits = new TurtleLimits { Memory = session.Memory };
        var run = session.WithProgress("Turtle",
            progress => script.Run(TurtleOptions.For(setup), variables, arguments.GetValue(_seed), limits, progress, session.Cancel));
        foreach (var line in run.Diagnostics.Where(d => d.Code == TurtleScript.PrintCode)) session.Messages.WriteLine(line.Message);
        var turtle = session.ValueOrFail(new Result<Turtle>(run.Value, [.. run.Diagnostics.Where(d => d.Code != TurtleScript.PrintCode)]));
        var options = new PrintJobOptions
        {
            Policy = arguments.GetValue(_plan) == "printer" ? PlanPolicy.Printer : PlanPolicy.AsDrawn, Memory = session.Memory,
        };
        using var job = _onto.Draw(arguments, turtle.ToSteps(), setup, options, session);
        if (job.Toolpath.Count == 0) throw new CliException(ExitCode.BadInput, $"{Session.NameOf(file)}: the program prints nothing.");
        _write.Write(arguments, session, job, target);
        return ExitCode.Done;
    }

    private static ScriptFiles Files(string script, string[] more)
    {
        foreach (var folder in more.Where(f => !Directory.Exists(f))) throw CliException.Usage($"--include {folder}: folder not found.");
        return new ScriptFiles([script == "-" ? "." : Path.GetDirectoryName(Path.GetFullPath(script))!, .. more]);
    }

    private static Dictionary<string, double> Variables(IEnumerable<string> values)
    {
        var variables = new Dictionary<string, double>();
        foreach (var text in values)
        {
            var cut = text.IndexOf('=');
            if (cut < 1 || !NumberReader.TryParse(text[(cut + 1)..].Trim(), out var value)) throw CliException.Usage($"--var {text}: expected NAME=NUMBER.");
            if (!variables.TryAdd(text[..cut].Trim(), value)) throw CliException.Usage($"--var {text}: this parameter already has a value.");
        }
        return variables;
    }
}
