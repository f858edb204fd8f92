namespace Caterpillar.Cli;

/// <summary>Reads the input meshes of verbs.</summary>
internal static class Meshes
{
    /// <summary>All meshes of all files, or none if one of them cannot be read.</summary>
    /// <param name="files">The files, in this order.</param>
    /// <param name="session">Reads files and standard input.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="sources">Gets the file of each mesh.</param>
    /// <param name="unit">Length of one unit in files that do not state theirs, mm.</param>
    public static Result<IReadOnlyList<NamedMesh>> Read(
        IReadOnlyList<string> files, Session session, IProgress<double>? progress = null, List<string>? sources = null, double unit = 1)
    {
        var meshes = new List<NamedMesh>();
        var diagnostics = new List<Diagnostic>();
        var good = true;
        for (var i = 0; i < files.Count; i++)
        {
            var bytes = session.ReadBytes(files[i]);
            var part = progress.Part((double)i / files.Count, (i + 1.0) / files.Count);
            var options = new MeshReadOptions { Memory = session.Memory, UnitLength = unit };
            var read = MeshReader.Read(bytes, Session.NameOf(files[i]), options, part, session.Cancel);
            diagnostics.AddRange(read.Diagnostics);
            if (read.Value is null)
            {
                good = false;
                continue;
            }
            meshes.AddRange(read.Value);
            for (var k = 0; k < read.Value.Count; k++) sources?.Add(files[i]);
        }
        return new Result<IReadOnlyList<NamedMesh>>(good ? meshes : null, diagnostics);
    }

    /// <summary>All meshes of a file as one.</summary>
    /// <exception cref="CliException">It cannot be read.</exception>
    public static TriMesh ReadAsOne(string file, Session session) => TriMesh.Merge(session.ValueOrFail(Read([file], session)).Select(m => m.Mesh));
}
