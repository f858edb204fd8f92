using Caterpillar.Dialects;
using Caterpillar.GCode;

namespace Caterpillar.Examples.CSharp;

/// <summary>Writes a file for another firmware, with relative E.</summary>
public static class ConvertFile
{
    public static void Run(string input, string output)
    {
        var file = GCodeDecoder.DecodeFile(input).OrThrow();
        var options = new ConvertOptions { Dialect = DialectTable.Klipper, RelativeE = true };
        GCodeConverter.ToDocument(file, options).OrThrow().WriteFile(output);
    }
}
