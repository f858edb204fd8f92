using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Examples;

/// <summary>
/// A solid of boxes between grid lines, with round holes and ribs. Neighboring faces share their corners, so the surface is always watertight.
/// </summary>
internal sealed class BlockSolid(double[] xs, double[] ys, double[] zs)
{
    private const int HoleCorners = 48;

    private readonly bool[,,] _full = new bool[xs.Length - 1, ys.Length - 1, zs.Length - 1];
    private readonly bool[,,] _rib = new bool[xs.Length - 1, ys.Length - 1, zs.Length - 1];

    // Radius of a hole through the cell along an axis (0 = X, 2 = Z); 0 = no hole.
    private readonly double[,,,] _hole = new double[xs.Length - 1, ys.Length - 1, zs.Length - 1, 3];
    private readonly List<Vec3> _points = [];
    private readonly List<int> _faces = [];

    /// <summary>Fills the cells along each axis from the first up to, but not including, the last.</summary>
    public void Fill(int x0, int x1, int y0, int y1, int z0, int z1)
    {
        for (var x = x0; x < x1; x++)
        {
            for (var y = y0; y < y1; y++)
            {
                for (var z = z0; z < z1; z++) _full[x, y, z] = true;
            }
        }
    }

    /// <summary>Fills the lower half toward −X of a cell with full neighbors below and at −X and empty neighbors elsewhere.</summary>
    public void AddRib(int x, int y, int z) => _rib[x, y, z] = true;

    /// <summary>A hole in the middle of a column of full cells along Z.</summary>
    public void DrillAlongZ(int x, int y, int z0, int z1, double radius)
    {
        for (var z = z0; z < z1; z++) _hole[x, y, z, 2] = radius;
    }

    /// <summary>A hole in the middle of a row of full cells along X.</summary>
    public void DrillAlongX(int x0, int x1, int y, int z, double radius)
    {
        for (var x = x0; x < x1; x++) _hole[x, y, z, 0] = radius;
    }

    public TriMesh ToMesh()
    {
        _points.Clear();
        _faces.Clear();
        for (var x = 0; x + 1 < xs.Length; x++)
        {
            for (var y = 0; y + 1 < ys.Length; y++)
            {
                for (var z = 0; z + 1 < zs.Length; z++)
                {
                    if (_full[x, y, z]) AddCell(x, y, z);
                    if (_rib[x, y, z]) AddRibFaces(x, y, z);
                }
            }
        }
        return TriMesh.Create(_points, _faces);
    }

    private void AddCell(int x, int y, int z)
    {
        Vec3 P(int i, int j, int k) => new(xs[x + i], ys[y + j], zs[z + k]);
        Side(Covered(x - 1, y, z) || Rib(x - 1, y, z), [P(0, 0, 0), P(0, 0, 1), P(0, 1, 1), P(0, 1, 0)], _hole[x, y, z, 0]);
        Side(Covered(x + 1, y, z) || Rib(x + 1, y, z), [P(1, 0, 0), P(1, 1, 0), P(1, 1, 1), P(1, 0, 1)], _hole[x, y, z, 0]);
        Side(Covered(x, y - 1, z), [P(0, 0, 0), P(1, 0, 0), P(1, 0, 1), P(0, 0, 1)], 0);
        Side(Covered(x, y + 1, z), [P(0, 1, 0), P(0, 1, 1), P(1, 1, 1), P(1, 1, 0)], 0);
        Side(Covered(x, y, z - 1), [P(0, 0, 0), P(0, 1, 0), P(1, 1, 0), P(1, 0, 0)], _hole[x, y, z, 2]);
        Side(Covered(x, y, z + 1) || Rib(x, y, z + 1), [P(0, 0, 1), P(1, 0, 1), P(1, 1, 1), P(0, 1, 1)], _hole[x, y, z, 2]);
        if (_hole[x, y, z, 0] > 0) Wall([P(0, 0, 0), P(0, 0, 1), P(0, 1, 1), P(0, 1, 0)], new Vec3(xs[x + 1] - xs[x], 0), _hole[x, y, z, 0]);
        if (_hole[x, y, z, 2] > 0) Wall([P(0, 0, 0), P(0, 1, 0), P(1, 1, 0), P(1, 0, 0)], new Vec3(0, 0, zs[z + 1] - zs[z]), _hole[x, y, z, 2]);
    }

    private void AddRibFaces(int x, int y, int z)
    {
        Vec3 P(int i, int j, int k) => new(xs[x + i], ys[y + j], zs[z + k]);
        Quad([P(1, 0, 0), P(1, 1, 0), P(0, 1, 1), P(0, 0, 1)]);
        Triangle(P(0, 0, 0), P(1, 0, 0), P(0, 0, 1));
        Triangle(P(0, 1, 0), P(0, 1, 1), P(1, 1, 0));
    }

    private bool Covered(int x, int y, int z) => Inside(x, y, z) && _full[x, y, z];

    private bool Rib(int x, int y, int z) => Inside(x, y, z) && _rib[x, y, z];

    private bool Inside(int x, int y, int z) => x >= 0 && y >= 0 && z >= 0 && x + 1 < xs.Length && y + 1 < ys.Length && z + 1 < zs.Length;

    // A face, counterclockwise from outside, with a round hole if the radius is not 0.
    private void Side(bool covered, Vec3[] corners, double radius)
    {
        if (covered) return;
        if (radius == 0)
        {
            Quad(corners);
            return;
        }
        var circle = Circle(corners, radius);
        for (var side = 0; side < 4; side++)
        {
            const int Quarter = HoleCorners / 4;
            for (var i = 0; i < Quarter; i++) Triangle(corners[side], circle[side * Quarter + i + 1], circle[side * Quarter + i]);
            Triangle(corners[side], corners[(side + 1) % 4], circle[(side + 1) * Quarter]);
        }
    }

    // The inner wall of a hole that begins at a face.
    private void Wall(Vec3[] corners, Vec3 along, double radius)
    {
        var circle = Circle(corners, radius);
        for (var i = 0; i < HoleCorners; i++)
        {
            var (a, b) = (circle[i], circle[i + 1]);
            Quad([a, b, b + along, a + along]);
        }
    }

    // Counterclockwise like the corners. A quarter belongs to each corner. Points of opposite faces differ only by the shift.
    private static Vec3[] Circle(Vec3[] corners, double radius)
    {
        var center = (corners[0] + corners[2]) * 0.5;
        var across = (corners[0] - corners[1]).Unit();
        var along = (corners[0] - corners[3]).Unit();
        var points = new Vec3[HoleCorners + 1];
        for (var i = 0; i <= HoleCorners; i++)
        {
            // The first point is toward the side between the last and the first corner.
            var (sin, cos) = Angle.SinCos(360.0 * (i % HoleCorners) / HoleCorners);
            points[i] = center + across * (radius * cos) + along * (radius * sin);
        }
        return points;
    }

    private void Quad(Vec3[] c)
    {
        Triangle(c[0], c[1], c[2]);
        Triangle(c[0], c[2], c[3]);
    }

    private void Triangle(Vec3 a, Vec3 b, Vec3 c)
    {
        foreach (var p in new[] { a, b, c })
        {
            _faces.Add(_points.Count);
            _points.Add(p);
        }
    }
}
