namespace Caterpillar.GH.Goos;

/// <summary>A field of layers on a wire. Layers copy a mesh, surface or Brep. Text is the formula of a field.</summary>
public sealed class LayerFieldGoo : ValueGoo<FieldRecipe>, IReadsText
{
    // Deviation of the facets of a curved surface, mm.
    private const double Tolerance = 0.05;

    private string? _formula;

    public override string TypeName => "Layer Field";

    public override string TypeDescription => "A field whose level sets are the layers of a print, in mm.";

    public string? Problem { get; private set; }

    public override bool CastFrom(object source)
    {
        if (base.CastFrom(source)) return true;
        if (Wrapped.Text(source) is { } text) return FromFormula(text);
        return Wrapped.Bare(source) switch
        {
            IGH_GeometricGoo goo => FromGeometry(Wrapped.Bare(goo.ScriptVariable())),
            Rg.GeometryBase geometry => FromGeometry(geometry),
            _ => false,
        };
    }

    /// <summary>A definition stores formulas.</summary>
    public override bool Write(GH_IWriter writer)
    {
        if (_formula is not null) writer.SetString("Formula", StoredText.Pack(_formula));
        return true;
    }

    public override bool Read(GH_IReader reader)
    {
        var formula = "";
        return !reader.TryGetString("Formula", ref formula) || FromFormula(StoredText.Unpack(formula));
    }

    protected override string Describe(FieldRecipe value) => $"Layer Field ({value})";

    private bool FromFormula(string text)
    {
        var read = LayerField.Formula(text);
        Problem = TextProblem.Of(read);
        if (read.Value is not { } field) return false;
        Value = new FieldRecipe("Formula " + text.Trim(), [], field);
        _formula = text;
        return true;
    }

    private bool FromGeometry(object? geometry)
    {
        if (geometry is null) return false;
        try
        {
            var units = DocumentUnits.Current;
            var mesh = RhinoMesh.ToTriangles(RhinoMesh.ToMesh(geometry, Tolerance, units), units);
            Value = new FieldRecipe("Vertical", [.. ModelMesh.Content(geometry), units.ToMillimeters], LayerField.Vertical(PlanSurface.Of(mesh)));
            return true;
        }
        catch (InputProblem)
        {
            return false;
        }
    }
}
