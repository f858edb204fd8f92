using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Flavors;

namespace Caterpillar.Manual;

/// <summary>The page of the manual on flavors (<c>docs/gcode.md</c>), made from <see cref="FlavorTable"/>.</summary>
internal static class FlavorManual
{
    private const string Beginning = """
        # Flavors of G-code

        The same line of G-code means different things to different firmware. A flavor is what one firmware understands. Choose the right one, and files
        are read, written and converted as your printer does it.

        On the canvas: [Decode G-code](components/DecodeGCode.md), [Printer](components/Printer.md).

        - **To write**, the printer's profile names its flavor in `gcode_flavor`.
        - **To read**, the file decides: by comments of its slicer, or by commands that only one firmware has. If nothing tells, it is Marlin 2. You can
          choose: *Flavor* of Decode G-code, or `caterpillar decode --flavor NAME`.
        - **To convert**, use `caterpillar convert --flavor NAME`.

        If the flavor changes the result, a message names the line. *Refused* means that the command does nothing, the head does not move, and a message
        says why. What is in no table is reported as not understood.

        The tables at the end list [the differences](#appendix-differences-between-firmwares) and [all commands](#all-commands). They are made from the
        program's own (`src/Caterpillar.Core/Flavors/Firmware`), which were compared with the [source of each firmware](#appendix-sources).

        ## The same for all

        - `G0` and `G1` move in a straight line. `F` applies until the next one (mm/min, or inches/min). `G17` is the XY plane, `G21` is millimeters,
          `G90` and `G91` switch X, Y and Z.
        - `G92 X… Y… Z…` renames the position without moving. `G92 E` sets the position of E. You always get machine positions, which `G92` does not change.
        - A missing I, J or K is 0, relative to the start. The end of an arc is the position in its line, even if it is not quite on the circle. If start
          and end are equal, the arc is a full circle. A third axis makes a helix. R > 0 is the shorter arc, R < 0 the longer one.
        - `M104`, `M109`, `M140`, `M190`, `M106`, `M107`, `M400` and motion limits become events of the toolpath. Of the lines that begin with `M`, only
          `M290` moves the head.
        - `;` and `( )` are comments, and `*` begins a checksum. A leading `N` word and `/` are ignored. Lines that begin with `%`, `@` or `<` do nothing.
        - A file does not contain the zero of a machine, its stored positions, or the retraction of its firmware. Homing ends at 0, and stored positions
          are 0 until the file stores others. G10 retracts by the printer's profile until the file sets a length.
        - After a macro (`START_PRINT`, `M98`) the position is unknown until the file homes or states each axis. If a file prints before that, you get
          `file.unknown_position`. Declare the macro in the printer's key `macros` to avoid that.

        """;

    /// <summary>The page as Markdown.</summary>
    public static string Write()
    {
        var text = new StringBuilder();
        text.Append(Beginning);
        var all = FlavorTable.All;
        text.Append("\n## Not supported\n\nThese commands move the head or change its coordinates, and Caterpillar does not follow them. A warning "
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
        text.Append("\n## Appendix: differences between firmwares\n");
        for (var first = 0; first < all.Count; first += 5) Table(text, all.Skip(first).Take(5).ToArray());
        text.Append("\n## Appendix: sources\n\n| name | flavor | compared with |\n|---|---|---|\n");
        foreach (var flavor in all) text.Append("| `").Append(flavor.Name).Append("` | ").Append(flavor.Title).Append(" | ").Append(flavor.Source)
            .Append(" |\n");
        text.Append("\nFor every row and flavor, `tests/Caterpillar.Core.Tests/GCode/Flavors` has small programs with their results.\n");
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
