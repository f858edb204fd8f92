using System;
using System.Collections.Generic;
using Caterpillar.Geometry;

namespace Caterpillar.Examples;

/// <summary>A rectangular block on Z = 0 with a height field on top.</summary>
internal static class HeightBlock
{
    /// <summary>Width and depth in mm, centered. The height in mm is evaluated at the corners of square grid cells.</summary>
    public static TriMesh Make(double width, double depth, int columns, int rows, Func<int, int, double> height)
    {
        var points = new List<Vec3>();
        var faces = new List<int>();
        Vec3 Plan(int i, int j) => new(width * i / columns - width / 2, depth * j / rows - depth / 2);
        int Top(int i, int j) => j * (columns + 1) + i;
        for (var j = 0; j <= rows; j++)
        {
            for (var i = 0; i <= columns; i++) points.Add(Plan(i, j).WithZ(height(i, j)));
        }
        for (var j = 0; j < rows; j++)
        {
            for (var i = 0; i < columns; i++)
            {
                int a = Top(i, j), b = Top(i + 1, j), c = Top(i + 1, j + 1), d = Top(i, j + 1);
                // Diagonals alternate, so that no direction is preferred.
                faces.AddRange((i + j) % 2 == 0 ? [a, b, c, a, c, d] : [a, b, d, b, c, d]);
            }
        }
        AddSkirt(points, faces, Rim(columns, rows, Top));
        return TriMesh.Create(points, faces);
    }

    // Vertices of the top along its border, counterclockwise.
    private static List<int> Rim(int columns, int rows, Func<int, int, int> top)
    {
        var rim = new List<int>();
        for (var i = 0; i < columns; i++) rim.Add(top(i, 0));
        for (var j = 0; j < rows; j++) rim.Add(top(columns, j));
        for (var i = columns; i > 0; i--) rim.Add(top(i, rows));
        for (var j = rows; j > 0; j--) rim.Add(top(0, j));
        return rim;
    }

    private static void AddSkirt(List<Vec3> points, List<int> faces, List<int> rim)
    {
        var foot = points.Count;
        foreach (var v in rim) points.Add(points[v].WithZ(0));
        var center = points.Count;
        points.Add(Vec3.Zero);
        for (var i = 0; i < rim.Count; i++)
        {
            var j = (i + 1) % rim.Count;
            faces.AddRange([foot + i, foot + j, rim[j], foot + i, rim[j], rim[i], center, foot + j, foot + i]);
        }
    }
}
