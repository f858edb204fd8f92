namespace Caterpillar.GH.Goos;

/// <summary>
/// A toolpath on a wire. Native Move, Orient and Scale work on it. Its preview is one thin wire along the extrusions. As a curve it is the path of the
/// print head through all moves, as a mesh the extrusions.
/// </summary>
public sealed class ToolpathGoo : DrawnGoo<Toolpath>
{
    private Func<Toolpath>? _make;

    public ToolpathGoo()
    {
    }

    /// <summary>A toolpath, and the setup that it was planned for.</summary>
    public ToolpathGoo(Toolpath? toolpath, PrintSetup? setup = null)
    {
        Value = toolpath!;
        Setup = setup;
    }

    /// <summary>A toolpath that was decoded from a file, for a setup if that is known.</summary>
    public ToolpathGoo(DecodedGCode decoding, PrintSetup? setup = null)
        : this(decoding?.Toolpath, setup)
    {
        DecodedGCode = decoding;
    }

    private ToolpathGoo(ToolpathGoo other, Toolpath? toolpath, PrintSetup? setup = null)
        : this(toolpath, setup ?? other.Setup)
    {
        DecodedGCode = other.DecodedGCode;
    }

    /// <summary>The toolpath, made when it is first used.</summary>
    public override Toolpath Value
    {
        get => m_value ??= _make?.Invoke()!;
        set => m_value = value;
    }

    /// <summary>The setup it was planned for, if known.</summary>
    public PrintSetup? Setup { get; private set; }

    /// <summary>The setup with which no check found an error. Null if it was not checked.</summary>
    public PrintSetup? CheckedWith { get; private set; }

    /// <summary>The file that it was decoded from, if any. When it is written again, unedited lines stay byte for byte.</summary>
    public DecodedGCode? DecodedGCode { get; private set; }

    public override string TypeName => "Toolpath";

    public override string TypeDescription => "All moves of the printer: positions in mm, speeds in mm/s.";

    public override IGH_GeometricGoo DuplicateGeometry() => new ToolpathGoo(this, Value) { CheckedWith = CheckedWith };

    /// <summary>The same, checked with a setup without an error.</summary>
    public ToolpathGoo Checked(PrintSetup setup) => new(this, Value, setup) { CheckedWith = setup };

    /// <summary>All moves before one, and a part of that move. Made when it is first used.</summary>
    public ToolpathGoo Until(int move, Vec3 position, double done)
    {
        var whole = Value;
        return new ToolpathGoo(this, null) { _make = () => whole.Until(move, position, done) };
    }

    /// <summary>Moves of a file that were not edited are read from the file again.</summary>
    public override bool Write(GH_IWriter writer)
    {
        if (Value is null) return true;
        var file = DecodedGCode?.Document is null ? null : DecodedGCode;
        if (file is not null)
        {
            new GCodeGoo { Value = file.Document! }.Write(writer);
            writer.SetString("Flavor", file.Flavor.Name);
            writer.SetInt32("Rule", (int)file.Rule);
        }
        if (!ReferenceEquals(file?.Toolpath, Value)) writer.SetByteArray("Moves", ToolpathBytes.Pack(Value));
        if (Setup is not null) new SetupGoo { Value = Setup }.Write(writer.CreateChunk("Setup"));
        return true;
    }

    public override bool Read(GH_IReader reader)
    {
        var (file, setup) = (new GCodeGoo(), new SetupGoo());
        if (!file.Read(reader) || !setup.ReadPart(reader)) return false;
        Setup = setup.Value;
        if (file.Value is { } document)
        {
            var options = new DecodeOptions { Flavor = FlavorTable.Find(reader.GetString("Flavor")), Rule = (ExtrusionRule)reader.GetInt32("Rule") };
            DecodedGCode = GCodeDecoder.Decode(document, options).Value;
            Value = DecodedGCode?.Toolpath!;
        }
        if (!reader.ItemExists("Moves")) return true;
        Value = ToolpathBytes.Unpack(reader.GetByteArray("Moves"))!;
        return Value is not null;
    }

    /// <summary>An edit of it.</summary>
    public ToolpathGoo With(Toolpath edited) => new(this, edited);

    /// <summary>Deforms the layers. Start and end G-code stay.</summary>
    public override IGH_GeometricGoo? Morph(Rg.SpaceMorph xmorph)
    {
        if (Value is null) return null;
        var units = DocumentUnits.Current;
        var morph = Deformation.Cartesian(p => RhinoGeometry.ToVec(xmorph.MorphPoint(RhinoGeometry.ToPoint(p, units)), units));
        return Value.Deform(new MoveFilter().InLayersOf(Value), morph).Value is { } morphed ? With(morphed) : null;
    }

    public override string ToString() => Value is null
        ? "No Toolpath"
        : $"Toolpath ({NumberFormatter.Format(Value.Count)} moves, {NumberFormatter.Format(Value.CountLayers())} layers, "
            + $"{NumberFormatter.Format(ToolpathTotals.Of(Value).PrintLength / 1000, 2)} m printed)";

    private protected override Bounds Bounds => ToolpathTotals.Of(Value).PrintBounds;

    private protected override int SegmentCount => Value.Count;

    private protected override int LayerCount => Value.Layers.Count;

    private protected override object? Native(Type wanted, DocumentUnits units) => NativeCasts.Of(Value, wanted, units);

    private protected override IEnumerable<BakedPart> ToParts(DocumentUnits units) => BakedPart.Of(Value, beads: false, units);

    private protected override void AddWires(List<Rg.Line> lines, DocumentUnits units, Thinning thinning, int first)
    {
        foreach (var move in Value.Moves())
        {
            if (move.Kind == MoveKind.Print && thinning.Has(move.Layer, first + move.Index))
                RhinoGeometry.AddLines(lines, move.Start, move.End, move.Arc, units);
        }
    }

    private protected override IGH_GeometricGoo Image(Affine map) => With(Value.Transform(map));
}
