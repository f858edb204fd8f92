namespace Caterpillar.Slicing;

/// <summary>A branch of a tree where it passes a level.</summary>
/// <param name="level">Number of the level.</param>
/// <param name="place">Its middle, mm.</param>
internal sealed class TreeNode(int level, Vec3 place)
{
    /// <summary>mm between the circle of a branch and the corners outside, and the sides within.</summary>
    public const double Tolerance = 0.05;

    private const int FewestCorners = 6;

    public int Level { get; } = level;

    /// <summary>mm; moved when the branch is smoothed.</summary>
    public Vec3 Place { get; set; } = place;

    /// <summary>mm.</summary>
    public double Radius { get; set; }

    /// <summary>mm below its highest tip.</summary>
    public double Depth { get; set; }

    /// <summary>Number of tips that it carries.</summary>
    public int Tips { get; set; } = 1;

    /// <summary>Whether a path leads from here to the bed. Other branches end on the part.</summary>
    public bool ReachesBed { get; set; }

    /// <summary>The branch that it grows toward.</summary>
    public TreeNode? Partner { get; set; }

    /// <summary>The branch that continues it on the level below; null where it ends.</summary>
    public TreeNode? Below { get; set; }

    /// <summary>What the branch covers: a polygon with as few corners as its circle needs.</summary>
    public Region Region
    {
        get
        {
            var corners = FewestCorners;
            while ((Radius + Tolerance) * (1 - Angle.Cos(180.0 / corners)) > 2 * Tolerance) corners++;
            var points = new Vec3[corners];
            for (var k = 0; k < corners; k++)
            {
                var (sin, cos) = Angle.SinCos(360.0 * k / corners);
                points[k] = Place + (Radius + Tolerance) * new Vec3(cos, sin);
            }
            return Region.Own([Region.ToGrid(points, nameof(Place))]);
        }
    }
}
