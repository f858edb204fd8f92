namespace Caterpillar.Checks;

/// <summary>
/// Raw lines of a design that leave the machine in another mode: G91, M82 or M83, G20. The writer states the modes again after each, so that what was meant to
/// follow in that mode would not. M221 and M200 it does not state: after them the same E is another amount of material.
/// </summary>
internal static class RawModes
{
    // Flow, as M221 states it.
    private const double Percent = 100;

    public static void Run(Toolpath plan, GCodeFormat format, Findings findings, Func<int, SourceLocation?> placeOfEvent)
    {
        var usual = After("", plan, format);
        var events = plan.Events;
        for (var i = 0; i < events.Count; i++)
        {
            if (events[i].Event is not RawEvent raw || events[i].Move >= plan.Count) continue;
            var state = After(raw.Line, plan, format);
            var at = i;
            if (state with { IsVolume = usual.IsVolume, Flow = usual.Flow } != usual)
                findings.Add(CheckCodes.FileModes, () => placeOfEvent(at), () => $"A raw line switches to {state.Word(usual)} and does not switch back. "
                    + "Put the commands that need this mode, and the command that ends it, into the same raw text.");
            if (format.Flavor.Volumetric && state.IsVolume != usual.IsVolume)
                findings.Add(CheckCodes.FileExtrusion, () => placeOfEvent(at),
                    () => $"A raw line switches to E in {(state.IsVolume ? "mm³" : "mm of filament")} (M200), but the extrusions after it are in "
                        + $"{(state.IsVolume ? "mm of filament" : "mm³")}. Remove it, or set e_unit of the printer.");
            if (format.Flavor.FlowFactor != FlowFactorRule.Ignored && state.Flow != usual.Flow)
                findings.Add(CheckCodes.FileExtrusion, () => placeOfEvent(at), () => $"A raw line sets the flow to {NumberFormatter.Format(state.Flow, 1)} % "
                    + "(M221), which changes all extrusions after it. Remove it and set flow_ratio instead.");
        }
    }

    // What holds after the modes of a file and these lines.
    private static Modes After(string lines, Toolpath plan, GCodeFormat format)
    {
        var machine = new GCodeInterpreter(format.Flavor, ExtrusionRule.Balance, ExtrusionAxis.E);
        string[] usual = [format.RelativeXyz ? "G91" : "G90", format.WritesRelative ? "M83" : "M82", plan.VolumePerE(0) == 1 ? "M200 D1" : "M200 D0"];
        foreach (var line in usual.Concat(lines.Split('\n', '\r')))
        {
            var bytes = TextEncoding.Encode(line);
            machine.ReadLine(bytes, 0, bytes.Length, out _);
        }
        var modes = machine.State.Modes;
        return new Modes(modes.Relative, modes.M83, modes.Inches, modes.Volumetric, Percent * machine.State.Extrusion.Flow);
    }

    private readonly record struct Modes(bool Relative, bool RelativeE, bool Inches, bool IsVolume, double Flow)
    {
        public string Word(Modes usual)
            => Relative != usual.Relative ? (Relative ? "relative positions (G91)" : "absolute positions (G90)") : Inches ? "inches (G20)" : RelativeE
                ? "relative E (M83)" : "absolute E (M82)";
    }
}
