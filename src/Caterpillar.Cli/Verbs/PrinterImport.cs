using System.Text;
using Caterpillar.GCode;

namespace Caterpillar.Cli;

/// <summary>Makes profiles from a header and a footer.</summary>
internal static class PrinterImport
{
    public static void Run(string header, string footer, string? like, string output, string? materialOutput, Session session)
    {
        var similar = like is null ? null : session.ValueOrFail(session.Profiles.Printer(like), File.Exists(like) ? ExitCode.BadInput : ExitCode.Usage);
        var name = Path.GetFileNameWithoutExtension(output == "-" ? header : output);
        var headerBytes = session.ReadBytes(header);
        if (GCodeDecoder.Decode(headerBytes).Value?.NotGCode is { } none)
            session.ValueOrFail(new Result<DecodedGCode>(null, [none with { Source = new SourceLocation(Session.NameOf(header)) }]));
        // A dash for the header is standard input; one for the footer means none.
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
                $"The header heats to {Number(imported.Material.NozzleTemperature)} °C and the bed to {Number(imported.Material.BedTemperature)} °C; "
                    + $"--material-output writes a material with these.");
        }
        if (imported.Start is { } start)
        {
            session.Messages.WriteLine($"The header leaves the nozzle at X {Number(start.X)}, Y {Number(start.Y)}, Z {Number(start.Z)} mm.");
        }
    }

    private static string Text(string file, Session session) => Encoding.UTF8.GetString(session.ReadBytes(file));

    private static string Number(double value) => NumberFormatter.Format(value, 3);
}
