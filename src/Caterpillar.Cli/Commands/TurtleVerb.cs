using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Planning;
using Caterpillar.Turtles;

namespace Caterpillar.Cli.Commands;

/// <summary>Runs a turtle program and writes its G-code.</summary>
internal sealed class TurtleVerb : Verb
{
    private readonly Argument<string> _script =
        new("SCRIPT") { Description = "Turtle program (the language is in docs/turtle.md); - is standard input." };

    private readonly Option<string[]> _values = new("--var") { Description = "Value for a parameter of the script (param NAME = …).", HelpName = "NAME=VALUE" };

    private readonly Option<int> _seed = new("--seed") { Description = "Seed of random().", DefaultValueFactory = _ => 0 };

    private readonly Option<string> _plan =
        new("--plan") { Description = "\"drawn\": exactly what the turtle does; \"printer\": with the printer's retraction and lifts.",
        DefaultValueFactory = _ => "drawn" };

    private readonly Option<string[]> _folders = new("--include")
    {
        Description = "A folder whose files the script may include or read as images, besides its own.", HelpName = "FOLDER",
    };

    private readonly OntoOptions _onto = new(OntoOptions.Drawn, OntoOptions.DrawnPartial);

    private readonly Option<bool> _commands = new("--commands") { Description = "List the commands of the language." };

    private readonly WriteOptions _write = new();

    private readonly SetupOptions _setup = new();

    public TurtleVerb()
        : base("turtle", "Turn a turtle program or L-system into G-code.")
    {
        _script.Arity = ArgumentArity.ZeroOrOne;
        _plan.AcceptOnlyFromAmong("drawn", "printer");
        Arguments.Add(_script);
        _write.AddTo(this);
        Options.Add(_values);
        Options.Add(_seed);
        Options.Add(_plan);
        Options.Add(_folders);
        Options.Add(_commands);
        _onto.AddTo(this);
        _setup.AddTo(this);
        AllowBatches();
    }

    public override IReadOnlyList<(string Line, string Does)> Examples =>
    [
        ("turtle star.turtle -o star.gcode", "a turtle program"),
        ("turtle star.turtle --var layers=4 --plan printer -o star4.gcode", "with a value of a parameter, retraction and lifts"),
        ("turtle star.turtle --table values.csv -o 'out/{row}.gcode' --summary study.csv", "a study: one print for each row of a table"),
        ("turtle --commands", "the commands of the language"),
    ];

    public override string[] Writes => ["G-code"];

    public override string? Ending => ".gcode";

    public override int Run(ParseResult arguments, Session session)
    {
        if (arguments.GetValue(_commands))
        {
            session.WriteText("-", text => TextTable.Write(text,
                TurtleCommands.All.Select(c => new[] { c.Usage, c.Help, string.Join(" ", c.Aliases) }).ToList()));
            return ExitCode.Done;
        }
        var file = arguments.GetValue(_script) ?? throw new CliException(ExitCode.Usage, "A script is missing. See: caterpillar turtle --help");
        _onto.Check(arguments);
        var target = _write.FileFor(arguments, file);
        var variables = Variables(arguments.GetValue(_values) ?? []);
        var text = Encoding.UTF8.GetString(session.ReadBytes(file));
        var script = session.ValueOrFail(TurtleScript.Compile(text, Session.NameOf(file), Files(file, arguments.GetValue(_folders) ?? [])));
        var setup = _setup.Resolve(arguments, session, script.Profiles);
        var options = new TurtleOptions
        {
            Extrusion = setup.Extrusion,
            Shape = setup.Settings.BeadShape,
            MaxLiftSpeed = setup.Printer.MaxSpeed.Z > 0 ? setup.Printer.MaxSpeed.Z : double.PositiveInfinity,
        };
        var limits = new TurtleLimits { Memory = session.Memory };
        var run = session.WithProgress("Turtle", progress => script.Run(options, variables, arguments.GetValue(_seed), limits, progress, session.Cancel));
        foreach (var line in run.Diagnostics.Where(d => d.Code == TurtleScript.PrintCode)) session.Messages.WriteLine(line.Message);
        var turtle = session.ValueOrFail(new Result<Turtle>(run.Value, [.. run.Diagnostics.Where(d => d.Code != TurtleScript.PrintCode)]));
        var policy = arguments.GetValue(_plan) == "printer" ? PlanPolicy.Printer : PlanPolicy.AsDrawn;
        (var steps, setup) = _onto.Apply(arguments, turtle.ToSteps(), setup, session);
        var planning = new PlanOptions { Policy = policy, Memory = session.Memory };
        var toolpath = session.WithProgress("Planning",
            progress => session.ValueOrFail(Planner.Plan(steps, setup, planning, progress, session.Cancel)));
        if (toolpath.Count == 0) throw new CliException(ExitCode.BadInput, $"{Session.NameOf(file)}: the program draws nothing.");
        return _write.Write(arguments, session, toolpath, setup, target);
    }

    private static ScriptFiles Files(string script, string[] more)
    {
        foreach (var folder in more.Where(f => !Directory.Exists(f))) throw new CliException(ExitCode.Usage, $"--include {folder}: there is no such folder.");
        return new ScriptFiles([script == "-" ? "." : Path.GetDirectoryName(Path.GetFullPath(script))!, .. more]);
    }

    private static Dictionary<string, double> Variables(IEnumerable<string> values)
    {
        var variables = new Dictionary<string, double>();
        foreach (var text in values)
        {
            var cut = text.IndexOf('=');
            if (cut < 1 || !NumberReader.TryParse(text[(cut + 1)..].Trim(), out var value))
            {
                throw new CliException(ExitCode.Usage, $"--var {text}: expected NAME=VALUE with a number.");
            }
            if (!variables.TryAdd(text[..cut].Trim(), value)) throw new CliException(ExitCode.Usage, $"--var {text}: this name already has a value.");
        }
        return variables;
    }
}
