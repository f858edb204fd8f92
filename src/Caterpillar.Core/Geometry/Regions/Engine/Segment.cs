namespace Caterpillar.Geometry;

/// <summary>A directed segment on the grid.</summary>
internal struct Segment(GridPoint a, GridPoint b)
{
    public int Ax = a.X;
    public int Ay = a.Y;
    public int Bx = b.X;
    public int By = b.Y;

    public readonly GridPoint A => new(Ax, Ay);

    public readonly GridPoint B => new(Bx, By);

    /// <summary>Positive if the point is left of the segment. Exact.</summary>
    public readonly long Side(int x, int y) => ((long)Bx - Ax) * ((long)y - Ay) - ((long)By - Ay) * ((long)x - Ax);
}

/// <summary>A box on the grid.</summary>
internal struct GridBox
{
    public int MinX;
    public int MinY;
    public int MaxX;
    public int MaxY;

    public static GridBox Nothing => new() { MinX = int.MaxValue, MinY = int.MaxValue, MaxX = int.MinValue, MaxY = int.MinValue };

    public void Include(int x, int y)
    {
        if (x < MinX) MinX = x;
        if (x > MaxX) MaxX = x;
        if (y < MinY) MinY = y;
        if (y > MaxY) MaxY = y;
    }

    public void Include(in GridBox other)
    {
        MinX = Math.Min(MinX, other.MinX);
        MinY = Math.Min(MinY, other.MinY);
        MaxX = Math.Max(MaxX, other.MaxX);
        MaxY = Math.Max(MaxY, other.MaxY);
    }

    /// <summary>Larger by a distance on all sides, mm.</summary>
    public readonly GridBox Grown(double distance)
    {
        var d = (long)Math.Ceiling(distance * Grid.PerMm);
        return new()
        {
            MinX = (int)Math.Max(int.MinValue, MinX - d), MinY = (int)Math.Max(int.MinValue, MinY - d),
            MaxX = (int)Math.Min(int.MaxValue, MaxX + d), MaxY = (int)Math.Min(int.MaxValue, MaxY + d),
        };
    }

    public static bool Overlap(in GridBox a, in GridBox b) => a.MinX <= b.MaxX && b.MinX <= a.MaxX && a.MinY <= b.MaxY && b.MinY <= a.MaxY;

    /// <summary>Whether one of some boxes overlaps another one.</summary>
    public static bool Overlap(GridBox[] boxes, in GridBox other)
    {
        foreach (var box in boxes)
        {
            if (Overlap(box, other)) return true;
        }
        return false;
    }

    /// <summary>The box around some of many boxes.</summary>
    public static GridBox Around(GridBox[] boxes, int first, int end)
    {
        var box = Nothing;
        for (var i = first; i < end; i++) box.Include(boxes[i]);
        return box;
    }

    public static GridBox Of(in Segment s)
        => new() { MinX = Math.Min(s.Ax, s.Bx), MinY = Math.Min(s.Ay, s.By), MaxX = Math.Max(s.Ax, s.Bx), MaxY = Math.Max(s.Ay, s.By) };

    public static GridBox Of(GridPoint[] points)
    {
        var box = Nothing;
        foreach (var p in points) box.Include(p.X, p.Y);
        return box;
    }
}
