namespace Caterpillar.GH.Components.Design;

/// <summary>Grows an L-system into a turtle program.</summary>
public sealed class LSystemComponent() : CaterpillarComponent(
    "L-System", "LSys", "Grows a word by rules and turns it into a turtle program. F draws, f moves without drawing, + - ^ & \\ / | turn, [ and ] branch and "
        + "return.", Panel.Design)
{
    // A longer word is shown shortened.
    private const int ShownLetters = 100_000;

    public override Guid ComponentGuid => new("e90b7d86-5a0c-4f1e-b6a4-1d4f9e7c3a14");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Text("Axiom", "A", "Word of generation 0. Example: F.");
        ports.Text("Rules", "R", "Rewriting rules. Example: F -> F[+F]F[-F]F. Rules may have a probability (0.3 F -> FF) or values (A(l) : l > 1 -> "
            + "F(l)A(l*0.7)).", access: GH_ParamAccess.list);
        ports.Integer("Generations", "G", "Number of times the word is rewritten.");
        ports.Angle("Angle", "An", "Turning angle of + - ^ & \\ /, in degrees.", 90);
        ports.Seed();
        ports.Number("Step", "St", "Length of F and f, in mm.", 1);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new TurtleProgramParam(), "Program", "P", "Turtle program that draws the word, for Turtle.");
        ports.Text("Text", "T", "Grown word. Long words are cut off.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var axiom = run.Get<string>(0);
        var rules = run.List<string>(1);
        var generations = run.Get<int>(2);
        if (generations < 0) throw new InputProblem("Generations must be 0 or more.");
        var (step, angle) = (run.Finite(5), run.Finite(3));
        var seed = run.Get<int>(4);
        var system = run.Require(LSystem.Parse(axiom, rules));
        var word = run.Require(run.Work("Growing", [axiom, string.Join("\n", rules), generations, seed],
            (progress, cancel) => system.Grow(generations, seed, LSystem.DefaultMaxSymbols, progress, cancel)));
        run.Set(0, new TurtleProgramGoo { Value = run.Cached([word, step, angle], () => TurtleProgram.FromWord(word, step, angle)) });
        var text = word.ToString();
        run.Set(1, text.Length > ShownLetters ? text.Substring(0, ShownLetters) + "…" : text);
    }
}
