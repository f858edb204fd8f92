namespace Caterpillar.Machines;

/// <summary>Types of supports.</summary>
public enum SupportKind : byte
{
    None,

    /// <summary>Columns of parallel lines with a wall around them.</summary>
    Grid,

    /// <summary>Tree supports: inclined branches that merge toward the bottom.</summary>
    Tree,
}

/// <summary>Where supports may start.</summary>
public enum SupportPlacement : byte
{
    /// <summary>On the build plate and on the part.</summary>
    Everywhere,

    /// <summary>On the build plate only.</summary>
    BuildPlate,
}

/// <summary>Type of a model.</summary>
public enum ModelType : byte
{
    /// <summary>A part to print.</summary>
    Part,

    /// <summary>No supports inside it. It is not printed itself.</summary>
    SupportBlocker,

    /// <summary>Supports below every downward surface inside it. It is not printed itself.</summary>
    SupportEnforcer,

    /// <summary>Parts inside it are printed with its settings. It is not printed itself.</summary>
    Modifier,
}
