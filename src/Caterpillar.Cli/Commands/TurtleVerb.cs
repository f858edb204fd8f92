using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;

namespace Caterpillar.Cli.Commands;

/// <summary>Runs a turtle program and writes its G-code.</summary>
internal sealed class TurtleVerb : Verb
{
    private readonly Argument<string> _script = new("SCRIPT") { Description = "Turtle program (docs/turtle.md is the manual of the language); - is standard input." };

    private readonly Option<string?> _out = new("--output", "-o") { Description = "G-code file; - is standard output. Without it the script's name with .gcode in the current folder.", HelpName = "FILE" };

    private readonly Option<string[]> _values = new("--var") { Description = "Value of a parameter of the script (param NAME = …).", HelpName = "NAME=VALUE" };

    private readonly Option<int> _seed = new("--seed") { Description = "Seed of random().", DefaultValueFactory = _ => 0 };

    private readonly Option<string> _plan = new("--plan") { Description = "\"drawn\": exactly what the turtle did; \"printer\": with the printer's retraction and lifts.", DefaultValueFactory = _ => "drawn" };

    private readonly Option<string?> _reason = new("--override") { Description = "Writes in spite of what the checks found; the reason stays in the file as a comment.", HelpName = "REASON" };

    private readonly Option<bool> _commands = new("--commands") { Description = "List the commands of the language." };

    private readonly SetupOptions _setup = new();

    public TurtleVerb()
        : base("turtle", "A turtle program or L-system to G-code.")
    {
        _script.Arity = ArgumentArity.ZeroOrOne;
        _plan.AcceptOnlyFromAmong("drawn", "printer");
        Arguments.Add(_script);
        Options.Add(_out);
        Options.Add(_values);
        Options.Add(_seed);
        Options.Add(_plan);
        Options.Add(_reason);
        Options.Add(_commands);
        _setup.AddTo(this);
    }

    public override int Run(ParseResult arguments, Session session)
    {
        if (arguments.GetValue(_commands))
        {
            session.WriteText("-", text => TextTable.Write(text, TurtleCommands.All.Select(c => new[] { c.Usage, c.Help, string.Join(" ", c.Aliases) }).ToList()));
            return ExitCode.Done;
        }
        var file = arguments.GetValue(_script) ?? throw new CliException(ExitCode.Usage, "A script is missing. See: caterpillar turtle --help");
        var variables = Variables(arguments.GetValue(_values) ?? []);
        var setup = _setup.Resolve(arguments, session);
        var script = session.Need(TurtleScript.Compile(Encoding.UTF8.GetString(session.ReadBytes(file)), Session.NameOf(file)));
        var options = new TurtleOptions { Extrusion = setup.Extrusion };
        var turtle = session.Long("Turtle", progress => session.Need(script.Run(options, variables, arguments.GetValue(_seed), null, progress, session.Cancel)));
        var policy = arguments.GetValue(_plan) == "printer" ? PlanPolicy.Printer : PlanPolicy.AsDrawn;
        var toolpath = session.Long("Planning", progress => session.Need(Planner.Plan(turtle.ToSteps(), setup, new PlanOptions { Policy = policy }, progress, session.Cancel)));
        if (toolpath.Count == 0) throw new CliException(ExitCode.BadInput, $"{Session.NameOf(file)}: the program draws nothing.");
        Write(toolpath, setup, arguments, file, session);
        return ExitCode.Done;
    }

    private void Write(Toolpath toolpath, PrintSetup setup, ParseResult arguments, string file, Session session)
    {
        var target = arguments.GetValue(_out) ?? (file == "-" ? "turtle" : Path.GetFileNameWithoutExtension(file)) + ".gcode";
        var reason = arguments.GetValue(_reason);
        if (target != "-" && Path.GetFullPath(target) == Path.GetFullPath(file)) throw new CliException(ExitCode.Usage, "The G-code would replace the script.");
        session.Write(target, stream => session.Long("Writing", progress => session.Need(SafeWriter.Write(toolpath, setup, stream, reason, progress, session.Cancel), ExitCode.Refused)));
    }

    private static Dictionary<string, double> Variables(IEnumerable<string> values)
    {
        var variables = new Dictionary<string, double>();
        foreach (var text in values)
        {
            var cut = text.IndexOf('=');
            if (cut < 1 || !NumberReader.TryParse(text[(cut + 1)..].Trim(), out var value)) throw new CliException(ExitCode.Usage, $"--var {text}: write NAME=VALUE with a number.");
            variables[text[..cut].Trim()] = value;
        }
        return variables;
    }
}
