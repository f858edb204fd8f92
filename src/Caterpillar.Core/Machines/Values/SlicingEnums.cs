namespace Caterpillar.Machines;

/// <summary>Where in its thickness a layer cuts the model.</summary>
public enum LayerCut : byte
{
    /// <summary>In the middle: the volume of slopes is right.</summary>
    Middle,

    /// <summary>Just above its bottom: what is printed covers the section there.</summary>
    Bottom,
}

/// <summary>On which side of the outlines a brim lies.</summary>
public enum BrimSide : byte
{
    /// <summary>Around the part.</summary>
    Outside,

    /// <summary>In its holes.</summary>
    Inside,

    Both,
}

/// <summary>What becomes of contours that do not close.</summary>
public enum OpenMeshes : byte
{
    /// <summary>They are left out.</summary>
    Ignore,

    /// <summary>They are printed as single walls.</summary>
    Walls,
}

/// <summary>What the machine does where a layer is too quick to cool.</summary>
public enum LayerWait : byte
{
    /// <summary>It goes on.</summary>
    None,

    /// <summary>It waits above the layer, the filament retracted.</summary>
    Pause,

    /// <summary>It waits beside the part.</summary>
    Away,
}
