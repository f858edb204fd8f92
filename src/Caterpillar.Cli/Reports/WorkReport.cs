namespace Caterpillar.Cli;

/// <summary>Report of a plan and its output file as JSON, in mm, mm³ and bytes.</summary>
internal static class WorkReport
{
    /// <param name="inputs">The input files.</param>
    /// <param name="output">The output file.</param>
    /// <param name="counts">Counts of the verb, which come first.</param>
    /// <param name="plan">The plan.</param>
    /// <param name="written">The written file and the findings of the checks.</param>
    public static string ToJson(
        IReadOnlyList<string> inputs, string output, IEnumerable<KeyValuePair<string, double>> counts, Plan plan, WrittenFile written)
    {
        // Material as the file extrudes it, with start and end code.
        var deposited = ToolpathTotals.Of(written.GCode.File ?? plan.Toolpath).DepositedVolume ?? 0;
        var arcs = plan.Toolpath.Moves().Count(m => m.Kind == MoveKind.Print && m.Arc is not null);
        KeyValuePair<string, double>[] numbers =
        [
            .. counts, new("moves", plan.Toolpath.Count), new("arcs", arcs), new("printed_mm", ToolpathTotals.Of(plan.Toolpath).PrintLength),
            new("deposited_mm3", deposited), .. plan.Report.ToValues(), new("lines", written.GCode.Lines), new("bytes", written.GCode.Bytes),
        ];
        return Json.Text(Json.Object(
        [
            inputs.Count == 1 ? ("file", inputs[0]) : ("files", new JArray(inputs)), ("output", output),
            .. numbers.Select(n => (n.Key, (JToken?)Json.Number(n.Value))), ("findings", FindingSummary.ToJson(written.Findings)),
        ]));
    }
}
