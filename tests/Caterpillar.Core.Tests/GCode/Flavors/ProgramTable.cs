using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode.Flavors;

/// <summary>
/// Tables of small programs: a row is a program (lines divided by <c>;</c>), a column a flavor, a cell what its firmware makes of it, read from its source and
/// not from our decoder. Where a firmware's extruder has another letter than E (A of LinuxCNC), programs are run with that letter.
/// </summary>
internal static class ProgramTable
{
    /// <summary>
    /// One case for each program and flavor; <paramref name="sources"/> has a line <c>flavor: file and function</c> for each flavor of the table.
    /// </summary>
    public static IEnumerable<TestCaseData> Cases(string table, string sources)
    {
        var where = sources.Split('\n').Where(l => l.Trim().Length > 0).Select(l => l.Split([':'], 2)).ToDictionary(p => p[0].Trim(), p => p[1].Trim());
        string[]? names = null;
        foreach (var line in table.Split('\n').Where(l => l.Trim().Length > 0))
        {
            var bar = line.LastIndexOf('|');
            var cells = line.Substring(bar + 1).Split([' '], StringSplitOptions.RemoveEmptyEntries);
            if (names is null)
            {
                names = cells;
                Assert.That(names, Is.EquivalentTo(FlavorTable.All.Select(d => d.Name)), "a column for each flavor");
                Assert.That(where.Keys, Is.SupersetOf(names), "a source for each flavor");
                continue;
            }
            var program = line.Substring(0, bar).Trim();
            Assert.That(cells, Has.Length.EqualTo(names.Length), program);
            for (var i = 0; i < names.Length; i++)
                yield return new TestCaseData(program, names[i], cells[i], where[names[i]]).SetArgDisplayNames(program, names[i], cells[i]);
        }
    }

    public static Result<DecodedGCode> Run(string program, string flavor)
    {
        var rules = FlavorTable.Find(flavor)!;
        if (rules.ExtruderLetters.StartsWith("A", StringComparison.Ordinal)) program = string.Join(";",
            program.Split(';').Select(l => l.StartsWith("G", StringComparison.Ordinal) ? l.Replace(" E", " A") : l));
        return GCodeDecoder.Decode(Encoding.ASCII.GetBytes(program.Replace(';', '\n') + "\n"), new DecodeOptions { Flavor = rules });
    }

    public static DecodedGCode Decode(string program, string flavor) => Run(program, flavor).Value!;

    public static string Text(double? value) => value is { } number ? NumberFormatter.Format(number, 3) : "-";

    /// <summary>X of the machine after the last move, or 0.</summary>
    public static double X(DecodedGCode decoding) => decoding.Toolpath.Count == 0 ? 0 : decoding.Toolpath[decoding.Toolpath.Count - 1].End.X;
}
