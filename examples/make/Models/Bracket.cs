using Caterpillar.Geometry;

namespace Caterpillar.Examples;

/// <summary>
/// An angle bracket, 60 × 40 × 50 mm, 6 mm thick, with a rib at 45°. It has two 6 mm holes in the base and two 5 mm holes in the upright.
/// </summary>
internal static class Bracket
{
    public static TriMesh Make()
    {
        var blocks = new BlockSolid(
            [-30, -24, -4, 8, 18, 30],
            [-20, -17, -7, -3, 3, 7, 17, 20],
            [0, 6, 26, 32, 42, 50]);
        blocks.Fill(0, 5, 0, 7, 0, 1);
        blocks.Fill(0, 1, 0, 7, 1, 5);
        blocks.AddRib(1, 3, 1);
        foreach (var y in new[] { 1, 5 })
        {
            blocks.DrillAlongZ(3, y, 0, 1, 3);
            blocks.DrillAlongX(0, 1, y, 3, 2.5);
        }
        return blocks.ToMesh();
    }
}
