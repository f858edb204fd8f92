namespace Caterpillar.Machines;

/// <summary>Height at which a layer cuts the model.</summary>
public enum SlicingPlane : byte
{
    /// <summary>Middle of the layer: slopes keep their volume.</summary>
    Middle,

    /// <summary>Just above the bottom of the layer: the print covers the section at that height.</summary>
    Bottom,
}

/// <summary>Type of brim.</summary>
public enum BrimType : byte
{
    /// <summary>Around the part.</summary>
    OuterOnly,

    /// <summary>Inside its holes.</summary>
    InnerOnly,

    /// <summary>Both.</summary>
    OuterAndInner,

    /// <summary>Only at sharp corners: disks with the brim width as their radius.</summary>
    Ears,
}

/// <summary>Handling of contours that do not close.</summary>
public enum OpenContours : byte
{
    /// <summary>Ignored.</summary>
    Ignore,

    /// <summary>Printed as single walls.</summary>
    Walls,

    /// <summary>All contours, closed ones too, are single walls on the surface of the mesh.</summary>
    Surface,
}

/// <summary>What the printer does if a layer takes too little time to cool.</summary>
public enum LayerTimeWait : byte
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>Wait above the layer, with the filament retracted.</summary>
    Above,

    /// <summary>Wait next to the part.</summary>
    NextTo,
}
