namespace Caterpillar.Display;

/// <summary>The data of a viewer page besides its columns, as JSON: layers, events, tools, printer, findings and colors.</summary>
internal static class PageHead
{
    public static string ToJson(ViewerContent content, MoveColumns? moves)
    {
        using var text = new StringWriter(CultureInfo.InvariantCulture) { NewLine = "\n" };
        using (var json = new JsonTextWriter(text) { StringEscapeHandling = StringEscapeHandling.EscapeHtml })
        {
            json.WriteStartObject();
            json.Entry("title", content.Title);
            json.Entry("limits", content.Limits);
            json.Entry("timed", content.EndOf is not null);
            json.Entry("source", content.GCode is not null ? "line" : content.Toolpath?.Source == MoveSource.Steps ? "step" : "line");
            json.Entry("shape", content.Shape.ToString());
            Number(json, "density", content.Density);
            if (content.Toolpath is { } toolpath) Toolpath(json, toolpath, moves!);
            if (content.Printer is { } printer) Printer(json, printer);
            Findings(json, content, moves);
            Colors(json);
            json.WriteEndObject();
        }
        return text.ToString();
    }

    private static void Toolpath(JsonTextWriter json, Toolpath toolpath, MoveColumns moves)
    {
        Number(json, "rows", moves.Rows);
        Number(json, "moves", toolpath.Count);
        Array(json, "start", Numbers(toolpath.Start ?? Vec3.Zero));
        Array(json, "columns", moves.All.Select(c => c.Name));
        json.Entry("layers", () => json.List(toolpath.Layers, layer =>
        {
            json.WriteStartArray();
            json.WriteValue(layer.Index);
            Value(json, layer.Z);
            Value(json, layer.Thickness);
            json.WriteValue(layer.Object);
            json.WriteEndArray();
        }));
        Events(json, toolpath, moves);
    }

    private static void Events(JsonTextWriter json, Toolpath toolpath, MoveColumns moves)
    {
        json.WritePropertyName("events");
        json.WriteStartArray();
        foreach (var (move, happening) in toolpath.Events)
        {
            (string Name, double Value)? entry = happening switch
            {
                NozzleTemperatureEvent nozzle => ("nozzle", nozzle.Celsius),
                BedTemperatureEvent bed => ("bed", bed.Celsius),
                FanEvent fan => ("fan", fan.Speed),
                AccelerationEvent acceleration => ("acceleration", acceleration.Value),
                PauseEvent => ("pause", 0),
                _ => null,
            };
            if (entry is not { } known) continue;
            json.WriteStartArray();
            json.WriteValue(moves.RowOf(move));
            json.WriteValue(known.Name);
            Value(json, known.Value);
            json.WriteEndArray();
        }
        json.WriteEndArray();
    }

    private static void Printer(JsonTextWriter json, Machines.Printer printer)
    {
        json.WritePropertyName("printer");
        json.WriteStartObject();
        json.Entry("title", printer.Title);
        Array(json, "min", Numbers(printer.BuildBounds.Min));
        Array(json, "max", Numbers(printer.BuildBounds.Max));
        json.Entry("round", printer.BedShape != Machines.BedShape.Rectangle);
        Array(json, "head", printer.HeadOutline.SelectMany(p => new[] { p.Radius, p.Height }).Select(NumberText));
        Array(json, "boxes", printer.HeadBoxes.SelectMany(b => Numbers(b.Min).Concat(Numbers(b.Max))));
        Array(json, "excluded", printer.ExcludedAreas.SelectMany(b => Numbers(b.Min).Concat(Numbers(b.Max))));
        json.WriteEndObject();
    }

    private static void Findings(JsonTextWriter json, ViewerContent content, MoveColumns? moves)
    {
        json.Entry("findings", () => json.List(content.Findings, finding => json.Object(() =>
        {
            json.Entry("severity", finding.Severity.ToString());
            json.Entry("code", finding.Code);
            json.Entry("message", finding.Message);
            json.Entry("place", finding.Source?.ToString() ?? "");
            json.Entry("count", finding.Count);
            if (moves is not null && finding.Source?.Move is { } move) json.Entry("row", moves.RowOf(move));
            json.Entry("line", finding.Source?.Line);
        })));
    }

    private static void Colors(JsonTextWriter json)
    {
        json.Entry("roles", () => json.List(
            Enum.GetValues(typeof(Role)).Cast<Role>(), role => json.List([Words.Spaced(role.ToString()), Hex(Palette.Of(role))], json.WriteValue)));
        Array(json, "kinds", Enum.GetNames(typeof(MoveKind)).Select(Words.Spaced));
        json.Entry("travelColor", Hex(Palette.Travel));
        Array(json, "scale", Enumerable.Range(0, 5).Select(i => Hex(Palette.At(i / 4.0))));
    }

    private static string Hex(Rgb color) => "#" + color.R.ToString("x2", CultureInfo.InvariantCulture)
        + color.G.ToString("x2", CultureInfo.InvariantCulture) + color.B.ToString("x2", CultureInfo.InvariantCulture);

    private static string[] Numbers(Vec3 point) => [NumberText(point.X), NumberText(point.Y), NumberText(point.Z)];

    private static string NumberText(double value) => NumberFormatter.Format(double.IsNaN(value) || double.IsInfinity(value) ? 0 : value, 6);

    private static void Value(JsonTextWriter json, double value) => json.WriteRawValue(NumberText(value));

    private static void Number(JsonTextWriter json, string name, double value) => json.Entry(name, () => Value(json, value));

    // Numbers come as text of our formatter, other texts are quoted.
    private static void Array(JsonTextWriter json, string name, System.Collections.Generic.IEnumerable<string> values)
        => json.Entry(name, () => json.List(values, value =>
        {
            if (NumberReader.TryParse(value, out _)) json.WriteRawValue(value);
            else json.WriteValue(value);
        }));
}
