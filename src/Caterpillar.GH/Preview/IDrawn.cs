namespace Caterpillar.GH.Preview;

/// <summary>Something that a component draws itself for an item.</summary>
internal interface IDrawn
{
    /// <summary>Its bounds, in document units.</summary>
    Rg.BoundingBox Box { get; }

    void DrawWires(IGH_PreviewArgs args, bool selected);

    void DrawMeshes(IGH_PreviewArgs args, bool selected);
}
