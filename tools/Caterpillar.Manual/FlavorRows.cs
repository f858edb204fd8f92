using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Flavors;

namespace Caterpillar.Manual;

/// <summary>The rows of the tables in <c>docs/gcode.md</c>: a word and its meaning in a flavor.</summary>
internal static class FlavorRows
{
    public static IReadOnlyList<(string Word, Func<FlavorRules, string> Says)> All { get; } =
    [
        ("E is relative", d => d.RelativeE switch
        {
            RelativeERule.EitherG91OrM83 => "in G91 **or** M83",
            RelativeERule.LastWins => "by the last of G90, G91, M82, M83",
            RelativeERule.OnlyM82M83 => "in M83",
            _ => "in G91; M82, M83 unknown",
        }),
        ("`G92` alone", d => d.BareG92 switch
        {
            BareG92Rule.Nothing => "nothing",
            BareG92Rule.ZeroAll => "X Y Z E are 0 here",
            _ => "resets the offsets of X Y Z, E is 0",
        }),
        ("resets `G92 X…`", d => List(d.ShiftResets)),
        ("several G in a line", d => (d.Commands switch { CommandsRule.All => "all count, modes first", CommandsRule.InOrder => "one after the other",
            CommandsRule.First => "the first counts", _ => "the last counts" }) + (d.Letters.Length > 0 ? "; unknown letters: line refused" : "")),
        ("axis words without G", d => d.ModalMotion switch
        {
            ModalMotionRule.Never => "nothing",
            ModalMotionRule.WithoutG => "the last motion again",
            _ => "the last motion again, also after modal words",
        }),
        ("homing", d => List(d.HomingCommands)
            + (d.Homing == HomingRule.HomesToZero ? ": named axes, or all" : ": via the named point to the stored position (`G28.1`, `G30.1`)")
            + (d.HomingSelectsXy ? "; then `G17`" : "") + (d.HomingKeepsShifts ? "; `G92 X…` stays" : "")
            + (d.HomesToNumber ? "; a number other than 0 is the position" : "")),
        ("`G20`", d => !d.Inches ? "refused"
            : d.InchesOfE switch { InchesOfERule.Inches => "inches, E too", InchesOfERule.InchesOrCubic => "inches, E too (in³ in `M200`)",
            _ => "inches, not E" }),
        ("`G53`, `G54` … `G59.3`", d => d.WorkspacesByG92 ? "`G54` … `G59.3`: workspaces, set by `G92`"
            : d.Workspaces ? "workspaces, set by `G10 L2`, `L20`" : "nothing"),
        ("home offset, `M206`", d => d.HomeOffset switch
        {
            HomeOffsetRule.AtOnce => "at once",
            HomeOffsetRule.AtHoming => "from the next homing on",
            HomeOffsetRule.OfWorkspace => "origin of the workspace, with the other sign",
            _ => "–",
        }),
        ("babysteps, `M290 Z`", d => d.LargestBabystep == 0 ? "–" : "move by at most " + Mm(d.LargestBabystep)
            + (d.HomingKeepsBabysteps ? "; R0 sets their sum; homing keeps them" : "; homing Z forgets them")),
        ("stored positions", d => d.SavedPositions ? "`G60`, `G61`" : d.RestorePoints ? "`G60`, `G1 R`" : "–"),
        ("splines, `G5`", d => d.Splines ? "in XY" : "–"),
        ("`G2`, `G3`", Arcs),
        ("arcs by R", d => !d.Arcs ? "–" : !d.RadiusArcs ? "refused" : Radius(d)),
        ("R and I J K", d => !d.Arcs || !d.RadiusArcs
            && d.RadiusAndCenter != RadiusAndCenterRule.Refused ? "–"
            : d.RadiusAndCenter switch { RadiusAndCenterRule.CenterWins => "I J K count", RadiusAndCenterRule.RadiusWins => "R counts", _ => "refused" }),
        ("P of an arc", d => !d.Arcs ? "–" : d.ArcTurns switch
        {
            ArcTurnsRule.Ignored => "nothing",
            ArcTurnsRule.Count => "total turns",
            ArcTurnsRule.Added => "additional turns",
            ArcTurnsRule.CirclesFirst => "flat circles before it, without E",
            ArcTurnsRule.OneCircle => "P1 of a full circle only",
            _ => "refused",
        }),
        ("end off the circle", d => !d.Arcs ? "–" : d.ArcTolerance is { } t
            ? "refused beyond " + Mm(t.Smallest) + " and " + NumberFormatter.Format(t.Relative * 100, 1) + " %, or " + Mm(t.Largest) : "taken"),
        ("`G18`, `G19`", d => !d.Arcs ? "–" : !d.Planes ? "nothing" : d.MirroredZx ? "planes XZ (G3 from X to Z) and YZ" : "planes ZX and YZ"),
        ("`G90.1`, `G91.1`", d => !d.Arcs ? "–" : d.AbsoluteCenters ? "centers absolute, relative" : "centers always relative"),
        ("`G10`, `G11`", d => d.FirmwareRetraction
            ? "retract, deretract" + (d.NoRetractionWith.Length > 0 ? "; not with " + string.Join(" ", d.NoRetractionWith.Select(c => c.ToString())) : "")
            : "no retraction"),
        ("settings for them", d => d.RetractionSettings switch
        {
            RetractionCommands.Marlin => "`M207 S F" + (d.RetractionLifts ? " Z" : "") + "`, `M208 S F`",
            RetractionCommands.RepRapFirmware => "`M207 S R F T Z`",
            RetractionCommands.Klipper => "`SET_RETRACTION`; then `G11` does nothing until `G10`",
            _ => "–",
        }),
        ("`G4 P`", d => d.DwellP == 1 ? "seconds" : "milliseconds"),
        ("`G4 S`", d => d.DwellS == 0 ? "nothing" : d.DwellSums ? "additional seconds" : "seconds, instead of P"),
        ("`M220 S`", d => !d.SpeedFactor ? "nothing"
            : "% of speed" + (d.SpeedMemory != SpeedMemoryRule.None ? "; B saves, R restores" : "") + (d.FactorsReset ? "; alone 100 %" : "")),
        ("`M221 S`", d => d.FlowFactor switch
        {
            FlowFactorRule.Ignored => "nothing",
            FlowFactorRule.AllTools => "% of flow",
            FlowFactorRule.PerTool => "% of the tool's flow" + (d.FlowToolLetter.Length > 0 ? " (" + d.FlowToolLetter + ")" : ""),
            _ => "% of flow, until the tool changes",
        } + (d.FactorsReset ? "; alone 100 %" : "")),
        ("`M200 D`", d => d.StartsVolumetric ? "nothing: E is in mm³ from the start" : d.Volumetric ? "E in mm³; D0 in mm" : "nothing"),
        ("position of E", d => d.PositionOfE switch { PositionOfERule.Shared => "shared by the tools", PositionOfERule.PerTool => "separate for each tool",
            _ => "0 after a tool change" }),
        ("tool change", Tools),
        ("fan, `M106 S`", d => d.Fan switch { FanScale.Byte => "0 to 255", FanScale.FractionOrByte => "0 to 1, or 0 to 255",
            FanScale.Switch => "0 = off, others = on", _ => "nothing" }
            + (d.FanLetter != 'S' ? " (" + d.FanLetter + ")" : "") + (d.ValveIsFan ? "; also `M126`, `M127`" : "")),
        ("extruder", d => (d.ExtruderLetters.Length == 0 ? "" : string.Join(", ", d.ExtruderLetters.Select(c => c.ToString())))
            + (d.SwitchedExtruder ? (d.ExtruderLetters.Length == 0 ? "" : ", or ") + "`M101`" + (d.SwitchedTools ? ", `M201` …" : "") + ", `M103`"
                : d.ExtruderLetters.Length == 0 ? "none" : "")),
        ("without extrusion", d => d.PrintsWithoutE ? "G1 to G3 draw" : "all moves are travel moves"),
        ("motion limits", d => d.Limits switch
        {
            LimitCommands.Marlin => "`M201`, `M203` (mm/s), `M204 S P T R`, `M205` (jerk; J)",
            LimitCommands.RepRapFirmware => "`M201`, `M203` (mm/min), `M204 S P T`, `M566`",
            LimitCommands.Klipper => "`M204` (S, or P and T), `SET_VELOCITY_LIMIT`",
            _ => "`M204` (S, or P)",
        }),
        ("progress, `M73`", d => d.Progress switch
        {
            ProgressCommand.Percent => "P: percent",
            ProgressCommand.PercentAndMinutes => "P: percent, R: remaining minutes",
            _ => "–",
        }),
        ("saves and restores", d => d.ModeStack ? "`M120`, `M121`: the modes" : d.ExtendedCommands
            ? "`SAVE_GCODE_STATE`, `RESTORE_GCODE_STATE`; `SET_GCODE_OFFSET`" : "–"),
        ("pause", d => List(d.Pauses)),
        ("also wait", d => d.Dwells.Count > 1 ? List(d.Dwells.Skip(1).ToArray()) + " with S or P" : "–"),
    ];

    public static string Code(string word) => "`" + word + "`";

    private static string List(IReadOnlyList<string> words) => words.Count == 0 ? "–" : string.Join(", ", words.Select(Code));

    private static string Mm(double value) => NumberFormatter.Format(value, 4) + " mm";

    private static string Arcs(FlavorRules d) => !d.Arcs ? "refused" : "I J K"
        + (d.ArcsInRelativeMode ? "" : "; refused in G91")
        + (d.ArcWithoutCenterIsLine ? "; without center: a line" : "; refused without center")
        + (d.ArcNamesEnd ? ", or without end" : "")
        + (d.CounterclockwiseCircles ? "" : "; full circles by G2 only")
        + (d.HelixRisesFirst ? "; Z moves before the circle" : "");

    private static string Radius(FlavorRules d) => (d.RadiusInXyOnly ? "in XY; " : "")
        + (double.IsInfinity(d.ShortRadius) ? "too short: half a circle" : d.ShortRadius > 0
            ? "up to " + NumberFormatter.Format(d.ShortRadius * 100, 0) + " % too short, else refused" : "too short: refused");

    private static string Tools(FlavorRules d)
    {
        if (d.ToolLimit == 0) return "none (T is only stored)";
        var text = d.ToolByM6 ? "`T` selects, `M6` changes" : "`T`" + (d.ToolLimit < 1000 ? " below " + NumberFormatter.Format(d.ToolLimit) : "");
        return d.ToolCommands.Count == 0 ? text : text + ", " + List(d.ToolCommands);
    }
}
