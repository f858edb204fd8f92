using System;
using System.Collections.Generic;
using System.Drawing;
using Caterpillar.GH.Plugin;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Types;
using Rhino;
using Rhino.DocObjects;

namespace Caterpillar.GH.Params;

/// <summary>Data that comes from components only.</summary>
public abstract class VolatileParam<T>(string name, string nickname, string description, string panel)
    : GH_Param<T>(name, nickname, description, PluginInfo.Tab, panel, GH_ParamAccess.item)
    where T : class, IGH_Goo
{
    public override GH_Exposure Exposure => GH_Exposure.septenary | GH_Exposure.obscure;

    protected override Bitmap? Icon => Icons.Load(Icons.NameOf(GetType()));
}

/// <summary>Data that a user may also keep in the definition.</summary>
public abstract class StoredParam<T>(string name, string nickname, string description, string panel)
    : GH_PersistentParam<T>(name, nickname, description, PluginInfo.Tab, panel)
    where T : class, IGH_Goo
{
    public override GH_Exposure Exposure => GH_Exposure.septenary | GH_Exposure.obscure;

    protected override Bitmap? Icon => Icons.Load(Icons.NameOf(GetType()));

    protected override GH_GetterResult Prompt_Singular(ref T value) => GH_GetterResult.cancel;

    protected override GH_GetterResult Prompt_Plural(ref List<T> values) => GH_GetterResult.cancel;
}

/// <summary>Data with a preview that can be baked if its goo can.</summary>
public abstract class VisibleParam<T>(string name, string nickname, string description, string panel)
    : VolatileParam<T>(name, nickname, description, panel), IGH_PreviewObject, IGH_BakeAwareObject
    where T : class, IGH_Goo, IGH_PreviewData
{
    public bool Hidden { get; set; }

    public bool IsPreviewCapable => true;

    public bool IsBakeCapable => typeof(IGH_BakeAwareData).IsAssignableFrom(typeof(T)) && VolatileDataCount > 0;

    public Rg.BoundingBox ClippingBox => Hidden ? Rg.BoundingBox.Empty : Preview_ComputeClippingBox();

    public void DrawViewportWires(IGH_PreviewArgs args) => Preview_DrawWires(args);

    public void DrawViewportMeshes(IGH_PreviewArgs args) => Preview_DrawMeshes(args);

    public void BakeGeometry(RhinoDoc doc, List<Guid> obj_ids) => BakeGeometry(doc, new ObjectAttributes(), obj_ids);

    public void BakeGeometry(RhinoDoc doc, ObjectAttributes att, List<Guid> obj_ids)
    {
        foreach (var goo in m_data.AllData(true))
        {
            if (goo is IGH_BakeAwareData data && data.BakeGeometry(doc, att, out var id)) obj_ids.Add(id);
        }
    }
}
