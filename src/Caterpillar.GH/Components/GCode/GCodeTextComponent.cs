namespace Caterpillar.GH.Components.GCode;

/// <summary>Some lines of a G-code file as text.</summary>
public sealed class GCodeTextComponent() : CaterpillarComponent(
    "G-code Text", "Text", "Shows some lines of G-code as text, so that wires and panels stay light.", Panel.GCode, GH_Exposure.secondary)
{
    // A Panel cannot show more.
    private const int MaxLines = 100_000;

    public override Guid ComponentGuid => new("acfddb64-0be4-4f60-8e9f-0c1eb22c20ce");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new GCodeParam(), "G-code", "G", "G-code to show.");
        ports.Integer("Start", "S", "First line, from 1. Negative numbers count from the end.", 1);
        ports.Integer("Count", "N", "Number of lines, at most 100000.", 200);
    }

    private protected override void Outputs(OutputPorts ports) => ports.Text("Lines", "L", "Lines of G-code.", GH_ParamAccess.list);

    private protected override void Solve(Run run)
    {
        var document = run.Get<GCodeDocument>(0);
        var (start, count) = (run.Get<int>(1), run.Get<int>(2));
        if (start == 0) throw new InputProblem("Start must be 1 or more, or -1 or less to count from the end.");
        if (count is < 0 or > MaxLines) throw new InputProblem($"Count must be from 0 to {NumberFormatter.Format(MaxLines)}.");
        var first = start > 0 ? start : Math.Max(1, document.LineCount + start + 1);
        run.SetList(0, document.Lines(first, count));
    }
}
