using Caterpillar.Jobs;

namespace Caterpillar.Cli;

/// <summary>Creates profiles from files of other programs.</summary>
internal static class PrinterImport
{
    /// <param name="files">A file with settings or start code, and perhaps one with end code.</param>
    /// <param name="wanted">Name of the printer in the file; null = all.</param>
    /// <param name="like">A similar printer, or null.</param>
    /// <param name="output">A file for a printer, or a folder.</param>
    /// <param name="materialOutput">A file for a material, or null.</param>
    /// <param name="session">Reads and writes.</param>
    public static void Run(string[] files, string? wanted, string? like, string output, string? materialOutput, Session session)
    {
        var similar = like is null ? null : session.ValueOrFail(session.Profiles.Printer(like), File.Exists(like) ? ExitCode.BadInput : ExitCode.Usage);
        var header = files[0];
        var name = Path.GetFileNameWithoutExtension(output == "-" ? header : output);
        // A dash as header is standard input, as footer it means none.
        var footer = files.Length > 1 && files[1] != "-" ? files[1] : null;
        var imported = session.ValueOrFail(ProfileImport.Read(session.ReadBytes(header), footer is null ? null : session.ReadBytes(footer),
            string.IsNullOrWhiteSpace(name) || name == "-" ? "imported" : name, similar, Session.NameOf(header), footer ?? "footer", wanted));
        var isFile = output == "-" || output.EndsWith(".json", StringComparison.OrdinalIgnoreCase);
        if (isFile && imported.Printers.Count + imported.Settings.Count > 1)
        {
            throw new CliException(ExitCode.Usage, $"The file has {Number(imported.Printers.Count)} printers, {Number(imported.Materials.Count)} materials and "
                + $"{Number(imported.Settings.Count)} settings. Give a folder for them: -o FOLDER.");
        }
        if (!isFile) WriteFolder(imported, output, session);
        else if (imported.Printers.Count > 0) Write(output, ProfileWriter.Write(imported.Printers[0]), session);
        else if (imported.Settings.Count > 0) Write(output, ProfileWriter.Write(imported.Settings[0]), session);
        else Write(output, ProfileWriter.Write(imported.Materials[0]), session);
        if (isFile && output != "-" && imported.Printers.Count > 0)
            session.Say(() => $"{output}: {imported.Printers[0].Title}, {imported.Printers[0].Flavor.Title}");
        if (materialOutput is not null && imported.Materials.Count > 0) Write(materialOutput, ProfileWriter.Write(imported.Materials[0]), session);
        else if (isFile && imported.Printers.Count > 0 && imported.Materials.FirstOrDefault() is { NozzleTemperature: > 0 } material)
        {
            session.Messages.WriteLine(
                $"The header sets the nozzle to {Number(material.NozzleTemperature)} °C and the bed to {Number(material.BedTemperature)} °C. "
                    + $"To write a material with these temperatures, add --material-output FILE.json.");
        }
        if (imported.Start is { } start)
        {
            session.Messages.WriteLine($"After the header, the nozzle is at X {Number(start.X)}, Y {Number(start.Y)}, Z {Number(start.Z)} mm.");
        }
    }

    // As a folder of profiles, in which names are found.
    private static void WriteFolder(ImportedProfiles imported, string folder, Session session)
    {
        foreach (var printer in imported.Printers) Put("", printer.Name, ProfileWriter.Write(printer));
        foreach (var material in imported.Materials) Put("materials", material.Name, ProfileWriter.Write(material));
        foreach (var settings in imported.Settings) Put("settings", settings.Name, ProfileWriter.Write(settings));
        session.Say(() => $"{folder}: {Number(imported.Printers.Count)} printers, {Number(imported.Materials.Count)} materials, "
            + $"{Number(imported.Settings.Count)} settings" + (imported.Printers.Count == 1 ? $"; --printer {Path.Combine(folder, imported.Printers[0].Name)}.json" : ""));

        void Put(string kind, string name, string json)
        {
            Directory.CreateDirectory(Path.Combine(folder, kind));
            Write(Path.Combine(folder, kind, name + ".json"), json, session);
        }
    }

    private static void Write(string file, string json, Session session) => session.WriteText(file, text => text.Write(json));

    private static string Number(double value) => NumberFormatter.Format(value, 3);
}
