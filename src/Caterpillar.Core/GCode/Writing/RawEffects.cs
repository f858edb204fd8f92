namespace Caterpillar.GCode;

/// <summary>Possible effects of raw lines and templates on the following lines.</summary>
internal sealed class RawEffects(FlavorRules rules, byte extruder)
{
    private readonly ParsedLine _line = new();
    private readonly FlavorCommands _commands = FlavorCommands.Of(rules);

    /// <summary>Modes: absolute or relative, mode of E, unit other than mm, plane other than XY.</summary>
    public bool Modes { get; private set; }

    public bool Unit { get; private set; }

    public bool Plane { get; private set; }

    /// <summary>Position of the head, and its feed rate.</summary>
    public bool Position { get; private set; }

    /// <summary>Zero of E.</summary>
    public bool E { get; private set; }

    /// <summary>The last selected tool, or null.</summary>
    public int? Tool { get; private set; }

    /// <summary>The last switch of the extruder, on or off (M101, M103), or null.</summary>
    public bool? Switch { get; private set; }

    /// <summary>True if anything may have changed.</summary>
    public bool Unknown { get; private set; }

    /// <summary>Reads these lines and forgets the effects of earlier ones.</summary>
    public void Read(IEnumerable<string> lines)
    {
        Modes = Unit = Plane = Position = E = Unknown = false;
        Tool = null;
        Switch = null;
        foreach (var text in lines)
        {
            foreach (var line in text.Split('\n', '\r'))
            {
                var bytes = TextEncoding.Encode(line);
                _line.Scan(bytes, 0, bytes.Length);
                if (_line.Shape == LineShape.Macro) Macro(TextEncoding.Decode(bytes, _line.CodeStart, _line.CodeEnd).Trim().ToUpperInvariant());
                else if (_line.Shape == LineShape.Code) Code();
            }
        }
        if (Unknown) Modes = Unit = Plane = Position = E = true;
    }

    private void Code()
    {
        for (var i = 0; i < _line.Count; i++)
        {
            if (!_line.HasValue[i]) continue;
            var number = _line.Values[i];
            switch ((char)_line.Letters[i])
            {
                case 'G':
                    G(number);
                    break;
                case 'M' when i == 0:
                    M(number);
                    return;
                case 'T' when i == 0 && !rules.ToolByM6 && number is >= 0 and < 1000:
                    Tool = (int)number;
                    Position = true;
                    break;
            }
        }
        // A line of words alone continues the last motion.
        if (_line.Letters[0] is (byte)'X' or (byte)'Y' or (byte)'Z' or (byte)'F') Moves();
    }

    private void G(double code)
    {
        if (code is 17 or 18 or 19) Plane = code != 17;
        else if (code is 20 or 21) Unit = code == 20;
        else if (code is 90 or 91) Modes = true;
        else if (code is not (4 or 90.1 or 91.1)) Moves();
        E |= code == 92 && _line.Count == 1;
    }

    private void Moves()
    {
        Position = true;
        E |= extruder != 0 && _line.Has((char)extruder);
    }

    private void M(double code)
    {
        switch (code)
        {
            case 82 or 83:
                Modes = true;
                break;
            case 101 or 103 when rules.SwitchedExtruder:
                Switch = code == 101;
                break;
            case 6 when rules.ToolByM6 && _line.TryGet('T', out var tool) && tool is >= 0 and < 1000:
                Tool = (int)tool;
                Position = true;
                break;
            case 97 or 98 or 120 or 121:
                // Programs of their own, and saved states.
                Unknown = true;
                break;
            case 125 or 600 or 701 or 702:
                Position = true;
                E = true;
                break;
        }
    }

    // Firmware without extended commands does not understand such a line at all.
    private void Macro(string text)
        => Unknown |= rules.ExtendedCommands && text.Length > 0 && _commands.Find(text)?.Class is null or CommandClass.Motion or CommandClass.Home
            or CommandClass.Position or CommandClass.Tool or CommandClass.Flow or CommandClass.Pause or CommandClass.Mode;
}
