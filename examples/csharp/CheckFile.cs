using System.Collections.Generic;
using System.Linq;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Machines;

namespace Caterpillar.Examples.CSharp;

/// <summary>Checks a file for a printer and lists the findings as text.</summary>
public static class CheckFile
{
    public static IEnumerable<string> Run(string input)
    {
        var setup = new ProfileLibrary().Setup("ender3").OrThrow();
        var file = GCodeDecoder.DecodeFile(input).OrThrow();
        return PrintCheck.Run(file, setup).Select(finding => finding.ToString());
    }
}
