namespace Caterpillar.Cli;

/// <summary>Reads the contents of a viewer page: G-code, meshes, or a design, which is turned into G-code first.</summary>
/// <param name="setup">The options of the printer.</param>
/// <param name="arguments">The command line.</param>
/// <param name="withLines">Whether the page contains the G-code text.</param>
/// <param name="design">The G-code of a turtle program or of curves.</param>
/// <param name="session">Reads files.</param>
internal sealed class ViewSource(SetupOptions setup, ParseResult arguments, bool withLines, Func<string, byte[]> design, Session session)
{
    /// <summary>Summary of the last file in one line.</summary>
    public string Summary { get; private set; } = "";

    /// <exception cref="CliException">The file cannot be read.</exception>
    public ViewerContent Read(string file) => Ending(file) switch
    {
        ".STL" or ".OBJ" or ".PLY" or ".3MF" => Model(file),
        ".TURTLE" or ".CSV" or ".SVG" or ".JSON" => GCode(file, design(file)),
        _ => GCode(file, session.ReadBytes(file)),
    };

    /// <summary>The extension of a file in capitals, without .gz.</summary>
    public static string Ending(string file) => Path.GetExtension(GzipReader.PlainName(file)).ToUpperInvariant();

    private static string Title(string file) => file == "-" ? "Standard input" : Path.GetFileName(file);

    private ViewerContent Model(string file)
    {
        var meshes = session.Run("Reading", progress => Meshes.Read([file], session, progress));
        Summary = NumberFormatter.Format(meshes.Sum(m => m.Mesh.TriangleCount)) + " triangles";
        var printer = setup.Resolve(arguments, session).Printer;
        return new ViewerContent(Title(file)) { Model = TriMesh.Merge(ModelPlacement.OnBed(meshes, printer).Select(m => m.Mesh)), Printer = printer };
    }

    private ViewerContent GCode(string file, byte[] bytes)
    {
        var name = Session.NameOf(file);
        var resolved = setup.Resolve(arguments, session);
        var options = new DecodeOptions { FilamentDiameter = resolved.Material.FilamentDiameter, Memory = session.Memory };
        using var stream = GzipReader.Open(new MemoryStream(bytes, false));
        var decoded = session.GCodeOrFail(session.Decode(stream, name, options));
        var timed = TimedFile.Of(setup, arguments, decoded, session);
        var timeline = timed.Timeline(name, session);
        var findings = setup.IsGiven(arguments)
            ? session.WithProgress("Checking " + name, progress => PrintCheck.Run(decoded, resolved, progress, session.Cancel))
            : [];
        Summary = PrintSummary.Of(PrintFigures.Of(decoded, timeline.Toolpath) with { Seconds = timeline.Duration });
        return new ViewerContent(Title(file))
        {
            Toolpath = timeline.Toolpath,
            GCode = withLines && !bytes.AsSpan().StartsWith("GCDE"u8) ? bytes : null,
            EndOf = timeline.EndOf,
            Limits = timed.Limits,
            Printer = timeline.Setup.Printer,
            Shape = resolved.Settings.BeadShape,
            Density = resolved.Material.Density,
            Findings = [.. findings],
        };
    }
}
