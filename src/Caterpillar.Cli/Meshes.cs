using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Cli;

/// <summary>Reads the meshes that verbs are given.</summary>
internal static class Meshes
{
    /// <summary>All meshes of all files; what was noticed is printed.</summary>
    /// <exception cref="CliException">A file holds none.</exception>
    public static IReadOnlyList<NamedMesh> Read(IReadOnlyList<string> files, Session session, IProgress<double>? progress = null)
    {
        var meshes = new List<NamedMesh>();
        for (var i = 0; i < files.Count; i++)
        {
            var bytes = session.ReadBytes(files[i]);
            meshes.AddRange(session.Need(MeshReader.Read(bytes, Session.NameOf(files[i]), progress.Part((double)i / files.Count, (i + 1.0) / files.Count), session.Cancel)));
        }
        return meshes;
    }
}
