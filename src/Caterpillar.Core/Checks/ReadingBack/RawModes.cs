using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

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
        var usual = new Modes(format.RelativeXyz, format.WritesRelative, false, plan.VolumePerE(0) == 1, Percent);
        var events = plan.Events;
        for (var i = 0; i < events.Count; i++)
        {
            if (events[i].Event is not RawEvent raw || events[i].Move >= plan.Count) continue;
            var state = usual;
            foreach (var line in raw.Line.Split('\n', '\r')) state = state.After(line);
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

    private readonly record struct Modes(bool Relative, bool RelativeE, bool Inches, bool IsVolume, double Flow)
    {
        public Modes After(string line)
        {
            var state = this;
            var end = line.IndexOf(';', 0);
            var code = (end < 0 ? line : line.Substring(0, end)).ToUpperInvariant();
            for (var i = 0; i < code.Length; i++)
            {
                if (code[i] == '(')
                {
                    i = code.IndexOf(')', i);
                    if (i < 0) break;
                    continue;
                }
                if (code[i] is not ('G' or 'M') || (i > 0 && char.IsLetter(code[i - 1]))) continue;
                state = state.After(code[i], Number(code, i + 1), code);
            }
            return state;
        }

        public string Word(Modes usual)
            => Relative != usual.Relative ? (Relative ? "relative positions (G91)" : "absolute positions (G90)") : Inches ? "inches (G20)" : RelativeE
                ? "relative E (M83)" : "absolute E (M82)";

        private Modes After(char letter, double? number, string code) => (letter, number) switch
        {
            ('G', 90) => this with { Relative = false },
            ('G', 91) => this with { Relative = true },
            ('G', 20) => this with { Inches = true },
            ('G', 21) => this with { Inches = false },
            ('M', 82) => this with { RelativeE = false },
            ('M', 83) => this with { RelativeE = true },
            ('M', 200) => this with { IsVolume = Word(code, 'D') is not 0 && Word(code, 'S') is not 0 },
            ('M', 221) => this with { Flow = Word(code, 'S') ?? Flow },
            _ => this,
        };

        // The number of a word of a line with one command, or null.
        private static double? Word(string code, char letter) => code.IndexOf(letter, 0) is >= 0 and var at ? Number(code, at + 1) : null;

        private static double? Number(string code, int at)
        {
            while (at < code.Length && code[at] == ' ') at++;
            var end = at;
            while (end < code.Length && (char.IsDigit(code[end]) || code[end] == '.')) end++;
            return NumberReader.TryParse(code.Substring(at, end - at), out var value) ? value : null;
        }
    }
}
