using Caterpillar.Geometry;

namespace Caterpillar.Examples;

/// <summary>A block of 80 × 60 mm with a saddle (hyperbolic paraboloid) as roof, 6 to 20 mm high, for layers that follow a surface.</summary>
internal static class SaddleRoof
{
    private const double Width = 80;
    private const double Depth = 60;
    private const int Columns = 64;
    private const int Rows = 48;

    public static TriMesh Make() => HeightBlock.Make(Width, Depth, Columns, Rows, (i, j) =>
    {
        var x = 2.0 * i / Columns - 1;
        var y = 2.0 * j / Rows - 1;
        return 13 + 7 * (x * x - y * y);
    });
}
