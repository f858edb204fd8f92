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
        text.Append("The meaning of G-code words in each firmware, for the decoder, the writer and `convert`. This page is made from the table of flavors "
            + "(`src/Caterpillar.Core/Flavors/Firmware`), which was compared\n");
        text.Append("with the source of each firmware ([Sources](#sources)).\n\n");
        text.Append("Select a flavor with `caterpillar decode --flavor NAME`, `caterpillar convert --flavor NAME` or the key `gcode_flavor` of a printer. "
            + "Otherwise the file decides, by comments of its slicer or commands that only\n");
        text.Append("one firmware has. The default is Marlin 2. If the flavor changes the result, a diagnostic names the line. "
            + "*Refused* means: the command does nothing, the head does not move,\n");
        text.Append("and a diagnostic gives the reason. [All commands](#all-commands) are listed below. What is in no table is named as not understood.\n");
        var all = FlavorTable.All;
        for (var first = 0; first < all.Count; first += 5) Table(text, all.Skip(first).Take(5).ToArray());
        text.Append("\n## The same for all\n\n");
        text.Append("- `G0` and `G1` move in a straight line. `F` applies until the next one (mm/min, or inches/min). `G17` is the XY plane, `G21` is "
            + "millimeters, `G90` and `G91` switch X, Y and Z.\n");
        text.Append("- `G92 X… Y… Z…` renames the position without moving. `G92 E` sets the position of E. Positions in results are machine "
            + "positions: `G92` does not change them.\n");
        text.Append("- A missing I, J or K is 0, relative to the start. The end of an arc is the position in its line, even if it is not quite on the circle. "
            + "If start and end are equal, the arc is a full circle. A third axis makes a helix.\n");
        text.Append("- R > 0 is the shorter arc, R < 0 the longer one.\n");
        text.Append("- `M104`, `M109`, `M140`, `M190`, `M106`, `M107`, `M400` and motion limits become events of the "
            + "toolpath. Of the lines that begin with `M` only `M290` moves the head.\n");
        text.Append("- `;` and `( )` are comments, `*` begins a checksum, a leading `N` word and `/` are ignored, and lines that begin with `%`, `@` or `<` "
            + "do nothing.\n");
        text.Append("- A file does not contain the zero of a machine, its stored positions, or the retraction that its firmware is set to. Homing ends at 0, "
            + "stored positions are 0 until the file stores others, and G10 retracts by the printer's profile until the file sets a length.\n");
        text.Append("- After a macro (`START_PRINT`, `M98`) the position is unknown until the file homes or states each axis. A file that prints before that "
            + "has the finding `file.unknown_position`, unless the key `macros` of the printer declares the macro.\n");
        text.Append("\n## Not supported\n\nThese commands move the head or change its coordinates and are not supported. A warning "
            + "(`gcode.unsupported_motion`) names the line. Positions after it may be wrong.\n\n");
        foreach (var flavor in all)
        {
            var names = CommandTable.Rows.Where(r => r.Flavors.Contains(flavor.Name)).SelectMany(r => r.Commands).Where(c => c.Use == CommandUse.Untracked)
                .Select(c => CommandRows.Code(c)).Concat(flavor.RestorePoints ? ["R of `G0` and `G1` for positions that the file does not store"] : []);
            if (names.Any()) text.Append("- ").Append(flavor.Title).Append(": ").Append(string.Join(", ", names)).Append('\n');
        }
        text.Append("\n## Notes\n\n");
        foreach (var notes in all.Where(d => d.Notes.Length > 0).GroupBy(d => d.Notes, StringComparer.Ordinal))
            text.Append("- **").Append(string.Join(", ", notes.Select(d => d.Title))).Append("**: ").Append(notes.Key).Append('\n');
        text.Append("\n## Sources\n\n| name | flavor | compared with |\n|---|---|---|\n");
        foreach (var flavor in all) text.Append("| `").Append(flavor.Name).Append("` | ").Append(flavor.Title).Append(" | ").Append(flavor.Source)
            .Append(" |\n");
        text.Append("\nTests contain small programs for every row and flavor, with the results according to these sources: "
            + "`tests/Caterpillar.Core.Tests/GCode/Flavors`.\n");
        CommandRows.Write(text);
        return text.ToString();
    }

    private static void Table(StringBuilder text, IReadOnlyList<FlavorRules> flavors)
    {
        text.Append("\n| |");
        foreach (var flavor in flavors) text.Append(' ').Append(flavor.Title).Append(" |");
        text.Append("\n|---|");
        foreach (var _ in flavors) text.Append("---|");
        text.Append('\n');
        foreach (var (word, meaning) in FlavorRows.All)
        {
            text.Append("| ").Append(word).Append(" |");
            foreach (var flavor in flavors) text.Append(' ').Append(meaning(flavor)).Append(" |");
            text.Append('\n');
        }
    }
}
