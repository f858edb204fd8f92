using Rhino.DocObjects;
using Rhino.UI;

namespace Caterpillar.GH.Bake;

/// <summary>
/// Adds objects to a document of Rhino, with the bead width as plot weight and with facts as user text. Where attributes were chosen, their layer, color and
/// name are obeyed. Otherwise objects are on layers by object and role, in the color of the role. Escape takes everything back.
/// </summary>
internal sealed class Baker(RhinoDoc document, ObjectAttributes? chosen)
{
    /// <summary>With more objects than this, each item is one block.</summary>
    public const int MostObjects = 10_000;

    private const int ProgressStep = 256;
    private readonly DocumentUnits _units = DocumentUnits.Of(document);
    private int _done;

    /// <summary>Name of the objects and of their group. Empty = none.</summary>
    public string Name { get; init; } = "";

    /// <summary>Full path of a layer for all objects. Null = layers by object and role.</summary>
    public string? Layer { get; init; }

    /// <summary>Color of all objects. Null = by role.</summary>
    public Color? Color { get; init; }

    public BakeOwner? Owner { get; init; }

    /// <summary>What the user must know: that there are blocks, or that Escape was pressed. Null if nothing.</summary>
    public string? Note { get; private set; }

    /// <summary>Bakes what Grasshopper asks for. No objects if the user presses Escape.</summary>
    public List<Guid> Add(IEnumerable<IBakes> items)
    {
        var parts = items.SelectMany(i => i.ToParts(_units)).ToList();
        var ids = Add([("", parts)])?.Single() ?? [];
        if (Note is not null) RhinoApp.WriteLine(Note);
        return ids;
    }

    /// <summary>Adds items and returns the ids of the objects of each. Null, and no objects, if the user presses Escape.</summary>
    public List<List<Guid>>? Add(IReadOnlyList<(string Item, List<BakedPart> Parts)> items)
    {
        var all = new List<List<Guid>>();
        var total = items.Sum(i => i.Parts.Count);
        var asBlocks = total > MostObjects;
        var redraws = document.Views.RedrawEnabled;
        document.Views.RedrawEnabled = false;
        StatusBar.ShowProgressMeter(0, total, "Baking", true, true);
        try
        {
            foreach (var (item, parts) in items)
            {
                var ids = new List<Guid>();
                all.Add(ids);
                if (!asBlocks) AddEach(parts, item, ids);
                else if (parts.Count > 0) ids.Add(AddBlock(parts, item));
            }
            if (asBlocks) Note = $"{NumberFormatter.Format(total)} objects are baked as {(all.Count > 1 ? "blocks" : "a block")}. Explode it to edit them.";
            return all;
        }
        catch (OperationCanceledException)
        {
            foreach (var ids in all) Delete(document, ids);
            Note = "Canceled: nothing was baked.";
            return null;
        }
        finally
        {
            StatusBar.HideProgressMeter();
            document.Views.RedrawEnabled = redraws;
            document.Views.Redraw();
        }
    }

    /// <summary>Deletes objects, and the definitions of blocks among them.</summary>
    public static void Delete(RhinoDoc document, IEnumerable<Guid> ids)
    {
        foreach (var id in ids)
        {
            var block = (document.Objects.FindId(id) as InstanceObject)?.InstanceDefinition;
            document.Objects.Delete(id, true);
            if (block is not null) document.InstanceDefinitions.Delete(block.Index, true, true);
        }
    }

    private void AddEach(List<BakedPart> parts, string item, List<Guid> ids)
    {
        foreach (var part in parts)
        {
            Progress();
            var attributes = Attributes(part);
            Own(attributes, item);
            var id = part.Geometry is Rg.Mesh mesh ? document.Objects.AddMesh(mesh, attributes)
                : document.Objects.AddCurve((Rg.Curve)part.Geometry, attributes);
            if (id != Guid.Empty) ids.Add(id);
        }
    }

    private Guid AddBlock(List<BakedPart> parts, string item)
    {
        var attributes = new List<ObjectAttributes>(parts.Count);
        foreach (var part in parts)
        {
            Progress();
            attributes.Add(Attributes(part));
        }
        var name = document.InstanceDefinitions.GetUnusedInstanceDefinitionName(Name.Length > 0 ? Name : BakeLayers.Root);
        var block = document.InstanceDefinitions.Add(name, "", Rg.Point3d.Origin, parts.Select(p => p.Geometry), attributes);
        var one = chosen?.Duplicate() ?? document.CreateDefaultAttributes();
        if (Name.Length > 0) one.Name = Name;
        if (Layer is not null) one.LayerIndex = BakeLayers.Find(document, Layer, System.Drawing.Color.Black);
        Own(one, item);
        return document.Objects.AddInstanceObject(block, Rg.Transform.Identity, one);
    }

    private ObjectAttributes Attributes(BakedPart part)
    {
        var attributes = chosen?.Duplicate() ?? document.CreateDefaultAttributes();
        if (chosen is null)
        {
            var color = Color ?? RhinoGeometry.ToColor(Palette.Of(part.Role));
            var (of, role) = part.Place;
            attributes.LayerIndex = BakeLayers.Find(document, Layer ?? BakeLayers.PathOf(of, role), color);
            attributes.ObjectColor = color;
            attributes.ColorSource = ObjectColorSource.ColorFromObject;
        }
        if (Name.Length > 0) attributes.Name = Name;
        else if (string.IsNullOrEmpty(attributes.Name)) attributes.Name = part.Name;
        if (part.Bead?.Width(Toolpaths.BeadShape.Stadium) is > 0 and var width)
        {
            attributes.PlotWeight = width;
            attributes.PlotWeightSource = ObjectPlotWeightSource.PlotWeightFromObject;
        }
        part.Write(attributes);
        return attributes;
    }

    private void Own(ObjectAttributes attributes, string item)
    {
        Owner?.Write(attributes, item);
        if (Name.Length == 0) return;
        var group = document.Groups.Find(Name);
        attributes.AddToGroup(group < 0 ? document.Groups.Add(Name) : group);
    }

    private void Progress()
    {
        if (_done % ProgressStep == 0)
        {
            if (GH_Document.IsEscapeKeyDown()) throw new OperationCanceledException();
            StatusBar.UpdateProgressMeter(_done, true);
        }
        _done++;
    }
}
