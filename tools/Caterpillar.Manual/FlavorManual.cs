using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Flavors;

namespace Caterpillar.Manual;

/// <summary>The page of the manual on flavors (<c>docs/gcode.md</c>), made from <see cref="FlavorTable"/>.</summary>
internal static class FlavorManual
{
    /// <summary>The page as Markdown.</summary>
    public static string Write()
    {
        var text = new StringBuilder();
        text.Append("# Flavors of G-code\n\n");
        text.Append("What each word means to each firmware, as the decoder, the writer and `convert` take it. This page is made from the table of flavors "
            + "(`src/Caterpillar.Core/Flavors/Firmware`), which was compared\n");
        text.Append("with the source of each firmware ([Sources](#sources)).\n\n");
        text.Append("`caterpillar decode --flavor NAME`, `caterpillar convert --flavor NAME` and the key `gcode_flavor` of a printer choose one. Without a "
            + "choice the file decides: comments of its slicer, commands that only\n");
        text.Append("one firmware has; where it says nothing, Marlin 2. Where the flavor changes the result, a diagnostic says so and names the line. "
            + "*Refused* means: the command does nothing, the head stays,\n");
        text.Append("and a diagnostic says why. What a flavor does not know is counted and reported.\n");
        var all = FlavorTable.All;
        for (var first = 0; first < all.Count; first += 5) Table(text, all.Skip(first).Take(5).ToArray());
        text.Append("\n## The same for all\n\n");
        text.Append("- `G0` and `G1` move in a straight line, `F` holds until the next (mm/min, or inches/min). `G17` is the plane XY, `G21` is millimeters, "
            + "`G90` and `G91` switch X, Y and Z.\n");
        text.Append("- `G92 X… Y… Z…` gives the place another name and moves nothing; `G92 E` names the position of E. Positions in results are those of the "
            + "machine: `G92` does not move them.\n");
        text.Append("- A missing I, J or K is 0, seen from the start; the end of an arc is where its line says, also when it is not quite on the circle. "
            + "Start and end at one point are a full circle; a third axis makes a helix.\n");
        text.Append("- R > 0 is the shorter arc, R < 0 the longer one.\n");
        text.Append("- `M104`, `M109`, `M140`, `M190`, `M106`, `M107`, `M400` and limits of the motion become events of the "
            + "toolpath. A line that begins with `M` never moves.\n");
        text.Append("- `;` and `( )` are comments, `*` begins a checksum, a leading `N` word and `/` are dropped, lines that begin with `%`, `@` or `<` do "
            + "nothing.\n");
        text.Append("- The zero of a machine, the positions it stores, and the retraction it makes by itself are not in a file: homing ends at 0, stored "
            + "positions are 0 until the file stores others.\n");
        text.Append("\n## Not followed\n\nThese move the head or its coordinates in a way that is not followed. A warning (`gcode.unsupported_motion`) names "
            + "the line; positions after it may be wrong.\n\n");
        foreach (var flavor in all.Where(d => d.NotFollowed.Count > 0 || d.RestorePoints))
        {
            text.Append("- ").Append(flavor.Title).Append(": ")
                .Append(string.Join(", ", flavor.NotFollowed.Select(n => FlavorRows.Code(n) + (n == "G10" ? " with axes" : ""))));
            text.Append(flavor.RestorePoints ? ", R of `G0` and `G1`\n" : "\n");
        }
        text.Append("\n## Notes\n\n");
        foreach (var notes in all.Where(d => d.Notes.Length > 0).GroupBy(d => d.Notes, StringComparer.Ordinal))
            text.Append("- **").Append(string.Join(", ", notes.Select(d => d.Title))).Append("**: ").Append(notes.Key).Append('\n');
        text.Append("\n## Sources\n\n| name | flavor | compared with |\n|---|---|---|\n");
        foreach (var flavor in all) text.Append("| `").Append(flavor.Name).Append("` | ").Append(flavor.Title).Append(" | ").Append(flavor.Source)
            .Append(" |\n");
        text.Append("\nSmall programs for every row of the tables and every flavor, with the result by these sources, are tests: "
            + "`tests/Caterpillar.Core.Tests/GCode/Flavors`.\n");
        return text.ToString();
    }

    private static void Table(StringBuilder text, IReadOnlyList<FlavorRules> flavors)
    {
        text.Append("\n| |");
        foreach (var flavor in flavors) text.Append(' ').Append(flavor.Title).Append(" |");
        text.Append("\n|---|");
        foreach (var _ in flavors) text.Append("---|");
        text.Append('\n');
        foreach (var (word, says) in FlavorRows.All)
        {
            text.Append("| ").Append(word).Append(" |");
            foreach (var flavor in flavors) text.Append(' ').Append(says(flavor)).Append(" |");
            text.Append('\n');
        }
    }
}
