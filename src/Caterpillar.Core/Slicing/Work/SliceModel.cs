using Caterpillar.Geometry;
using Caterpillar.Machines;

namespace Caterpillar.Slicing;

/// <summary>
/// A model and how it is sliced, with the speeds of its extrusions. Travels and everything else that planning decides come from the settings of the whole
/// print. A modifier (<see cref="ModelType.Modifier"/>) is not printed: what of the parts lies inside it has its settings for walls, skins, infill and speeds.
/// </summary>
public sealed record SliceModel
{
    /// <summary>A model and its own settings.</summary>
    public SliceModel(NamedMesh mesh, PrintSettings settings)
    {
        Mesh = mesh ?? throw new ArgumentNullException(nameof(mesh));
        Settings = settings ?? throw new ArgumentNullException(nameof(settings));
    }

    /// <summary>Its place on the bed, mm.</summary>
    public NamedMesh Mesh { get; }

    /// <summary>Its own settings.</summary>
    public PrintSettings Settings { get; }
}
