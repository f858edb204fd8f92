namespace Caterpillar.Slicing;

/// <summary>
/// A model with its own settings for slicing and print speeds. Travels and other planning use the settings of the whole print. A modifier
/// (<see cref="ModelType.Modifier"/>) is not printed: parts inside it use its settings for walls, top/bottom surfaces, infill and speeds.
/// </summary>
public sealed record SliceModel
{
    /// <summary>A model and its own settings.</summary>
    public SliceModel(NamedMesh mesh, PrintSettings settings)
    {
        Mesh = mesh ?? throw new ArgumentNullException(nameof(mesh));
        Settings = settings ?? throw new ArgumentNullException(nameof(settings));
    }

    /// <summary>The mesh at its position on the bed, mm.</summary>
    public NamedMesh Mesh { get; }

    /// <summary>Settings of this model.</summary>
    public PrintSettings Settings { get; }
}
