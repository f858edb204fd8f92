namespace Caterpillar.Geometry;

/// <summary>
/// Repairs a broken mesh to a solid, as far as possible without guessing. In this order, it removes duplicate faces, flips faces that are inside out
/// relative to their neighbors, fills holes, removes loose pieces at filled holes, and flips bodies that are inside out. A closed mesh that faces
/// outward is returned unchanged. <see cref="MeshSections"/> closes remaining gaps in contours.
/// </summary>
internal static class MeshRepair
{
    /// <summary>The mesh as a solid, and its repairs.</summary>
    /// <exception cref="OperationCanceledException">The call was canceled.</exception>
    public static RepairedMesh ToSolid(TriMesh mesh, CancellationToken cancel = default)
    {
        if (mesh is null) throw new ArgumentNullException(nameof(mesh));
        cancel.ThrowIfCancellationRequested();
        var notes = new DiagnosticList();
        var place = new SourceLocation();
        var result = mesh;
        var (moved, farthest, doubled, turned, loose) = (0, 0.0, 0, 0, 0);
        FilledHole[] holes = [];
        if (!mesh.IsWatertight || mesh.Volume < 0)
        {
            (result, moved, farthest) = EdgeSnap.Close(result);
            result = MeshCleaning.DropDuplicates(result, place, notes);
            (result, doubled) = OppositeFacets.Drop(result);
            doubled += Count(notes, "mesh.duplicate_faces");
            result = MeshOrientation.Unify(result, place, notes);
            turned = Count(notes, "mesh.flipped_faces") + (notes.Contains("mesh.inside_out", Severity.Warning) ? result.TriangleCount : 0);
            cancel.ThrowIfCancellationRequested();
            (result, var filled, loose) = HoleFiller.Fill(result, cancel);
            holes = filled.ToArray();
        }
        cancel.ThrowIfCancellationRequested();
        (result, var bodies) = BodyOrientation.Unify(result);
        return new RepairedMesh(result, moved, farthest, doubled, turned, holes, loose, bodies);
    }

    private static int Count(DiagnosticList notes, string code) => notes.ToList().Where(d => d.Code == code).Sum(d => d.Count);
}
