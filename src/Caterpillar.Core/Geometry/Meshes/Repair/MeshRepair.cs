using Caterpillar.Basics;

namespace Caterpillar.Geometry;

/// <summary>
/// Makes a solid of a broken mesh, as far as that can be done without guessing. In this order: doubled triangles are taken once, triangles that are
/// turned against their neighbors are turned back, holes are filled, pieces that have come off where a hole was filled are left out, bodies that are
/// inside out are turned. A closed mesh that faces outward is returned as it is. What is still open afterwards is left to <see cref="MeshSections"/>,
/// which close contours over gaps.
/// </summary>
internal static class MeshRepair
{
    /// <summary>The mesh as a solid, and what was done to it.</summary>
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
            turned = Count(notes, "mesh.faces_turned") + (notes.Contains("mesh.inside_out", Severity.Warning) ? result.TriangleCount : 0);
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
