using System.IO;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using Newtonsoft.Json;

namespace Caterpillar.Cli.Commands;

/// <summary>What the curves verb says about its work as JSON: mm, mm³, bytes.</summary>
internal static class CurvesReport
{
    public static string ToJson(string file, string target, int curves, Plan plan, WrittenGCode written)
    {
        using var text = new StringWriter { NewLine = "\n" };
        using var json = new JsonTextWriter(text) { Formatting = Formatting.Indented };
        json.WriteStartObject();
        void Number(string key, double value)
        {
            json.WritePropertyName(key);
            json.WriteRawValue(NumberFormatter.Format(value, 6));
        }
        double printed = 0, deposited = 0;
        var arcs = 0;
        foreach (var move in plan.Toolpath.Moves())
        {
            if (move.Kind != MoveKind.Print) continue;
            printed += move.Length;
            deposited += plan.Toolpath.VolumeOf(move) ?? 0;
            if (move.Arc is not null) arcs++;
        }
        json.WritePropertyName("file");
        json.WriteValue(file);
        json.WritePropertyName("output");
        json.WriteValue(target);
        Number("curves", curves);
        Number("moves", plan.Toolpath.Count);
        Number("arcs", arcs);
        Number("printed_mm", printed);
        Number("deposited_mm3", deposited);
        foreach (var value in plan.Report.ToValues()) Number(value.Key, value.Value);
        Number("lines", written.Lines);
        Number("bytes", written.Bytes);
        json.WriteEndObject();
        json.Flush();
        return text + "\n";
    }
}
