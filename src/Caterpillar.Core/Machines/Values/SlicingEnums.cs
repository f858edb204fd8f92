namespace Caterpillar.Machines;

/// <summary>Where in its thickness a layer cuts the model.</summary>
public enum SlicingPlane : byte
{
    /// <summary>In the middle: the volume of slopes is right.</summary>
    Middle,

    /// <summary>Just above its bottom: what is printed covers the section there.</summary>
    Bottom,
}

/// <summary>On which side of the outlines a brim lies.</summary>
public enum BrimType : byte
{
    /// <summary>Around the part.</summary>
    OuterOnly,

    /// <summary>In its holes.</summary>
    InnerOnly,

    /// <summary>Both.</summary>
    OuterAndInner,
}

/// <summary>What becomes of contours that do not close.</summary>
public enum OpenContours : byte
{
    /// <summary>They are left out.</summary>
    Ignore,

    /// <summary>They are printed as single walls.</summary>
    Walls,
}

/// <summary>What the machine does where a layer is too quick to cool.</summary>
public enum LayerTimeWait : byte
{
    /// <summary>It goes on.</summary>
    None,

    /// <summary>It waits above the layer, the filament retracted.</summary>
    Above,

    /// <summary>It waits beside the part.</summary>
    NextTo,
}
