namespace Caterpillar.Display;

/// <summary>The data of a viewer page besides its columns, as JSON: layers, events, tools, printer, findings and colors.</summary>
internal static class PageHead
{
    public static string ToJson(ViewerContent content, MoveColumns? moves)
    {
        var toolpath = content.Toolpath;
        var head = Json.Object(
            ("title", content.Title),
            ("limits", content.Limits),
            ("timed", content.EndOf is not null),
            ("source", content.GCode is null && toolpath?.Source == MoveSource.Steps ? "step" : "line"),
            ("shape", content.Shape.ToString()),
            ("density", Number(content.Density)),
            ("rows", moves?.Rows),
            ("moves", toolpath?.Count),
            ("start", toolpath is null ? null : Point(toolpath.Start ?? Vec3.Zero)),
            ("columns", moves is null ? null : new JArray(moves.All.Select(c => c.Name))),
            ("layers", toolpath is null ? null : new JArray(toolpath.Layers.Select(l => new JArray(l.Index, Number(l.Z), Number(l.Thickness), l.Object)))),
            ("events", toolpath is null ? null : new JArray(toolpath.Events.Select(e => Event(moves!.RowOf(e.Move), e.Event)).OfType<JArray>())),
            ("printer", content.Printer is { } printer ? Printer(printer) : null),
            ("findings", new JArray(content.Findings.Select(f => Finding(f, moves)))),
            ("roles", new JArray(Enum.GetValues(typeof(Role)).Cast<Role>().Select(r => new JArray(Words.Spaced(r.ToString()), Hex(Palette.Of(r)))))),
            ("kinds", new JArray(Enum.GetNames(typeof(MoveKind)).Select(Words.Spaced))),
            ("travelColor", Hex(Palette.Travel)),
            ("scale", new JArray(Enumerable.Range(0, 5).Select(i => Hex(Palette.At(i / 4.0))))));
        using var text = new StringWriter(CultureInfo.InvariantCulture) { NewLine = "\n" };
        using var json = new JsonTextWriter(text) { StringEscapeHandling = StringEscapeHandling.EscapeHtml };
        head.WriteTo(json);
        return text.ToString();
    }

    private static JArray? Event(int row, PrinterEvent happening) => happening switch
    {
        NozzleTemperatureEvent nozzle => new JArray(row, "nozzle", Number(nozzle.Celsius)),
        BedTemperatureEvent bed => new JArray(row, "bed", Number(bed.Celsius)),
        FanEvent fan => new JArray(row, "fan", Number(fan.Speed)),
        AccelerationEvent acceleration => new JArray(row, "acceleration", Number(acceleration.Value)),
        PauseEvent => new JArray(row, "pause", 0),
        _ => null,
    };

    private static JObject Printer(Machines.Printer printer) => Json.Object(
        ("title", printer.Title),
        ("min", Point(printer.BuildBounds.Min)),
        ("max", Point(printer.BuildBounds.Max)),
        ("round", printer.BedShape != Machines.BedShape.Rectangle),
        ("head", new JArray(printer.HeadOutline.SelectMany(p => new[] { Number(p.Radius), Number(p.Height) }))),
        ("boxes", new JArray(printer.HeadBoxes.SelectMany(b => Point(b.Min).Concat(Point(b.Max))))),
        ("excluded", new JArray(printer.ExcludedAreas.SelectMany(b => Point(b.Min).Concat(Point(b.Max))))));

    private static JObject Finding(Diagnostic finding, MoveColumns? moves) => Json.Object(
        ("severity", finding.Severity.ToString()),
        ("code", finding.Code),
        ("message", finding.Message),
        ("place", finding.Source?.ToString() ?? ""),
        ("count", finding.Count),
        ("row", moves is not null && finding.Source?.Move is { } move ? moves.RowOf(move) : null),
        ("line", finding.Source?.Line));

    private static string Hex(Rgb color) => "#" + color.R.ToString("x2", CultureInfo.InvariantCulture)
        + color.G.ToString("x2", CultureInfo.InvariantCulture) + color.B.ToString("x2", CultureInfo.InvariantCulture);

    private static JArray Point(Vec3 point) => new(Number(point.X), Number(point.Y), Number(point.Z));

    private static JToken Number(double value) => Json.Number(double.IsNaN(value) || double.IsInfinity(value) ? 0 : value);
}
