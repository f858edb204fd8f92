using System;
using System.Collections.Generic;
using Caterpillar.Geometry;
using Caterpillar.Tests.Geometry.Meshes;

namespace Caterpillar.Examples;

/// <summary>The models in examples/models, in mm. All are watertight, on Z = 0 and centered on X = Y = 0.</summary>
internal static class ExampleModels
{
    /// <summary>File names and generators of the models.</summary>
    public static IReadOnlyList<(string Name, Func<TriMesh> Make)> All { get; } =
    [
        ("vase.stl", Vase.Make),
        ("bracket.stl", Bracket.Make),
        ("saddle_roof.stl", SaddleRoof.Make),
        ("terrain.stl", Terrain.Make),
        ("branching.stl", Branching.Make),
    ];

    /// <summary>The model as binary STL, with the same bytes on every system.</summary>
    public static byte[] ToStl(string name, TriMesh mesh) => StlWriter.ToBytes(mesh, "Caterpillar example " + name);
}
