using Caterpillar.Jobs;

namespace Caterpillar.Cli;

/// <summary>Creates profiles from a header and a footer.</summary>
internal static class PrinterImport
{
    public static void Run(string header, string footer, string? like, string output, string? materialOutput, Session session)
    {
        var similar = like is null ? null : session.ValueOrFail(session.Profiles.Printer(like), File.Exists(like) ? ExitCode.BadInput : ExitCode.Usage);
        var name = Path.GetFileNameWithoutExtension(output == "-" ? header : output);
        var headerBytes = session.ReadBytes(header);
        // A dash as header is standard input, as footer it means none.
        var footerBytes = footer == "-" ? null : session.ReadBytes(footer);
        var imported = session.ValueOrFail(ProfileImport.Read(
            headerBytes, footerBytes, string.IsNullOrWhiteSpace(name)
                || name == "-" ? "imported" : name, similar, Session.NameOf(header), footer == "-" ? "footer" : footer));
        var printer = imported.Printer;
        session.WriteText(output, text => text.Write(ProfileWriter.Write(printer)));
        if (output != "-") session.Say(() => $"{output}: {printer.Title}, {printer.Flavor.Title}");
        if (materialOutput is not null) session.WriteText(materialOutput, text => text.Write(ProfileWriter.Write(imported.Material)));
        else if (imported.Material.NozzleTemperature > 0)
        {
            session.Messages.WriteLine(
                $"The header sets the nozzle to {Number(imported.Material.NozzleTemperature)} °C and the bed to {Number(imported.Material.BedTemperature)} °C. "
                    + $"To write a material with these temperatures, add --material-output FILE.json.");
        }
        if (imported.Start is { } start)
        {
            session.Messages.WriteLine($"After the header, the nozzle is at X {Number(start.X)}, Y {Number(start.Y)}, Z {Number(start.Z)} mm.");
        }
    }

    private static string Number(double value) => NumberFormatter.Format(value, 3);
}
