using System;
using System.Collections.Generic;
using Caterpillar.Geometry;
using Caterpillar.Tests.Geometry.Meshes;

namespace Caterpillar.Examples;

/// <summary>The models in examples/models. All stand on Z = 0, are centered on X = Y = 0 and are watertight; mm.</summary>
internal static class ExampleModels
{
    /// <summary>File names, and the generator of each model.</summary>
    public static IReadOnlyList<(string Name, Func<TriMesh> Make)> All { get; } =
    [
        ("vase.stl", Vase.Make),
        ("bracket.stl", Bracket.Make),
        ("saddle_roof.stl", SaddleRoof.Make),
        ("terrain.stl", Terrain.Make),
        ("branching.stl", Branching.Make),
    ];

    /// <summary>The file: binary STL, the same bytes on every system.</summary>
    public static byte[] ToStl(string name, TriMesh mesh) => StlWriter.ToBytes(mesh, "Caterpillar example " + name);
}
