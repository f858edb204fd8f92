namespace Caterpillar.Checks;

/// <summary>Lines at the head of a file that only the whole print tells: its time, images of it, and its objects with their outlines.</summary>
internal static class FileFacts
{
    /// <param name="toolpath">The print.</param>
    /// <param name="setup">Its setup.</param>
    /// <param name="format">The format of the file.</param>
    /// <param name="seconds">Print time in s; null = unknown.</param>
    /// <param name="cancel">Cancels.</param>
    public static IReadOnlyList<string> Of(Toolpath toolpath, PrintSetup setup, GCodeFormat format, double? seconds, CancellationToken cancel)
    {
        var lines = new List<string>();
        if (setup.Printer.ProgressCommands && seconds is { } time) lines.Add(";TIME:" + NumberFormatter.Format((long)Math.Round(time)));
        foreach (var size in setup.Printer.Thumbnails)
        {
            var (width, height) = ((int)size.X, (int)size.Y);
            var options = new ToolpathImageOptions { Width = width, Height = height, Strokes = setup.Printer.ExtrusionUnit == ExtrusionUnit.None };
            var image = PngWriter.ToBytes(ToolpathImage.Draw(toolpath, options, null, cancel), ToolpathImage.Background);
            lines.AddRange(new Thumbnail(width, height, "PNG").Lines(image));
        }
        if (!format.LabelsObjects) return lines;
        var labels = new ObjectLabels(format.Flavor.ObjectMarks);
        var objects = ObjectOutlines.Of(toolpath);
        foreach (var (name, _) in objects) labels.NumberOf(name);
        return [.. lines, .. labels.Definitions(objects.Select(o => o.Outline))];
    }
}
