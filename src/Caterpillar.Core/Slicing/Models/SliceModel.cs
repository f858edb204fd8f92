using System;
using Caterpillar.Geometry;
using Caterpillar.Machines;

namespace Caterpillar.Slicing;

/// <summary>A model and how it is sliced. Speeds and everything else that planning decides come from the settings of the whole print.</summary>
public sealed record SliceModel
{
    public SliceModel(NamedMesh mesh, PrintSettings settings)
    {
        Mesh = mesh ?? throw new ArgumentNullException(nameof(mesh));
        Settings = settings ?? throw new ArgumentNullException(nameof(settings));
    }

    public NamedMesh Mesh { get; }

    public PrintSettings Settings { get; }
}
