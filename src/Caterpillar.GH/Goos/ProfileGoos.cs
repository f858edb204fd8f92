namespace Caterpillar.GH.Goos;

/// <summary>A printer on a wire. At a port for printers, text is the name of a profile.</summary>
public sealed class PrinterGoo : ProfileGoo<Printer>
{
    public override string TypeName => "Printer";

    public override string TypeDescription => "A printer: build volume in mm, limits and G-code.";

    protected override string Describe(Printer value)
        => $"Printer ({value.Title}, {NumberFormatter.Format(value.BuildVolume.X, 1)} × {NumberFormatter.Format(value.BuildVolume.Y, 1)} × "
            + $"{NumberFormatter.Format(value.BuildVolume.Z, 1)} mm, {value.Flavor.Title})";
}

/// <summary>A material on a wire. At a port for materials, text is the name of a profile.</summary>
public sealed class MaterialGoo : ProfileGoo<Material>
{
    public override string TypeName => "Material";

    public override string TypeDescription => "A material: temperatures in °C, filament diameter in mm, flow ratio.";

    protected override string Describe(Material value)
        => $"Material ({value.Title}, {NumberFormatter.Format(value.FilamentDiameter, 3)} mm, {NumberFormatter.Format(value.NozzleTemperature, 1)} °C)";
}

/// <summary>Print settings on a wire. At a port for settings, text is the name of a profile.</summary>
public sealed class SettingsGoo : ProfileGoo<PrintSettings>
{
    public override string TypeName => "Print Settings";

    public override string TypeDescription => "Print settings: heights and widths in mm, speeds in mm/s.";

    protected override string Describe(PrintSettings value)
        => $"Print Settings ({value.Title}, layers of {NumberFormatter.Format(value.LayerHeight, 3)} mm, lines of "
            + $"{NumberFormatter.Format(value.LineWidth, 3)} mm, {NumberFormatter.Format(value.PrintSpeed, 1)} mm/s)";
}

/// <summary>
/// Base of printers, materials and settings: a name, and the JSON that a definition stores. Text may also be a G-code file of Caterpillar, which has them all.
/// </summary>
public abstract class ProfileGoo<T> : ValueGoo<T>, IReadsText
    where T : class
{
    public string? Problem { get; private set; }

    public override bool CastFrom(object source)
    {
        if (base.CastFrom(source)) return true;
        if (Wrapped.Text(source) is not { } name) return false;
        var found = ProfileImport.HasSetup(name) ? Profiles.OfFile<T>(name) : Profiles.Library.Find<T>(name);
        Problem = TextProblem.Of(found);
        Value = found.Value!;
        return Value is not null;
    }

    public override bool Write(GH_IWriter writer)
    {
        if (Value is null) return true;
        writer.SetInt32("Version", StoredText.Version);
        writer.SetString("Name", StoredText.Pack(Profiles.NameOf(Value)));
        writer.SetString("Profile", StoredText.Pack(ProfileWriter.Write(Value)));
        return true;
    }

    public override bool Read(GH_IReader reader)
    {
        string name = "", json = "";
        if (!reader.TryGetString("Profile", ref json)) return true;
        reader.TryGetString("Name", ref name);
        Value = ProfileReader.Read<T>(StoredText.Unpack(json), "definition", StoredText.Unpack(name)).Value!;
        return Value is not null;
    }
}
