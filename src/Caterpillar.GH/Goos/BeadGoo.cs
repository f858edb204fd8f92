namespace Caterpillar.GH.Goos;

/// <summary>A bead on a wire. A number is its width in mm, with the height of a standard layer. Text is "width x height".</summary>
public sealed class BeadGoo : GH_Goo<Bead>, IReadsText
{
    private static readonly char[] Separators = ['x', '×', ',', ';', ' '];
    private static readonly double Height = new PrintSettings().LayerHeight;

    // A bead without extrusion has only zeros.
    private bool _isSet;

    public BeadGoo()
    {
    }

    public BeadGoo(Bead bead)
    {
        Value = bead;
        _isSet = true;
    }

    public override bool IsValid => _isSet;

    public override string IsValidWhyNot => _isSet ? "" : "No bead.";

    public override string TypeName => "Bead";

    public override string TypeDescription => "A bead of an extrusion: area in mm², height in mm, speed in mm/s.";

    public string? Problem => _isSet ? null : "This is not a bead. Use a width in mm, or width x height: 0.5 x 0.2.";

    public override IGH_Goo Duplicate() => (IGH_Goo)MemberwiseClone();

    /// <summary>The value for script components.</summary>
    public override object ScriptVariable() => Value;

    public override bool CastFrom(object source)
    {
        var bare = Wrapped.Bare(source);
        if (bare is BeadGoo { _isSet: true } goo) bare = goo.Value;
        if (bare is Bead bead) return Set(bead);
        if (Wrapped.Number(bare) is { } width) return FromSize(width, Height);
        return Wrapped.Text(bare) is { } text && FromText(text);
    }

    public override bool Write(GH_IWriter writer)
    {
        if (!_isSet) return true;
        writer.SetInt32("Version", StoredText.Version);
        writer.SetDouble("Area", Value.Area);
        writer.SetDouble("Height", Value.Height);
        writer.SetDouble("Speed", Value.Speed);
        return true;
    }

    public override bool Read(GH_IReader reader)
    {
        double area = 0, height = 0, speed = 0;
        if (!reader.TryGetDouble("Area", ref area)) return true;
        reader.TryGetDouble("Height", ref height);
        reader.TryGetDouble("Speed", ref speed);
        return Set(new Bead(area, height, speed));
    }

    public override bool CastTo<Q>(ref Q target)
    {
        if (Value is not Q value) return false;
        target = value;
        return true;
    }

    private bool Set(Bead bead)
    {
        Value = bead;
        return _isSet = true;
    }

    // "0.5 x 0.2", "0.5 × 0.2", "0.5, 0.2" or "0.5".
    private bool FromText(string text)
    {
        var words = text.Split(Separators, StringSplitOptions.RemoveEmptyEntries);
        var height = Height;
        return words.Length is 1 or 2 && NumberReader.TryParse(words[0], out var width)
            && (words.Length == 1 || NumberReader.TryParse(words[1], out height)) && FromSize(width, height);
    }

    private bool FromSize(double width, double height)
    {
        try
        {
            return Set(Bead.FromWidth(width, height, shape: BeadShape.Stadium));
        }
        catch (ArgumentException)
        {
            return false;
        }
    }

    public override string ToString() => _isSet ? $"Bead ({Value})" : "No Bead";
}
