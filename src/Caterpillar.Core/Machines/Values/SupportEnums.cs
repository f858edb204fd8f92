namespace Caterpillar.Machines;

/// <summary>Kinds of supports.</summary>
public enum SupportKind : byte
{
    None,

    /// <summary>Columns of parallel lines with a wall around them.</summary>
    Grid,

    /// <summary>Branches that lean, and join further down.</summary>
    Tree,
}

/// <summary>What supports may stand on.</summary>
public enum SupportPlacement : byte
{
    /// <summary>The bed and the part.</summary>
    Everywhere,

    /// <summary>The bed only.</summary>
    BuildPlate,
}

/// <summary>What a model is for.</summary>
public enum ModelType : byte
{
    /// <summary>It is printed.</summary>
    Part,

    /// <summary>Inside it nothing is supported; it is not printed itself.</summary>
    SupportBlocker,

    /// <summary>Inside it every surface seen from below is supported; it is not printed itself.</summary>
    SupportEnforcer,

    /// <summary>What of the parts lies inside it is printed with its settings; it is not printed itself.</summary>
    Modifier,
}
