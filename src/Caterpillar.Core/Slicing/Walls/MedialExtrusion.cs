namespace Caterpillar.Slicing;

/// <summary>What the end of a single extrusion meets.</summary>
internal enum ExtrusionEnd : byte
{
    /// <summary>The end of the shape.</summary>
    Outline,

    /// <summary>Other extrusions.</summary>
    Junction,

    /// <summary>A place too thin to go on.</summary>
    Thin,
}

/// <summary>A single extrusion in progress: points on the medial axis and the radii of their discs, mm.</summary>
internal sealed class MedialExtrusion
{
    public List<Vec3> Points { get; } = [];

    public List<double> Radii { get; } = [];

    public bool Closed { get; set; }

    public ExtrusionEnd Start { get; set; }

    public ExtrusionEnd End { get; set; }

    public int Count => Points.Count;

    public double Length
    {
        get
        {
            var sum = 0.0;
            for (var i = 1; i < Points.Count; i++) sum += (Points[i] - Points[i - 1]).LengthXY;
            return sum;
        }
    }

    public void Add(Vec3 point, double radius)
    {
        Points.Add(point);
        Radii.Add(radius);
    }

    public void Reverse()
    {
        Points.Reverse();
        Radii.Reverse();
        (Start, End) = (End, Start);
    }

    /// <summary>The direction in which it leaves at its end, from the last points within a reach; zero for an extrusion without length.</summary>
    public Vec3 Heading(double reach)
    {
        var end = Points[Count - 1];
        var i = Count - 1;
        while (i > 0 && (end - Points[i]).LengthXY < reach) i--;
        var d = end - Points[i];
        return d.LengthXY > 1e-9 ? d / d.LengthXY : Vec3.Zero;
    }

    /// <summary>Distance from a point to the extrusion less the radius there: negative in its bead.</summary>
    public double Clearance(Vec3 p) => Clearance(p, out _);

    /// <summary>True if a point is inside its bead, and not just before one of its ends.</summary>
    public bool Passes(Vec3 p) => Clearance(p, out var atEnd) < 0 && !atEnd;

    private double Clearance(Vec3 p, out bool atEnd)
    {
        var best = double.PositiveInfinity;
        atEnd = false;
        for (var i = 0; i < Count; i++)
        {
            var next = i + 1 == Count ? Closed ? 0 : i : i + 1;
            Vec3 a = Points[i], d = Points[next] - a;
            var t = FlatSegment.Parameter(p, a, Points[next]);
            var clearance = (p - (a + d * t)).LengthXY - (Radii[i] + (Radii[next] - Radii[i]) * t);
            if (!(clearance < best)) continue;
            best = clearance;
            atEnd = !Closed && ((i == 0 && t == 0) || (i + 2 == Count && t == 1));
        }
        return best;
    }

    /// <summary>Cuts from the end whatever lies in the bead of another extrusion, up to where it is clear of it.</summary>
    public void TrimEnd(MedialExtrusion other)
    {
        if (other.Clearance(Points[Count - 1]) >= 0) return;
        for (; Count > 1; Points.RemoveAt(Count - 1), Radii.RemoveAt(Radii.Count - 1))
        {
            Vec3 last = Points[Count - 1], path = Points[Count - 2] - last;
            // What is between two places that are covered may be clear.
            var steps = Math.Max(1, Math.Ceiling(path.LengthXY / (Radii[Count - 1] / 4)));
            for (var k = 1; k <= steps; k++)
            {
                if (other.Clearance(last + path * (k / steps)) < 0) continue;
                double held = (k - 1) / steps, free = k / steps;
                for (var round = 0; round < 20; round++)
                {
                    var middle = (free + held) / 2;
                    if (other.Clearance(last + path * middle) >= 0) free = middle;
                    else held = middle;
                }
                Points[Count - 1] = last + path * free;
                Radii[Count - 1] += (Radii[Count - 2] - Radii[Count - 1]) * free;
                return;
            }
        }
    }
}
