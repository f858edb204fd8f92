using Rhino.DocObjects;

namespace Caterpillar.GH.Params;

/// <summary>Data with a preview: all of it in one call of the display, and one box, both kept until the data or the units change.</summary>
public abstract class VisibleParam<T>(string name, string nickname, string description, string panel)
    : StoredParam<T>(name, nickname, description, panel), IGH_PreviewObject, IGH_BakeAwareObject, IThinned
    where T : class, IGH_Goo, IGH_PreviewData
{
    private const string HiddenKey = "PreviewHidden";
    private WireSet? _wires;
    private int _count;

    public bool Hidden { get; set; }

    public bool IsPreviewCapable => true;

    public bool IsBakeCapable => VolatileDataCount > 0;

    public Rg.BoundingBox ClippingBox => Hidden ? Rg.BoundingBox.Empty : Wires.Box;

    string? IThinned.Note => Wires.Thinning.Note;

    private WireSet Wires
    {
        get
        {
            var units = DocumentUnits.Current;
            var count = VolatileDataCount;
            if (_wires is not null && _count == count && _wires.Fits(units)) return _wires;
            _count = count;
            return _wires = new WireSet(m_data.AllData(true).OfType<IWires>().ToArray(), units);
        }
    }

    public override void ClearData()
    {
        _wires = null;
        base.ClearData();
    }

    /// <summary>Ports of components leave it to them.</summary>
    protected override void OnVolatileDataCollected()
    {
        base.OnVolatileDataCollected();
        if (Kind == GH_ParamKind.floating && !Hidden && Wires.Thinning.Note is { } note) AddRuntimeMessage(GH_RuntimeMessageLevel.Remark, note);
    }

    public void DrawViewportWires(IGH_PreviewArgs args)
    {
        if (!Hidden) Wires.Draw(args.Display, Attributes?.GetTopLevel?.Selected == true ? args.WireColour_Selected : args.WireColour);
    }

    public void DrawViewportMeshes(IGH_PreviewArgs args)
    {
    }

    public void BakeGeometry(RhinoDoc doc, List<Guid> obj_ids) => BakeGeometry(doc, null!, obj_ids);

    public void BakeGeometry(RhinoDoc doc, ObjectAttributes att, List<Guid> obj_ids)
    {
        if (doc is not null && obj_ids is not null) obj_ids.AddRange(new Baker(doc, att).Add(m_data.AllData(true).OfType<IBakes>()));
    }

    public override bool Write(GH_IWriter writer)
    {
        writer.SetBoolean(HiddenKey, Hidden);
        return base.Write(writer);
    }

    public override bool Read(GH_IReader reader)
    {
        var hidden = Hidden;
        if (reader.TryGetBoolean(HiddenKey, ref hidden)) Hidden = hidden;
        return base.Read(reader);
    }
}
