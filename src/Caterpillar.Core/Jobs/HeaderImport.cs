namespace Caterpillar.Jobs;

/// <summary>
/// Makes a printer from the header and footer files of ExtruderTurtle: G-code before and after a print, with fixed numbers or with <c>{x}</c>, <c>{y}</c>,
/// <c>{z}</c>, <c>{feedrate}</c>, <c>{hotend_temp}</c> and <c>{bed_temp}</c>. The lines become templates with the temperatures of the material. The lines also
/// give the mode of E, the size of the bed and the position of the nozzle. Similar files of other programs work too.
/// </summary>
internal static class HeaderImport
{
    // What ExtruderTurtle fills in by default (setup).
    private const double DefaultNozzle = 205, DefaultBed = 60;

    /// <summary>Imports the text of two files.</summary>
    /// <param name="header">Lines before the print.</param>
    /// <param name="footer">Lines after the print; may be empty.</param>
    /// <param name="name">Name of the new profiles.</param>
    /// <param name="like">A similar printer for everything that the files do not contain, such as nozzle, speeds and head; null = generic.</param>
    /// <param name="headerFile">Name of the header in messages.</param>
    /// <param name="footerFile">Name of the footer in messages.</param>
    /// <returns>
    /// The printer, or an error if the header leaves the machine in inches. Invalid lines give warnings (<c>header.bad_word</c>, <c>header.no_command</c>,
    /// <c>header.merge_conflict</c>, <c>import.template</c>) with their location and stay as comments. Notes report guessed values.
    /// </returns>
    public static Result<ImportedProfiles> Read(
        string header, string footer, string name = "imported", Printer? like = null, string headerFile = "header", string footerFile = "footer")
    {
        var problems = new DiagnosticList();
        var start = new HeaderCode(header, headerFile, problems);
        var end = new HeaderCode(footer, footerFile, problems);
        if (start.Lines.Count == 0) problems.Add(Severity.Warning, "header.empty", "The header has no lines.", new SourceLocation(headerFile));
        if (start.Inches)
        {
            problems.Add(Severity.Error, "header.inches", "The header leaves the machine in inches (G20). Toolpaths are in mm: use G21.",
                new SourceLocation(headerFile));
        }
        if (problems.HasErrors) return new Result<ImportedProfiles>(null, problems.ToList());

        var startLines = new HeaderTemplate(start, headerFile, problems).Start();
        var endLines = new HeaderTemplate(end, footerFile, problems).End(start);
        var (volume, origin) = Bed(start, end, like ?? new Printer(), headerFile, problems);
        var nozzle = start.NozzleTemperature ?? (header.IndexOf("{hotend_temp", StringComparison.Ordinal) >= 0 ? DefaultNozzle : 0);
        var bed = start.BedTemperature ?? (header.IndexOf("{bed_temp", StringComparison.Ordinal) >= 0 ? DefaultBed : 0);
        var printer = (like ?? new Printer()) with
        {
            Name = name,
            Title = name,
            BuildVolume = volume,
            Origin = origin,
            ExtrusionMode = start.RelativeE == false ? ExtrusionMode.Absolute : ExtrusionMode.Relative,
            MinExtrusionTemperature = start.MinExtrusionTemperature ?? (nozzle > 0 ? (like ?? new Printer()).MinExtrusionTemperature : 0),
            StartGCode = startLines,
            EndGCode = endLines,
        };
        var isPrusa = start.Lines.Any(l => l.Is('G', 80) || (l.Is('G', 28) && l.Has('W')));
        if (isPrusa && like is null) printer = printer with { Flavor = FlavorTable.Prusa };
        if (start.ToolCount > printer.ToolCount) printer = printer with { ToolOffsets = new ValueList<Vec3>(Enumerable.Repeat(Vec3.Zero, start.ToolCount)) };
        if (nozzle <= 0)
        {
            if (like is null) printer = printer with { DefaultMaterial = "clay", DefaultSettings = "clay", MaxFlow = 0 };
            problems.Add(Severity.Note, "header.no_heating", "The header does not heat the nozzle. The printer extrudes cold material such as clay.",
                new SourceLocation(headerFile));
        }
        if (start.RelativeE is null)
        {
            problems.Add(Severity.Note, "header.e_mode", "The header has neither M82 nor M83. The printer uses relative E (M83).",
                new SourceLocation(headerFile));
        }
        var material = new Material { Name = name, Title = name, NozzleTemperature = nozzle, BedTemperature = Math.Min(bed, 500) };
        if (nozzle > 0) printer = printer with { DefaultMaterial = name };
        return new Result<ImportedProfiles>(new ImportedProfiles([printer], [material], [], start.Position), problems.ToList());
    }

    // A size in a comment; else twice the position where the print starts, since that is the middle; else that of the similar printer. Never less than the
    // positions of the header.
    private static (Vec3 Volume, BedOrigin Origin) Bed(HeaderCode code, HeaderCode ending, Printer like, string file, DiagnosticList problems)
    {
        var place = new SourceLocation(file);
        var seen = code.Seen.IsEmpty ? Bounds.Of([Vec3.Zero]) : code.Seen;
        if (ending.Relative == false && !ending.NeedsMode) seen = seen.Include(ending.Seen);
        var centered = seen.Min.X < -20 || seen.Min.Y < -20;
        var origin = code.SizeInComment is null && code.Position is null && !centered ? like.Origin : centered ? BedOrigin.Center : BedOrigin.Corner;
        double x = like.BuildVolume.X, y = like.BuildVolume.Y, z = like.BuildVolume.Z;
        var reason = "";
        if (code.SizeInComment is { } size)
        {
            (x, y) = (size.X, size.Y);
            if (size.Z > 0) z = size.Z;
            reason = "from a comment";
        }
        else if (origin == BedOrigin.Corner && code.Position is { X: >= 20, Y: >= 20 } start)
        {
            (x, y) = (2 * start.X, 2 * start.Y);
            reason = "twice the last position of the header";
        }
        var needs = origin == BedOrigin.Center
            ? new Vec3(2 * Math.Max(-seen.Min.X, seen.Max.X), 2 * Math.Max(-seen.Min.Y, seen.Max.Y), seen.Max.Z)
            : seen.Max;
        if (needs.X > x || needs.Y > y || needs.Z > z)
        {
            (x, y, z) = (Math.Max(x, needs.X), Math.Max(y, needs.Y), Math.Max(z, needs.Z));
            reason = "from the range of the moves";
        }
        var volume = new Vec3(Fit(x), Fit(y), Fit(z));
        problems.Add(Severity.Note, "header.bed_size", reason.Length == 0
            ? $"The header does not contain the build volume. {Text(volume)} is from the similar printer."
            : $"The build volume is {Text(volume)}, {reason}. The height and all missing values are from the similar printer.", place);
        return (volume, origin);
    }

    private static double Fit(double size) => Math.Max(1, Math.Min(100_000, size));

    private static string Text(Vec3 v) => $"{NumberFormatter.Format(v.X, 1)} × {NumberFormatter.Format(v.Y, 1)} × {NumberFormatter.Format(v.Z, 1)} mm";
}
