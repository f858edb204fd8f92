namespace Caterpillar.GH.Goos;

/// <summary>
/// Printer, material, settings and what is printed on, as one value. Text is the name of a printer profile, or a G-code file of Caterpillar, whose setup it
/// is. A printer, a material or settings make a setup with the usual profiles for the rest.
/// </summary>
public sealed class SetupGoo : ValueGoo<PrintSetup>, IReadsText
{
    public override string TypeName => "Print Setup";

    public override string TypeDescription => "A printer, a material, print settings, and what is printed on.";

    public string? Problem { get; private set; }

    public override bool CastFrom(object source)
    {
        if (base.CastFrom(source)) return true;
        var bare = Wrapped.Bare(source);
        if (Wrapped.Text(bare) is { } file && ProfileImport.HasSetup(file))
        {
            var read = ProfileImport.ReadSetup(file);
            Problem = TextProblem.Of(read);
            Value = read.Value!;
            return Value is not null;
        }
        var printer = new PrinterGoo();
        if (Wrapped.Text(bare) is not null || bare is PrinterGoo or Printer)
        {
            if (!printer.CastFrom(source))
            {
                Problem = printer.Problem;
                return false;
            }
        }
        var material = bare as Material ?? (bare as MaterialGoo)?.Value;
        var settings = bare as PrintSettings ?? (bare as SettingsGoo)?.Value;
        if (printer.Value is null && material is null && settings is null) return false;
        var made = Profiles.Setup(printer.Value, material, settings);
        Problem = TextProblem.Of(made);
        Value = made.Value!;
        return Value is not null;
    }

    public override bool Write(GH_IWriter writer)
    {
        if (Value is null) return true;
        writer.SetInt32("Version", StoredText.Version);
        new PrinterGoo { Value = Value.Printer }.Write(writer.CreateChunk("Printer"));
        new MaterialGoo { Value = Value.Material }.Write(writer.CreateChunk("Material"));
        for (var i = 0; i < Value.ToolMaterials.Count; i++) new MaterialGoo { Value = Value.ToolMaterials[i] }.Write(writer.CreateChunk("ToolMaterial", i));
        new SettingsGoo { Value = Value.Settings }.Write(writer.CreateChunk("Settings"));
        if (Value.PrintedOn is { } mesh) writer.SetByteArray("PrintedOn", MeshBytes.Pack(mesh));
        return true;
    }

    public override bool Read(GH_IReader reader)
    {
        if (!reader.ChunkExists("Printer")) return true;
        var (printer, material, settings) = (new PrinterGoo(), new MaterialGoo(), new SettingsGoo());
        var whole = printer.Read(reader.FindChunk("Printer")) && material.Read(reader.FindChunk("Material")) && settings.Read(reader.FindChunk("Settings"));
        var others = new List<Material>();
        for (var i = 0; whole && reader.ChunkExists("ToolMaterial", i); i++)
        {
            var other = new MaterialGoo();
            whole = other.Read(reader.FindChunk("ToolMaterial", i));
            others.Add(other.Value);
        }
        if (!whole) return false;
        var printsOn = reader.ItemExists("PrintedOn");
        var mesh = printsOn ? MeshBytes.Unpack(reader.GetByteArray("PrintedOn")) : null;
        if (printsOn && mesh is null) return false;
        Value = new PrintSetup(printer.Value, material.Value, settings.Value) { PrintedOn = mesh, ToolMaterials = new(others) };
        return true;
    }

    /// <summary>Reads the setup that other goo has written into a chunk. True if there is none.</summary>
    internal bool ReadPart(GH_IReader reader) => !reader.ChunkExists("Setup") || Read(reader.FindChunk("Setup"));

    protected override string Describe(PrintSetup value)
        => $"Print Setup ({value.Printer.Title}, nozzle {N(value.Printer.NozzleDiameter)} mm; "
            + $"{string.Join(" + ", value.ToolMaterials.Prepend(value.Material).Select(m => m.Title))}; {value.Settings.Title}, layers of "
            + $"{N(value.Settings.LayerHeight)} mm, lines of {N(value.Settings.LineWidth)} mm{(value.PrintedOn is null ? "" : "; prints on an object")})";

    private static string N(double value) => NumberFormatter.Format(value, 3);
}
