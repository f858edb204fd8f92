using System.Text;
using Caterpillar.GCode;

namespace Caterpillar.Cli;

/// <summary>Creates profiles from a header and a footer.</summary>
internal static class PrinterImport
{
    public static void Run(string header, string footer, string? like, string output, string? materialOutput, Session session)
    {
        var similar = like is null ? null : session.ValueOrFail(session.Profiles.Printer(like), File.Exists(like) ? ExitCode.BadInput : ExitCode.Usage);
        var name = Path.GetFileNameWithoutExtension(output == "-" ? header : output);
        var headerBytes = session.ReadBytes(header);
        if (GCodeDecoder.Decode(headerBytes).Value?.NotGCode is { } none)
            session.ValueOrFail(new Result<DecodedGCode>(null, [none with { Source = new SourceLocation(Session.NameOf(header)) }]));
        // A dash as header is standard input, as footer it means none.
        var footerText = footer == "-" ? "" : Text(footer, session);
        var imported = session.ValueOrFail(HeaderImport.Read(
            Encoding.UTF8.GetString(headerBytes), footerText, string.IsNullOrWhiteSpace(name)
                || name == "-" ? "imported" : name, similar, Session.NameOf(header), footer == "-" ? "footer" : footer));
        session.WriteText(output, text => text.Write(ProfileWriter.Write(imported.Printer)));
        if (output != "-") session.Say(() => $"{output}: {imported.Printer.Title}");
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

    private static string Text(string file, Session session) => Encoding.UTF8.GetString(session.ReadBytes(file));

    private static string Number(double value) => NumberFormatter.Format(value, 3);
}
