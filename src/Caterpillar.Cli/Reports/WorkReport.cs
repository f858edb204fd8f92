using Newtonsoft.Json;

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
        using var text = new StringWriter { NewLine = "\n" };
        using var json = new JsonTextWriter(text) { Formatting = Formatting.Indented };
        json.WriteStartObject();
        void Number(string key, double value) => json.Entry(key, () => json.WriteRawValue(NumberFormatter.Format(value, 6)));
        // Material as the file extrudes it, with start and end code.
        var deposited = ToolpathTotals.Of(written.GCode.File ?? plan.Toolpath).DepositedVolume ?? 0;
        var arcs = plan.Toolpath.Moves().Count(m => m.Kind == MoveKind.Print && m.Arc is not null);
        if (inputs.Count == 1) json.Entry("file", inputs[0]);
        else json.Entry("files", () => json.List(inputs, json.WriteValue));
        json.Entry("output", output);
        foreach (var count in counts) Number(count.Key, count.Value);
        Number("moves", plan.Toolpath.Count);
        Number("arcs", arcs);
        Number("printed_mm", ToolpathTotals.Of(plan.Toolpath).PrintLength);
        Number("deposited_mm3", deposited);
        foreach (var value in plan.Report.ToValues()) Number(value.Key, value.Value);
        Number("lines", written.GCode.Lines);
        Number("bytes", written.GCode.Bytes);
        json.Entry("findings", () => FindingSummary.Write(json, written.Findings));
        json.WriteEndObject();
        json.Flush();
        return text + "\n";
    }
}
