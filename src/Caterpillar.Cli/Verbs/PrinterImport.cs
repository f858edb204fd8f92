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
        var decoded = GCodeDecoder.Decode(headerBytes).Value;
        if (decoded?.NotGCode is { } none)
            session.ValueOrFail(new Result<DecodedGCode>(null, [none with { Source = new SourceLocation(Session.NameOf(header)) }]));
        // A dash as header is standard input, as footer it means none.
        var footerBytes = footer == "-" ? [] : session.ReadBytes(footer);
        var ending = footer == "-" ? decoded : GCodeDecoder.Decode(footerBytes).Value;
        var footerText = IsPrint(ending) ? EndCode(ending!) : Encoding.UTF8.GetString(footerBytes);
        var headerText = IsPrint(decoded) ? StartCode(decoded!) : Encoding.UTF8.GetString(headerBytes);
        var imported = session.ValueOrFail(HeaderImport.Read(
            headerText, footerText, string.IsNullOrWhiteSpace(name)
                || name == "-" ? "imported" : name, similar, Session.NameOf(header), footer == "-" ? "footer" : footer));
        // A file that names its flavor knows better than a similar printer.
        var states = decoded is not null && !decoded.Evidence.Contains(FlavorDetector.NotStated);
        var printer = states ? imported.Printer with { Flavor = decoded!.Flavor } : imported.Printer;
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

    // A header may print, too: a purge line.
    private static bool IsPrint(DecodedGCode? decoded)
        => decoded?.Document is not null && decoded.PrintedLines.Last > 0
            && (decoded.FirstLayerLine > 0 || decoded.Toolpath.CountLayers() > 2);

    // What is before the first layer.
    private static string StartCode(DecodedGCode print)
        => Commands(print.Document!.Lines(1, print.PrintedLines.First - 1));

    // What is after the last extrusion and the moves that leave it.
    private static string EndCode(DecodedGCode print)
    {
        var last = print.PrintedLines.Last;
        var lines = print.Document!.Lines(last + 1, print.Document.LineCount - last);
        var custom = lines.TakeWhile(l => !l.StartsWith(";TYPE:Custom", StringComparison.Ordinal)).Count();
        return Commands(custom < lines.Count ? lines.Skip(custom) : lines.SkipWhile(l => Code(l).Length == 0 || Code(l) is "G0" or "G1" or "G2" or "G3"));
    }

    // Without comments, among them images and settings, and without the progress of the print.
    private static string Commands(IEnumerable<string> lines)
        => Encoding.UTF8.GetString(Encoding.Latin1.GetBytes(string.Join("\n", lines.Where(l => Code(l) is not ("" or "M73")))));

    private static string Code(string line) => line.Split(';')[0].Trim().Split(' ')[0];

    private static string Number(double value) => NumberFormatter.Format(value, 3);
}
