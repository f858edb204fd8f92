namespace Caterpillar.Slicing;

/// <summary>Disks of one layer around sharp corners and at chosen points, where parts come off the bed first.</summary>
internal static class BrimEars
{
    // Length over which the sides of a corner are taken, so that roundings count, mm.
    private const double Arm = 2;

    /// <summary>What the ears cover.</summary>
    /// <param name="parts">What parts cover on the bed: their corners get ears.</param>
    /// <param name="covered">What is covered already, with the gap of the brim.</param>
    /// <param name="settings">The settings of the print.</param>
    /// <param name="chords">Largest deviation of chords from the disks, mm.</param>
    public static Region Around(Region parts, Region covered, PrintSettings settings, double chords)
    {
        var disks = new List<Region>();
        foreach (var ear in settings.BrimEars) disks.Add(Disk(ear.X, ear.Y, ear.Diameter / 2, chords));
        if (settings is { BrimType: BrimType.Ears, BrimWidth: > 0 })
        {
            foreach (var contour in parts.Contours)
            {
                if (contour.SignedAreaXY < 0) continue;
                foreach (var corner in Corners(contour.Raw, settings.BrimEarsMaxAngle)) disks.Add(Disk(corner.X, corner.Y, settings.BrimWidth, chords));
            }
        }
        return disks.Count == 0 ? Region.Empty : Region.Union(disks).Subtract(covered);
    }

    // Convex corners that are as sharp; of several within an arm, as in a rounding, the sharpest one.
    private static List<Vec3> Corners(Vec3[] contour, double most)
    {
        var sharp = new List<(double Angle, Vec3 Place)>();
        for (var i = 0; i < contour.Length; i++)
        {
            var angle = 180 - LoopCorner.Turn(contour, i, Arm);
            if (angle <= most) sharp.Add((angle, contour[i]));
        }
        var corners = new List<Vec3>();
        foreach (var (_, place) in sharp.OrderBy(c => c.Angle))
        {
            if (!corners.Exists(c => c.DistanceTo(place) < Arm)) corners.Add(place);
        }
        return corners;
    }

    private static Region Disk(double x, double y, double radius, double chords)
    {
        const double Seed = 0.01;
        return Region.Rectangle(x - Seed, y - Seed, x + Seed, y + Seed).Offset(radius - Seed, JoinStyle.Round, arcTolerance: chords);
    }
}
