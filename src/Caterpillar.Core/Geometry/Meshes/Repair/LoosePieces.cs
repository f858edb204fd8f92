using System;
using System.Collections.Generic;

namespace Caterpillar.Geometry;

/// <summary>
/// Finds open pieces that lie at a hole which was filled: triangles that have come off, whose place the filling takes. A piece belongs to a hole where it
/// is not larger than the filling and its box is inside the box of the hole, grown by half of its diagonal.
/// </summary>
internal static class LoosePieces
{
    private const int Bins = 1024;

    // The filling is the smallest there is: what was in its place may be a little larger.
    private const double MaxShare = 1.25;

    /// <summary>True for the pieces that are left out; those that were mended stay.</summary>
    public static bool[] Find(TriMesh mesh, MeshPieces pieces, bool[] mended, IReadOnlyList<FilledHole> holes)
    {
        var boxes = new Bounds[pieces.Count];
        for (var h = 0; h < mesh.RawTriangles.Length; h++) boxes[pieces.Of[h / 3]] = boxes[pieces.Of[h / 3]].Include(mesh.RawVertices[mesh.RawTriangles[h]]);
        var places = ByHeight(holes, mesh.Bounds);
        var loose = new bool[pieces.Count];
        for (var piece = 0; piece < loose.Length; piece++)
        {
            if (pieces.IsClosed[piece] || mended[piece]) continue;
            foreach (var place in places[Bin(boxes[piece].Min.Z, mesh.Bounds)])
                loose[piece] |= pieces.Area[piece] <= MaxShare * place.Area && place.Box.Contains(boxes[piece]);
        }
        return loose;
    }

    private static List<FilledHole>[] ByHeight(IReadOnlyList<FilledHole> holes, Bounds all)
    {
        var bins = new List<FilledHole>[Bins];
        for (var i = 0; i < Bins; i++) bins[i] = [];
        foreach (var hole in holes)
        {
            var box = hole.Box.Grow(hole.Width / 2);
            for (var bin = Bin(box.Min.Z, all); bin <= Bin(box.Max.Z, all); bin++) bins[bin].Add(new FilledHole(box, hole.Area));
        }
        return bins;
    }

    private static int Bin(double z, Bounds all) => (int)Math.Max(0, Math.Min(Bins - 1, (z - all.Min.Z) / Math.Max(all.Size.Z, 1e-9) * Bins));
}
