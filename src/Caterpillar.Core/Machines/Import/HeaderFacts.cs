namespace Caterpillar.Machines;

/// <summary>Follows the commands of a header or footer and collects facts about the printer.</summary>
internal sealed class HeaderFacts
{
    private static readonly Regex Size = new(
        @"([0-9]{2,5}(?:\.[0-9]{1,3})?)\s{0,3}(?:mm)?\s{0,3}[x×*]\s{0,3}"
        + @"([0-9]{2,5}(?:\.[0-9]{1,3})?)(?:\s{0,3}(?:mm)?\s{0,3}[x×*]\s{0,3}([0-9]{2,5}(?:\.[0-9]{1,3})?))?",
        RegexOptions.CultureInvariant | RegexOptions.IgnoreCase);

    private readonly double?[] _position = new double?[3];

    /// <summary>G90 or G91, or null before either.</summary>
    public bool? Relative { get; private set; }

    /// <summary>M83 or M82, or null before either.</summary>
    public bool? RelativeE { get; private set; }

    public bool Inches { get; private set; }

    /// <summary>True if moves before the first G90 or G91 depend on the mode set before.</summary>
    public bool NeedsMode { get; private set; }

    /// <summary>True if E occurs before the first M82 or M83.</summary>
    public bool NeedsModeE { get; private set; }

    /// <summary>The last temperature above 0 that is a number, °C.</summary>
    public double? NozzleTemperature { get; private set; }

    public double? BedTemperature { get; private set; }

    /// <summary>Minimum temperature for extrusion by M302, °C.</summary>
    public double? MinExtrusionTemperature { get; private set; }

    /// <summary>Size of the machine in a comment; Z is 0 if only X and Y are given.</summary>
    public Vec3? SizeInComment { get; private set; }

    /// <summary>Bounds of absolute positions.</summary>
    public Bounds Seen { get; private set; } = Bounds.Empty;

    public int LastTool { get; private set; }

    public bool IsPrusa { get; private set; }

    /// <summary>Last position of the nozzle, or null if unknown.</summary>
    public Vec3? Position => _position[0] is { } x && _position[1] is { } y && _position[2] is { } z && Moved
        && new Vec3(x, y, z) is { IsFinite: true } p ? p : null;

    private bool Moved { get; set; }

    public void Follow(HeaderLine line)
    {
        if (SizeInComment is null && line.Comment.Length > 0) ReadSize(line.Comment);
        switch (line.Command)
        {
            case "G0" or "G1" or "G2" or "G3":
                Move(line);
                break;
            case "G20" or "G21":
                Inches = line.Command == "G20";
                break;
            case "G28":
                IsPrusa |= line['W'] is not null;
                Home(line);
                break;
            case "G80":
                IsPrusa = true;
                break;
            case "G90" or "G91":
                Relative = line.Command == "G91";
                break;
            case "G92":
                for (var axis = 0; axis < 3; axis++) _position[axis] = line["XYZ"[axis]] ?? _position[axis];
                break;
            case "M82" or "M83":
                RelativeE = line.Command == "M83";
                break;
            case "G10" when line['P'] is not null:
            case "M104" or "M109":
                if (TemperatureOf(line) is { } nozzle) NozzleTemperature = nozzle;
                break;
            case "M140" or "M190":
                if (TemperatureOf(line) is { } bed) BedTemperature = bed;
                break;
            case "M302":
                // P0 switches the guard on again; S is its limit.
                if (line['P'] is not 0) MinExtrusionTemperature = line['S'] is >= 0 and <= 2000 and var least ? least : 0;
                break;
            default:
                if (line.Command.Length > 1 && line.Command[0] == 'T' && line['T'] is >= 0 and < 64 and var tool) LastTool = Math.Max(LastTool, (int)tool);
                break;
        }
    }

    /// <summary>The temperature above 0 that a line sets with a number.</summary>
    public static double? TemperatureOf(HeaderLine line)
        => line['S'] is > 0 and <= 2000 and var set ? set : line['R'] is > 0 and <= 2000 and var reach ? reach : null;

    private void Move(HeaderLine line)
    {
        var hasE = line['E'] is not null;
        NeedsModeE |= hasE && RelativeE is null;
        for (var axis = 0; axis < 3; axis++)
        {
            if (line["XYZ"[axis]] is not { } value) continue;
            Moved = true;
            NeedsMode |= Relative is null;
            _position[axis] = Relative == true ? _position[axis] + value : value;
        }
        if (Relative != true && new Vec3(_position[0] ?? 0, _position[1] ?? 0, _position[2] ?? 0) is { IsFinite: true } p) Seen = Seen.Include(p);
    }

    private void Home(HeaderLine line)
    {
        var all = line['X'] is null && line['Y'] is null && line['Z'] is null;
        for (var axis = 0; axis < 3; axis++)
        {
            if (all || line["XYZ"[axis]] is not null) _position[axis] = 0;
        }
    }

    private void ReadSize(string comment)
    {
        var match = Size.Match(comment);
        if (!match.Success) return;
        var size = new double[3];
        for (var i = 0; i < 3; i++)
        {
            if (match.Groups[i + 1].Success && NumberReader.TryParse(match.Groups[i + 1].Value, out var value)) size[i] = value;
        }
        if (size[0] >= 40 && size[1] >= 40) SizeInComment = new Vec3(size[0], size[1], size[2] >= 40 ? size[2] : 0);
    }
}
