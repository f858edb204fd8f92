namespace Caterpillar.Display;

/// <summary>Nozzle and print head of a printer as closed meshes.</summary>
public static class HeadMesh
{
    private const int Corners = 24;

    /// <summary>
    /// The outline of the head around its axis and its boxes, mm, with the nozzle tip at the origin. Normals point outward. Parts without height are left out.
    /// </summary>
    public static TriMesh Of(Printer printer)
    {
        if (printer is null) throw new ArgumentNullException(nameof(printer));
        var points = new List<Vec3>();
        var triangles = new List<int>();
        var outline = printer.HeadOutline;
        if (outline.Count > 1)
        {
            // From the middle of the tip over the rings to the middle of the top.
            points.Add(new Vec3(0, 0, outline[0].Height));
            foreach (var ring in outline) AddRing(points, ring);
            points.Add(new Vec3(0, 0, outline[outline.Count - 1].Height));
            for (var k = 0; k < Corners; k++)
            {
                int here = 1 + k, next = 1 + (k + 1) % Corners;
                triangles.AddRange([0, next, here]);
                for (var i = 1; i < outline.Count; i++, here += Corners, next += Corners)
                    triangles.AddRange([here, next, next + Corners, here, next + Corners, here + Corners]);
                triangles.AddRange([here, next, points.Count - 1]);
            }
        }
        return TriMesh.Merge([TriMesh.Create(points, triangles), .. printer.HeadBoxes.Select(TriMesh.Box)]);
    }

    private static void AddRing(List<Vec3> points, HeadPoint ring)
    {
        for (var k = 0; k < Corners; k++)
        {
            var (sin, cos) = Angle.SinCos(360.0 * k / Corners);
            points.Add(new Vec3(ring.Radius * cos, ring.Radius * sin, ring.Height));
        }
    }
}
