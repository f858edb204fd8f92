namespace Caterpillar.GH.Components.Design;

/// <summary>Makes a turtle program from a script, from commands, or from both.</summary>
public sealed class TurtleProgramComponent() : CaterpillarComponent(
    "Turtle Program", "Program", "Creates a turtle program from a script or from commands. If both are given, the script runs first.", Panel.Design)
{
    public override Guid ComponentGuid => new("6f4c2a10-0d83-4c6d-8e51-8a2a3f6b1c11");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Text("Script", "S", "Script of turtle commands. Items of a list are its lines.", access: GH_ParamAccess.list, optional: true);
        ports.Add(new TurtleCommandParam(), "Commands", "C", "Turtle commands, in order.", GH_ParamAccess.list, optional: true);
        ports.Text("Variables", "V", "Values of the script's parameters, as name=value.", access: GH_ParamAccess.list, optional: true);
        ports.Seed();
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new TurtleProgramParam(), "Program", "P", "Turtle program, for Turtle.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var lines = run.List<string>(0);
        var commands = run.List<TurtleCommand>(1);
        if (lines.Count == 0 && commands.Count == 0) throw new InputProblem("Script or Commands is missing.") { IsMissing = true };
        var programs = new List<TurtleProgram>();
        if (lines.Count > 0)
        {
            var script = run.Require(TurtleScript.Compile(string.Join("\n", lines), null, new ScriptFiles(run.PathTo("."))));
            programs.Add(TurtleProgram.FromScript(script, Variables(run.List<string>(2), script, run), run.Get<int>(3)));
        }
        if (commands.Count > 0) programs.Add(TurtleProgram.FromCommands(commands));
        run.Set(0, new TurtleProgramGoo { Value = programs.Count == 1 ? programs[0] : TurtleProgram.Sequence(programs) });
    }

    private static Dictionary<string, double> Variables(IEnumerable<string> texts, TurtleScript script, Run run)
    {
        var variables = new Dictionary<string, double>();
        foreach (var text in texts)
        {
            var cut = text.IndexOf("=", StringComparison.Ordinal);
            if (cut < 1 || !NumberReader.TryParse(text.Substring(cut + 1).Trim(), out var value))
                throw new InputProblem($"Variables: expected name=value, not '{text}'.");
            var name = text.Substring(0, cut).Trim();
            if (!script.Parameters.Contains(name))
                run.Report(GH_RuntimeMessageLevel.Warning, $"The script has no parameter '{name}'. Declare it: param {name} = …");
            else
                variables[name] = value;
        }
        return variables;
    }
}
