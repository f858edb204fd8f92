namespace Caterpillar.Jobs;

/// <summary>
/// Makes profiles from files of other programs: presets and bundles of PrusaSlicer (.ini), presets of OrcaSlicer and Bambu Studio (.json), the settings in
/// their projects (.3mf) and prints, and start and end code, also of prints without settings.
/// </summary>
public static class ProfileImport
{
    // So many known names in the comments of a print are the settings of a slicer.
    private const int Enough = 20;

    /// <summary>Imports files.</summary>
    /// <param name="file">Bytes of a file with settings, of a print, or of start code.</param>
    /// <param name="footer">Bytes of a file with end code, or of a print. Null = the end of the print in <paramref name="file"/>, or no end code.</param>
    /// <param name="name">Name of profiles that have none.</param>
    /// <param name="like">A similar printer for everything that the files do not contain; null = generic.</param>
    /// <param name="fileName">Name of the file in messages. What a JSON preset inherits is looked for near it.</param>
    /// <param name="footerName">Name of the footer in messages.</param>
    /// <param name="printer">Name of the printer to take from a file with several; null = all.</param>
    /// <returns>
    /// The profiles, or an error if the file is of none of these kinds, or start code leaves the machine in inches. Settings without an equal here are the note
    /// <c>import.no_equal</c>, lines of templates the warning <c>import.template</c>, macros whose effect is unknown the warning <c>import.macro</c>. Invalid
    /// lines of start code are warnings (<c>header.bad_word</c>, <c>header.no_command</c>, <c>header.merge_conflict</c>) and stay as comments.
    /// </returns>
    /// <exception cref="IOException">A file that a JSON preset inherits cannot be read.</exception>
    public static Result<ImportedProfiles> Read(
        byte[] file, byte[]? footer, string name, Printer? like = null, string fileName = "header", string footerName = "footer", string? printer = null)
    {
        if (file is null) throw new ArgumentNullException(nameof(file));
        if (footer is null && Presets(file, fileName) is { } found)
        {
            var problems = found.Diagnostics.ToList();
            var profiles = problems.Any(d => d.Severity == Severity.Error) ? null : new SlicerImport(found.Value!, name, like, fileName, problems).Run(printer);
            if (problems.Any(d => d.Severity == Severity.Error)) profiles = null;
            // Printers of a bundle share most of their templates.
            var kinds = problems.GroupBy(d => (d.Code, d.Message)).Select(g => g.First() with { Count = g.Count() });
            return new Result<ImportedProfiles>(profiles, kinds.ToArray());
        }
        return Code(file, footer, name, like, fileName, footerName);
    }

    /// <summary>True for names of files whose settings make a whole setup: G-code, settings of PrusaSlicer, and projects.</summary>
    public static bool HasSetup(string file) => FileSetup.IsName(file)
        || file.EndsWith(".ini", StringComparison.OrdinalIgnoreCase) || file.EndsWith(".3mf", StringComparison.OrdinalIgnoreCase);

    /// <summary>The setup of a file: that of a print of Caterpillar, or from the settings of another slicer.</summary>
    /// <param name="path">G-code, <c>.ini</c> or <c>.3mf</c>.</param>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static Result<PrintSetup> ReadSetup(string path)
    {
        var own = FileSetup.IsName(path) || !File.Exists(path) ? FileSetup.ReadFile(path) : null;
        if (own is not null && own.Diagnostics.All(d => d.Code != "setup.not_in_file")) return own;
        var file = File.ReadAllBytes(path);
        if (Presets(file, path) is null && own is not null) return own;
        var read = Read(file, null, Path.GetFileNameWithoutExtension(path), null, path);
        if (read.Value is not { Printers.Count: > 0 } made) return new Result<PrintSetup>(null, read.Diagnostics);
        // No folder has its material and settings.
        var usual = new Printer();
        var printer = made.Printers[0] with { DefaultMaterial = usual.DefaultMaterial, DefaultSettings = usual.DefaultSettings };
        var (material, settings) = (made.Materials.FirstOrDefault() ?? new Material(), made.Settings.FirstOrDefault() ?? new PrintSettings());
        return new Result<PrintSetup>(new PrintSetup(printer, material, settings), read.Diagnostics);
    }

    // The settings of another slicer; null if the file is something else.
    private static Result<IReadOnlyList<SlicerPreset>>? Presets(byte[] file, string fileName)
    {
        var problems = new List<Diagnostic>();
        var project = ProjectSettings.Of(file);
        var text = Encoding.UTF8.GetString(project ?? file).TrimStart('\uFEFF');
        List<SlicerPreset>? presets = null;
        if (text.TrimStart().StartsWith("{", StringComparison.Ordinal)) presets = JsonPresets.Read(text, fileName, problems);
        else if (project is not null || IniPresets.IsIni(text)) presets = IniPresets.Read(text, fileName, problems);
        else if (GCodeDecoder.Decode(file).Value?.Settings is { Count: >= Enough } settings && settings.Keys.Count(SlicerPreset.IsKnown) >= Enough
            && FileSetup.In(settings).Count == 0)
        {
            presets = [new SlicerPreset("", "", settings, false)];
        }
        return presets is null ? null : new Result<IReadOnlyList<SlicerPreset>>(presets, problems);
    }

    private static Result<ImportedProfiles> Code(byte[] header, byte[]? footer, string name, Printer? like, string headerName, string footerName)
    {
        var read = GCodeDecoder.Decode(header);
        if (read.Value is not { } decoded) return new Result<ImportedProfiles>(null, read.Diagnostics);
        if (decoded.NotGCode is { } none) return new Result<ImportedProfiles>(null, [none with { Source = new SourceLocation(headerName) }]);
        var ending = footer is null ? decoded : GCodeDecoder.Decode(footer).Value;
        // Of a print, what is before the first layer.
        var start = IsPrint(decoded) ? Commands(decoded.Document!.Lines(1, decoded.PrintedLines.First - 1)) : Encoding.UTF8.GetString(header);
        var end = IsPrint(ending) ? EndCode(ending!) : Encoding.UTF8.GetString(footer ?? []);
        var imported = HeaderImport.Read(start, end, name, like, headerName, footerName);
        if (imported.Value is not { } made || decoded.Evidence.Contains(FlavorDetector.NotStated)) return imported;
        // A file that names its flavor knows better than a similar printer.
        return new Result<ImportedProfiles>(made with { Printers = [made.Printers[0] with { Flavor = decoded.Flavor }] }, imported.Diagnostics);
    }

    // A header may print, too: a purge line.
    private static bool IsPrint(DecodedGCode? decoded)
        => decoded?.Document is not null && decoded.PrintedLines.Last > 0
            && (decoded.FirstLayerLine > 0 || decoded.Toolpath.CountLayers() > 2);

    // What is after the last extrusion and the moves that leave it.
    private static string EndCode(DecodedGCode print)
    {
        var last = print.PrintedLines.Last;
        var lines = print.Document!.Lines(last + 1, print.Document.LineCount - last);
        var custom = lines.TakeWhile(l => !l.StartsWith(";TYPE:Custom", StringComparison.Ordinal)).Count();
        return Commands(custom < lines.Count ? lines.Skip(custom) : lines.SkipWhile(l => Code(l).Length == 0 || Code(l) is "G0" or "G1" or "G2" or "G3"));
    }

    // Without comments, among them images and settings, and without progress and objects of the print.
    private static string Commands(IEnumerable<string> lines)
    {
        var kept = lines.Where(l => Code(l) is not ("" or "M73" or "M486" or "EXCLUDE_OBJECT_DEFINE"));
        return Encoding.UTF8.GetString(Encoding.GetEncoding("iso-8859-1").GetBytes(string.Join("\n", kept)));
    }

    private static string Code(string line) => line.Split(';')[0].Trim().Split(' ')[0];
}
