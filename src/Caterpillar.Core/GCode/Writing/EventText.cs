namespace Caterpillar.GCode;

/// <summary>Events as lines of G-code.</summary>
internal static class EventText
{
    public static IEnumerable<string> Lines(PrinterEvent what, FlavorRules rules)
    {
        switch (what)
        {
            case NozzleTemperatureEvent nozzle:
                yield return (nozzle.Wait ? "M109" : "M104") + (nozzle.Tool is { } of ? " T" + NumberFormatter.Format(of) : "") + " S"
                    + NumberFormatter.Format(nozzle.Celsius, 1);
                break;
            case BedTemperatureEvent bed:
                yield return (bed.Wait ? "M190 S" : "M140 S") + NumberFormatter.Format(bed.Celsius, 1);
                break;
            case FanEvent fan:
                var speed = Math.Min(Math.Max(fan.Speed, 0), 1);
                if (rules.Fan == FanScale.None) break;
                if (rules.ValveIsFan && rules.Fan == FanScale.Switch) yield return speed > 0 ? "M126" : "M127";
                else if (rules.Fan == FanScale.FractionOrByte) yield return "M106 " + rules.FanLetter + NumberFormatter.Format(speed, 3);
                else yield return speed == 0 ? "M107" : "M106 " + rules.FanLetter + NumberFormatter.Format(speed * 255, 0);
                break;
            case ToolEvent tool when tool.Tool >= rules.ToolLimit:
                break;
            case ToolEvent tool:
                yield return Tool(tool.Tool, rules);
                break;
            case ChamberTemperatureEvent chamber:
                yield return (chamber.Wait ? "M191 S" : "M141 S") + NumberFormatter.Format(chamber.Celsius, 1);
                break;
            case PressureAdvanceEvent advance:
                foreach (var line in SetupFindings.PressureAdvance(rules, advance.Seconds, advance.Tool)) yield return line;
                break;
            case AccelerationEvent acceleration when rules.Limits == LimitCommands.Repetier:
                yield return LimitText.Line(new LimitEvent(MotionLimit.PrintAcceleration, acceleration.Value), rules.Limits)!;
                yield return LimitText.Line(new LimitEvent(MotionLimit.TravelAcceleration, acceleration.Value), rules.Limits)!;
                break;
            case AccelerationEvent acceleration:
                yield return "M204 S" + NumberFormatter.Format(acceleration.Value, 0);
                break;
            case LimitEvent limit:
                if (LimitText.Line(limit, rules.Limits) is { } text) yield return text;
                break;
            case RetractionEvent retraction:
                foreach (var line in RetractionText.Lines(retraction, rules.RetractionSettings)) yield return line;
                break;
            case ProgressEvent shown when rules.Progress != ProgressCommand.None:
                yield return "M73 P" + NumberFormatter.Format(shown.Percent)
                    + (rules.Progress == ProgressCommand.PercentAndMinutes ? " R" + NumberFormatter.Format(shown.MinutesLeft) : "");
                break;
            case FinishMovesEvent:
                yield return "M400";
                break;
            case DwellEvent dwell:
                yield return rules.DwellP == 1 ? "G4 P" + NumberFormatter.Format(dwell.Seconds, 3) : "G4 P" + NumberFormatter.Format(dwell.Seconds * 1000, 0);
                break;
            case PauseEvent pause:
                if (pause.Message.Length > 0) yield return "; " + OneLine(pause.Message);
                yield return rules.Pauses.Count > 0 ? rules.Pauses[0] : "M0";
                break;
            case HomeEvent home:
                var zero = rules.Homing == HomingRule.HomesToZero ? "" : "0";
                yield return home.X && home.Y
                    && home.Z ? "G28" : "G28" + (home.X ? " X" + zero : "") + (home.Y ? " Y" + zero : "") + (home.Z ? " Z" + zero : "");
                break;
            case CommentEvent comment:
                yield return comment.Text.Length > 0 ? "; " + OneLine(comment.Text) : ";";
                break;
            case RawEvent raw:
                foreach (var line in raw.Line.Split('\n')) yield return line.TrimEnd('\r');
                break;
        }
    }

    public static string Tool(int tool, FlavorRules rules) => (rules.ToolByM6 ? "M6 T" : "T") + NumberFormatter.Format(tool);

    private static string OneLine(string text) => text.Replace('\r', ' ').Replace('\n', ' ');
}
