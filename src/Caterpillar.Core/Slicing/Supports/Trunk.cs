namespace Caterpillar.Slicing;

/// <summary>A branch of a tree where it passes a level: a polygon with as few corners as a circle needs.</summary>
/// <param name="Place">Its middle, mm.</param>
/// <param name="Radius">Of its corners, mm.</param>
/// <param name="Branch">Number among the branches of the level.</param>
/// <param name="Below">Index of the branch that continues it on the level below. −1 = it ends.</param>
internal readonly record struct Trunk(Vec3 Place, double Radius, int Branch, int Below)
{
    // mm between the circle and the corners outside, and the sides within.
    private const double Tolerance = 0.05;
    private const int Fewest = 6;

    private int Corners
    {
        get
        {
            var corners = Fewest;
            while (Radius * (1 - Angle.Cos(180.0 / corners)) > 2 * Tolerance) corners++;
            return corners;
        }
    }

    /// <summary>The trunk for a circle, mm.</summary>
    public static Trunk Around(Vec3 place, double radius, int branch, int below) => new(place, radius + Tolerance, branch, below);

    /// <summary>What the trunk covers.</summary>
    public Region Region => Region.Own([Region.ToGrid(Ring(0), nameof(Place))]);

    /// <summary>The outline, or a loop so far within, mm.</summary>
    /// <param name="inset">mm, less than a circle within reaches to the middle.</param>
    public Vec3[] Ring(double inset)
    {
        var corners = Corners;
        var radius = Radius - inset / Angle.Cos(180.0 / corners);
        var points = new Vec3[corners];
        for (var k = 0; k < corners; k++)
        {
            var (sin, cos) = Angle.SinCos(360.0 * k / corners);
            points[k] = Place + new Vec3(radius * cos, radius * sin);
        }
        return points;
    }

    /// <summary>Whether it does not touch another one.</summary>
    public bool IsApartFrom(in Trunk other) => Place.DistanceTo(other.Place) > Radius + other.Radius;

    /// <summary>Whether it does not touch a region.</summary>
    public bool IsApartFrom(Region region) => region.IsFartherThan(Radius, Place);

    /// <summary>Whether it leans out over another one by no more than a distance, mm.</summary>
    public bool RestsOn(in Trunk below, double reach)
    {
        // Polygons of the same shape lie in each other as circles do; of others, only the circle within counts.
        var least = Corners == below.Corners ? below.Radius : below.Radius - 2 * Tolerance;
        return Place.DistanceTo(below.Place) + Math.Max(0, Radius - least) <= reach;
    }
}
