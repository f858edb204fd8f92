namespace Caterpillar.Slicing;

/// <summary>Walls that wander in and out at random. The numbers depend on the seed and the wall's place in the print alone.</summary>
internal static class FuzzySkinThickness
{
    /// <summary>The wall with new points at about the wanted distance, each moved across the wall.</summary>
    public static WallPath Apply(WallPath wall, PrintSettings settings, int layer, int number)
    {
        var random = new SeededRandom(unchecked((settings.FuzzySkinSeed * 31 + layer) * 1009 + number));
        var points = new List<Vec3>();
        var widths = new List<double>();
        var next = settings.FuzzySkinPointDistance * random.NextDouble();
        for (var i = 0; i < wall.SegmentCount; i++)
        {
            var k = i + 1 == wall.Points.Length ? 0 : i + 1;
            Vec3 a = wall.Points[i], b = wall.Points[k];
            var length = a.DistanceTo(b);
            if (!(length > 0)) continue;
            var along = (b - a) / length;
            for (; next < length; next += settings.FuzzySkinPointDistance * (0.75 + 0.5 * random.NextDouble()))
            {
                var shift = settings.FuzzySkinThickness * (2 * random.NextDouble() - 1);
                points.Add(a + along * next + new Vec3(-along.Y, along.X) * shift);
                widths.Add(wall.Widths[i] + (wall.Widths[k] - wall.Widths[i]) * next / length);
            }
            next -= length;
        }
        return points.Count < 3 ? wall : wall with { Points = points.ToArray(), Widths = widths.ToArray() };
    }
}
