namespace Caterpillar.GCode;

/// <summary>Settings of the firmware retraction as lines of G-code.</summary>
internal static class RetractionText
{
    public static IEnumerable<string> Lines(RetractionEvent what, RetractionCommands commands) => commands switch
    {
        RetractionCommands.Marlin => Line("M207", (" S", what.Length, 1), (" F", what.Speed, 60))
            .Concat(Line("M208", (" S", what.Extra, 1), (" F", what.Back, 60))),
        RetractionCommands.RepRapFirmware => Line("M207", (" S", what.Length, 1), (" R", what.Extra, 1), (" F", what.Speed, 60), (" T", what.Back, 60)),
        RetractionCommands.Klipper => Line("SET_RETRACTION", (" RETRACT_LENGTH=", what.Length, 1), (" RETRACT_SPEED=", what.Speed, 1),
            (" UNRETRACT_EXTRA_LENGTH=", what.Extra, 1), (" UNRETRACT_SPEED=", what.Back, 1)),
        _ => [],
    };

    private static IEnumerable<string> Line(string command, params (string Word, double? Value, double Unit)[] words)
    {
        var text = string.Concat(words.Where(w => w.Value is not null).Select(w => w.Word + NumberFormatter.Format(w.Value!.Value * w.Unit, 5)));
        return text.Length > 0 ? [command + text] : [];
    }
}
