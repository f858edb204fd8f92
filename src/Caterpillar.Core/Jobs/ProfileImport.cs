using System.Text;
using Caterpillar.GCode;

namespace Caterpillar.Jobs;

/// <summary>Makes a printer and a material from files with start and end code, or from a whole print, of which only these are taken.</summary>
public static class ProfileImport
{
    /// <summary>Imports files. For codes of diagnostics, see <see cref="HeaderImport"/>.</summary>
    /// <param name="header">Bytes of a file with start code, or of a print.</param>
    /// <param name="footer">Bytes of a file with end code, or of a print. Null = the end of the print in <paramref name="header"/>, or no end code.</param>
    /// <param name="name">Name of the new profiles.</param>
    /// <param name="like">A similar printer for everything that the files do not contain; null = generic.</param>
    /// <param name="headerFile">Name of the header in messages.</param>
    /// <param name="footerFile">Name of the footer in messages.</param>
    /// <returns>The profiles, or an error if the header is no G-code or leaves the machine in inches.</returns>
    public static Result<ImportedPrinter> Read(
        byte[] header, byte[]? footer, string name, Printer? like = null, string headerFile = "header", string footerFile = "footer")
    {
        var decoded = GCodeDecoder.Decode(header).Value;
        if (decoded?.NotGCode is { } none) return new Result<ImportedPrinter>(null, [none with { Source = new SourceLocation(headerFile) }]);
        var ending = footer is null ? decoded : GCodeDecoder.Decode(footer).Value;
        var start = IsPrint(decoded) ? StartCode(decoded!) : Encoding.UTF8.GetString(header);
        var end = IsPrint(ending) ? EndCode(ending!) : Encoding.UTF8.GetString(footer ?? []);
        var imported = HeaderImport.Read(start, end, name, like, headerFile, footerFile);
        // A file that names its flavor knows better than a similar printer.
        if (imported.Value is null || decoded is null || decoded.Evidence.Contains(FlavorDetector.NotStated)) return imported;
        var printer = imported.Value.Printer with { Flavor = decoded.Flavor };
        return new Result<ImportedPrinter>(imported.Value with { Printer = printer }, imported.Diagnostics);
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

    // Without comments, among them images and settings, and without progress and objects of the print.
    private static string Commands(IEnumerable<string> lines)
    {
        var kept = lines.Where(l => Code(l) is not ("" or "M73" or "M486" or "EXCLUDE_OBJECT_DEFINE"));
        return Encoding.UTF8.GetString(Encoding.GetEncoding("iso-8859-1").GetBytes(string.Join("\n", kept)));
    }

    private static string Code(string line) => line.Split(';')[0].Trim().Split(' ')[0];
}
