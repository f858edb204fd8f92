using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Basics;

namespace Caterpillar.Machines;

/// <summary>The page of the manual on dialects (<c>docs/gcode.md</c>), made from <see cref="DialectTable"/>.</summary>
public static class DialectManual
{
    private static readonly (string Word, Func<DialectRules, string> Says)[] Rows =
    [
        ("E relative when", d => d.RelativeE switch
        {
            RelativeERule.EitherG91OrM83 => "G91 **or** M83",
            RelativeERule.LastWins => "the last of G90, G91, M82, M83 says so",
            RelativeERule.OnlyM82M83 => "M83",
            _ => "G91 (M82, M83 unknown)",
        }),
        ("`G92` alone", d => d.BareG92 switch
        {
            BareG92Rule.Nothing => "nothing",
            BareG92Rule.ZeroAll => "X Y Z E are 0 here",
            _ => "takes shifts of X Y Z back, E is 0",
        }),
        ("`G92 X…`", _ => "names the place, no motion"),
        ("axis words without G", d => d.ModalMotion switch
        {
            ModalMotionRule.Never => "ignored",
            ModalMotionRule.WithoutG => "repeat the last motion",
            _ => "repeat the last motion, also behind modal words",
        }),
        ("`G28`", d => d.Homing == HomingRule.HomesToZero ? "homes the named axes, or all, to 0" : "goes to a stored position (taken as 0)"),
        ("`G20`", d => d.Inches ? "inches" : "refused"),
        ("`G2`, `G3`", d => !d.Arcs ? "unknown" : "I J K" + (d.RadiusArcs ? ", R" : "") + (d.ArcsInRelativeMode ? "" : "; refused in G91") + (d.ArcWithoutCenterIsLine ? "; a line without centre" : "")),
        ("`P` of an arc", d => !d.Arcs ? "–" : d.ArcTurns ? "turns" : "ignored"),
        ("`G18`, `G19`", d => !d.Arcs ? "–" : d.Planes ? "planes ZX and YZ" : "ignored"),
        ("`G90.1`, `G91.1`", d => d.AbsoluteCenters ? "centres absolute, relative" : "ignored"),
        ("`G10`, `G11`", d => d.FirmwareRetraction ? "retract, restore" : "no retraction"),
        ("`G4 P`", d => d.DwellP == 1 ? "seconds" : "milliseconds"),
        ("`G4 S`", d => d.DwellS == 0 ? "ignored" : "seconds"),
        ("`M220 S`", d => d.SpeedFactor ? "% of speed" : "ignored"),
        ("`M221 S`", d => d.FlowFactor ? "% of material" : "ignored"),
        ("`M200 D`", d => d.StartsVolumetric ? "E is in mm³ from the start" : d.Volumetric ? "E in mm³" : "ignored"),
        ("position of E", d => d.SharedE ? "shared by the tools" : "each tool its own"),
        ("tool change", d => d.ToolByM6 ? "`T` chooses, `M6` changes" : "`T`" + (d.ToolLimit < 1000 ? " below " + NumberFormatter.Format(d.ToolLimit) : "")),
        ("`M106 S`", d => d.Fan == FanScale.Byte ? "0 to 255" : "0 to 1, or 0 to 255"),
        ("extruder", d => (d.ExtruderLetters.Length == 0 ? "" : string.Join(", ", d.ExtruderLetters.Select(c => c.ToString())))
            + (d.SwitchedExtruder ? (d.ExtruderLetters.Length == 0 ? "" : ", or ") + "`M101`, `M103`" : d.ExtruderLetters.Length == 0 ? "none" : "")),
        ("without extrusion", d => d.StrokesWithoutE ? "G1 to G3 are strokes" : "all motion is travel"),
        ("pause", d => d.Pauses.Count == 0 ? "–" : string.Join(", ", d.Pauses.Select(p => "`" + p + "`"))),
    ];

    /// <summary>The page as Markdown.</summary>
    public static string Write()
    {
        var text = new StringBuilder();
        text.Append("# Dialects of G-code\n\n");
        text.Append("What each word means to each firmware, as the decoder, the writer and `convert` take it. This page is made from the table of dialects (`Machines/DialectTable.cs`);\n");
        text.Append("`caterpillar decode --dialect NAME` and the key `dialect` of a printer choose one. Without a choice the file decides: comments of its slicer, commands that only one firmware has;\n");
        text.Append("where it says nothing, Marlin 2. Where the dialect changes the result, a diagnostic says so and names the line.\n");
        var all = DialectTable.All;
        for (var first = 0; first < all.Count; first += 5) Table(text, all.Skip(first).Take(5).ToArray());
        text.Append("\nThe same for all: `G0` and `G1` move in a straight line; `G17` is the plane XY; `G21` is millimetres; `G90` and `G91` switch X, Y and Z; `F` holds until the next (mm/min); `G92 E` names the\n");
        text.Append("position of E; `M104`, `M109`, `M140`, `M190`, `M106`, `M107`, `M204` become events of the toolpath. A line that begins with `M` never moves. `;` and `( )` are comments, `*` begins a\n");
        text.Append("checksum, a leading `N` word and `/` are dropped, lines that begin with `%`, `@`, `<` or an extended command do nothing. Everything else is counted and reported.\n");
        text.Append("\n## Sources\n\n| name | dialect | where its rules stand | compared with it |\n|---|---|---|---|\n");
        foreach (var dialect in all) text.Append("| `").Append(dialect.Name).Append("` | ").Append(dialect.Title).Append(" | ").Append(dialect.Source).Append(dialect.Confirmed ? " | yes |\n" : " | not yet: from documentation and experience |\n");
        return text.ToString();
    }

    private static void Table(StringBuilder text, IReadOnlyList<DialectRules> dialects)
    {
        text.Append("\n| |");
        foreach (var dialect in dialects) text.Append(' ').Append(dialect.Title).Append(" |");
        text.Append("\n|---|");
        foreach (var _ in dialects) text.Append("---|");
        text.Append('\n');
        foreach (var (word, says) in Rows)
        {
            text.Append("| ").Append(word).Append(" |");
            foreach (var dialect in dialects) text.Append(' ').Append(says(dialect)).Append(" |");
            text.Append('\n');
        }
    }
}
