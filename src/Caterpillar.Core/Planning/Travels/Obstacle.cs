namespace Caterpillar.Planning;

/// <summary>Puts an object into what is printed so far, so that travels stay above it.</summary>
internal static class Obstacle
{
    // Samples along the longer side.
    private const int Samples = 400;

    /// <summary>Adds the tops of an object in discs that cover it: none is lower than the object where it lies.</summary>
    public static void AddTo(Deposit deposit, TriMesh mesh)
    {
        if (mesh.TriangleCount == 0) return;
        var heights = new MeshHeights(mesh);
        var box = mesh.Bounds;
        var step = Math.Max(deposit.Cell * 2, Math.Max(box.Size.X, box.Size.Y) / Samples);
        int columns = (int)(box.Size.X / step) + 1, rows = (int)(box.Size.Y / step) + 1;
        // Heights at the corners of squares; each square takes the highest.
        var tops = new double[(columns + 1) * (rows + 1)];
        for (var i = 0; i < tops.Length; i++)
        {
            tops[i] = heights.TopUnder(
                Math.Min(box.Max.X, box.Min.X + i % (columns + 1) * step), Math.Min(box.Max.Y, box.Min.Y + i / (columns + 1) * step));
        }
        for (var row = 0; row < rows; row++)
        {
            for (var column = 0; column < columns; column++)
            {
                var at = row * (columns + 1) + column;
                double x = box.Min.X + (column + 0.5) * step, y = box.Min.Y + (row + 0.5) * step;
                var top = Math.Max(Math.Max(tops[at], tops[at + 1]), Math.Max(tops[at + columns + 1], tops[at + columns + 2]));
                top = Math.Max(top, heights.TopUnder(x, y));
                if (!double.IsInfinity(top)) deposit.Add(new Vec3(x, y, top), new Vec3(x, y, top), step * 0.7072);
            }
        }
        // Peaks between the samples.
        foreach (var p in mesh.Vertices) deposit.Add(p, p, 0);
    }
}
