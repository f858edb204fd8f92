using System;
using System.Collections.Generic;
using Caterpillar.Geometry;

namespace Caterpillar.Examples;

/// <summary>A solid over a rectangle between two surfaces.</summary>
internal static class CurvedPlate
{
    private const int Columns = 40;
    private const int Rows = 32;

    public static TriMesh Make(Bounds plan, Func<double, double, double> low, Func<double, double, double> high)
    {
        var points = new List<Vec3>();
        var faces = new List<int>();
        for (var side = 0; side < 2; side++)
        {
            for (var n = 0; n < (Columns + 1) * (Rows + 1); n++)
            {
                double x = plan.Min.X + plan.Size.X * (n % (Columns + 1)) / Columns, y = plan.Min.Y + plan.Size.Y * (n / (Columns + 1)) / Rows;
                points.Add(new Vec3(x, y, side == 0 ? low(x, y) : high(x, y)));
            }
        }
        int At(int side, int i, int j) => (side * (Rows + 1) + j) * (Columns + 1) + i;
        void Quad(int a, int b, int c, int d) => faces.AddRange([a, b, c, a, c, d]);
        for (var j = 0; j < Rows; j++)
        {
            for (var i = 0; i < Columns; i++)
            {
                Quad(At(0, i, j), At(0, i, j + 1), At(0, i + 1, j + 1), At(0, i + 1, j));
                Quad(At(1, i, j), At(1, i + 1, j), At(1, i + 1, j + 1), At(1, i, j + 1));
            }
        }
        for (var i = 0; i < Columns; i++)
        {
            Quad(At(0, i, 0), At(0, i + 1, 0), At(1, i + 1, 0), At(1, i, 0));
            Quad(At(0, i + 1, Rows), At(0, i, Rows), At(1, i, Rows), At(1, i + 1, Rows));
        }
        for (var j = 0; j < Rows; j++)
        {
            Quad(At(0, 0, j + 1), At(0, 0, j), At(1, 0, j), At(1, 0, j + 1));
            Quad(At(0, Columns, j), At(0, Columns, j + 1), At(1, Columns, j + 1), At(1, Columns, j));
        }
        return TriMesh.Create(points, faces);
    }
}
