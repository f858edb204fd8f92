namespace Caterpillar.GH.Goos;

/// <summary>A G-code file on a wire, as one value. A Panel shows a summary, G-code Text shows its lines.</summary>
public sealed class GCodeGoo : ValueGoo<GCodeDocument>
{
    public override string TypeName => "G-code";

    public override string TypeDescription => "A G-code file, byte for byte.";

    /// <summary>Text is G-code. The full path of a file is the G-code of that file.</summary>
    public override bool CastFrom(object source)
    {
        if (base.CastFrom(source)) return true;
        if (Wrapped.Text(source) is not { } text) return false;
        Value = IsFile(text) ? GCodeDocument.ReadFile(text.Trim()).Value! : GCodeDocument.FromText(text);
        return Value is not null;
    }

    public override bool Write(GH_IWriter writer)
    {
        if (Value is null) return true;
        writer.SetString("Name", StoredText.Pack(Value.Name));
        writer.SetByteArray("File", StoredText.Deflate(Value.ToBytes()));
        return true;
    }

    public override bool Read(GH_IReader reader)
    {
        var name = "";
        if (!reader.ItemExists("File")) return true;
        reader.TryGetString("Name", ref name);
        Value = StoredText.Inflate(reader.GetByteArray("File")) is { } bytes ? GCodeDocument.FromBytes(bytes, StoredText.Unpack(name)) : null!;
        return Value is not null;
    }

    private static bool IsFile(string text)
    {
        var name = text.Trim();
        if (name.Length is 0 or > 1000 || name.IndexOfAny(Path.GetInvalidPathChars()) >= 0 || name.IndexOf('\n', 0) >= 0) return false;
        return Path.IsPathRooted(name) && File.Exists(name);
    }

    protected override string Describe(GCodeDocument value) => value.ToString();
}
