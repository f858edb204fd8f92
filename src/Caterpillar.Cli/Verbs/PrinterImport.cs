namespace Caterpillar.Cli;

/// <summary>Creates profiles from files of other programs.</summary>
internal static class PrinterImport
{
    /// <param name="files">A file with settings or start code, and perhaps one with end code.</param>
    /// <param name="wanted">Name of the printer in the file; null = all.</param>
    /// <param name="like">A similar printer, or null.</param>
    /// <param name="output">A folder, or a file for a single printer, beside which its material and settings get their folders.</param>
    /// <param name="session">Reads and writes.</param>
    public static void Run(string[] files, string? wanted, string? like, string output, Session session)
    {
        var similar = like is null ? null : session.ValueOrFail(session.Profiles.Printer(like), File.Exists(like) ? ExitCode.BadInput : ExitCode.Usage);
        var name = Path.GetFileNameWithoutExtension(output == "-" ? files[0] : output);
        // A dash as header is standard input, as footer it means none.
        var footer = files.Length > 1 && files[1] != "-" ? files[1] : null;
        var imported = session.ValueOrFail(ProfileImport.Read(session.ReadBytes(files[0]), footer is null ? null : session.ReadBytes(footer),
            string.IsNullOrWhiteSpace(name) || name == "-" ? "imported" : name, similar, Session.NameOf(files[0]), footer ?? "footer", wanted));
        var isFile = output == "-" || output.EndsWith(".json", StringComparison.OrdinalIgnoreCase);
        if (isFile && imported.Printers.Count != 1)
        {
            throw CliException.Usage($"The file has {Number(imported.Printers.Count)} printers, {Number(imported.Materials.Count)} materials and "
                + $"{Number(imported.Settings.Count)} settings. Give a folder for them: -o FOLDER.");
        }
        var folder = output == "-" ? null : isFile ? Path.GetDirectoryName(output) : output;
        foreach (var printer in imported.Printers) Put("", printer.Name, ProfileWriter.Write(printer), isFile ? output : null);
        foreach (var material in imported.Materials) Put("materials", material.Name, ProfileWriter.Write(material));
        foreach (var settings in imported.Settings) Put("settings", settings.Name, ProfileWriter.Write(settings));
        session.Say(() => $"{output}: " + (imported.Printers.Count == 1 ? $"{imported.Printers[0].Title}, {imported.Printers[0].Flavor.Title}"
            : $"printers: {Number(imported.Printers.Count)}")
            + $"; materials: {Number(imported.Materials.Count)}, settings: {Number(imported.Settings.Count)}");
        if (imported.Start is { } start)
            session.Messages.WriteLine($"After the header, the nozzle is at X {Number(start.X)}, Y {Number(start.Y)}, Z {Number(start.Z)} mm.");

        // On standard output there is only the printer.
        void Put(string kind, string name, string json, string? file = null)
        {
            if (file is null && folder is null) return;
            if (file is null) Directory.CreateDirectory(Path.Combine(folder!, kind));
            session.WriteText(file ?? Path.Combine(folder!, kind, name + ".json"), text => text.Write(json));
        }
    }

    private static string Number(double value) => NumberFormatter.Format(value, 3);
}
