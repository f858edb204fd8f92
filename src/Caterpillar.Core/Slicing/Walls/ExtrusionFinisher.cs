namespace Caterpillar.Slicing;

/// <summary>
/// Makes extrusions print their piece exactly: extrusions that go on straight are joined, branches begin at the edge of what they branch from, ends reach the
/// outline.
/// </summary>
internal sealed class ExtrusionFinisher(Region piece)
{
    private const int Slices = 16;

    public void Finish(List<MedialExtrusion> extrusions)
    {
        // A lone center in the bead of an extrusion is a piece of it.
        var covered = extrusions.FindAll(s => s.Count == 1 && extrusions.Exists(other => other.Count > 1 && other.Clearance(s.Points[0]) < 0));
        extrusions.RemoveAll(covered.Contains);
        foreach (var extrusion in extrusions)
        {
            if (extrusion.Count == 1) Stretch(extrusion);
            for (var side = 0; side < 2; side++)
            {
                extrusion.Reverse();
                // At the end of the shape its outline is near; else the extrusion ended in a corner at the side of another, or in one.
                if (extrusion.End == ExtrusionEnd.Outline && (!(Ahead(extrusion) < 3) || EndsIn(extrusion, extrusions))) extrusion.End = ExtrusionEnd.Junction;
            }
        }
        Join(extrusions);
        foreach (var extrusion in extrusions)
        {
            if (extrusion.Closed) continue;
            for (var side = 0; side < 2; side++)
            {
                extrusion.Reverse();
                var end = extrusion.Points[extrusion.Count - 1];
                if (extrusion.End == ExtrusionEnd.Junction) Trim(extrusion, extrusions);
                // A junction without an extrusion that passes is an end like others.
                var free = extrusion.End == ExtrusionEnd.Junction && extrusion.Points[extrusion.Count - 1] == end && Ahead(extrusion) < 3;
                if (extrusion.End == ExtrusionEnd.Outline || free) Extend(extrusion);
            }
        }
    }

    // A lone center becomes a short line in the direction in which its piece is longest.
    private void Stretch(MedialExtrusion extrusion)
    {
        var center = extrusion.Points[0];
        var longest = -1.0;
        var along = Vec3.UnitX;
        for (var degrees = 0; degrees < 180; degrees += 15)
        {
            var (sin, cos) = Angle.SinCos(degrees);
            var d = new Vec3(cos, sin);
            var length = Math.Min(Ray(center, d), 1e3) + Math.Min(Ray(center, -d), 1e3);
            if (length > longest + 1e-6) (longest, along) = (length, d);
        }
        var radius = extrusion.Radii[0];
        extrusion.Points[0] = center - along * 1e-3;
        extrusion.Add(center + along * 1e-3, radius);
        extrusion.Start = extrusion.End = ExtrusionEnd.Outline;
    }

    // Where only ends meet and no extrusion passes, the straightest two become one extrusion.
    private static void Join(List<MedialExtrusion> extrusions)
    {
        while (true)
        {
            int bestA = -1, bestB = -1, pairing = 0;
            var straightest = 0.3;
            for (var a = 0; a < extrusions.Count; a++)
            {
                for (var b = a; b < extrusions.Count; b++)
                {
                    for (var k = 0; k < 4; k++)
                    {
                        if ((a == b && k != 2) || extrusions[a].Closed || extrusions[b].Closed) continue;
                        var (p, r, headingA) = EndOf(extrusions[a], atEnd: k >= 2);
                        var (q, t, headingB) = EndOf(extrusions[b], atEnd: (k & 1) == 1);
                        if (p.Kind != ExtrusionEnd.Junction || q.Kind != ExtrusionEnd.Junction || (p.At - q.At).LengthXY > 0.75 * (r + t)) continue;
                        if (a == b && extrusions[a].Length < 4 * r) continue;
                        var dot = headingA.X * headingB.X + headingA.Y * headingB.Y;
                        if (dot < straightest && !Passed(extrusions, a, b, p.At)) (straightest, bestA, bestB, pairing) = (dot, a, b, k);
                    }
                }
            }
            if (bestA < 0) return;
            var first = extrusions[bestA];
            if (bestA == bestB)
            {
                first.Closed = true;
                continue;
            }
            var second = extrusions[bestB];
            if (pairing < 2) first.Reverse();
            if ((pairing & 1) == 1) second.Reverse();
            for (var i = 0; i < second.Count; i++) first.Add(second.Points[i], second.Radii[i]);
            first.End = second.End;
            extrusions.RemoveAt(bestB);
        }
    }

    private static bool EndsIn(MedialExtrusion extrusion, List<MedialExtrusion> extrusions)
    {
        var end = extrusion.Points[extrusion.Count - 1];
        return extrusions.Exists(other => other != extrusion && other.Clearance(end) < 0);
    }

    private static bool Passed(List<MedialExtrusion> extrusions, int a, int b, Vec3 at)
    {
        for (var i = 0; i < extrusions.Count; i++)
        {
            if (i != a && i != b && extrusions[i].Passes(at)) return true;
        }
        return false;
    }

    private static ((Vec3 At, ExtrusionEnd Kind) End, double Radius, Vec3 Heading) EndOf(MedialExtrusion extrusion, bool atEnd)
    {
        if (!atEnd) extrusion.Reverse();
        var radius = extrusion.Radii[extrusion.Count - 1];
        var result = ((extrusion.Points[extrusion.Count - 1], extrusion.End), radius, extrusion.Heading(2 * radius));
        if (!atEnd) extrusion.Reverse();
        return result;
    }

    private static void Trim(MedialExtrusion extrusion, List<MedialExtrusion> extrusions)
    {
        // By those that pass where it ends; others are near because they end there, too.
        var end = extrusion.Points[extrusion.Count - 1];
        foreach (var other in extrusions)
        {
            if (other != extrusion && other.Clearance(end) < 0) extrusion.TrimEnd(other);
        }
        // A bowl comes back to its own stem.
        var own = new MedialExtrusion();
        var left = extrusion.Length - 5 * extrusion.Radii[extrusion.Count - 1];
        for (var i = 0; i < extrusion.Count && left > 0; i++)
        {
            own.Add(extrusion.Points[i], extrusion.Radii[i]);
            if (i + 1 < extrusion.Count) left -= (extrusion.Points[i + 1] - extrusion.Points[i]).LengthXY;
        }
        if (own.Count > 1) extrusion.TrimEnd(own);
    }

    // Distance from the end to the outline, in radii.
    private double Ahead(MedialExtrusion extrusion)
    {
        var radius = extrusion.Radii[extrusion.Count - 1];
        var d = extrusion.Heading(radius);
        return d == Vec3.Zero ? 0 : Ray(extrusion.Points[extrusion.Count - 1], d) / radius;
    }

    // As far as its bead has the area of what is left of the piece ahead: to the end where that is square, not as far where it is round or pointed.
    private void Extend(MedialExtrusion extrusion)
    {
        var end = extrusion.Points[extrusion.Count - 1];
        var radius = extrusion.Radii[extrusion.Count - 1];
        var d = extrusion.Heading(radius);
        var reach = Ray(end, d);
        if (d == Vec3.Zero || !(reach < 4 * radius)) return;
        var last = Across(end + d * (0.98 * reach), d, 1.3 * radius) / 2;
        if (last >= 0.9 * radius)
        {
            if (reach > 1e-4) extrusion.Add(end + d * reach, last);
            return;
        }
        var area = 0.0;
        for (var k = 0; k < Slices; k++) area += Across(end + d * (reach * (k + 0.5) / Slices), d, 2 * radius);
        var length = Math.Min(reach, area * reach / Slices / (2 * radius));
        if (length > 1e-4) extrusion.Add(end + d * length, radius);
    }

    // Thickness across a direction, each side up to a limit.
    private double Across(Vec3 p, Vec3 d, double limit)
    {
        var side = new Vec3(-d.Y, d.X);
        return Math.Min(Ray(p, side), limit) + Math.Min(Ray(p, -side), limit);
    }

    // Distance from a point inside to the boundary.
    private double Ray(Vec3 from, Vec3 d)
    {
        var nearest = double.PositiveInfinity;
        foreach (var path in piece.Paths)
        {
            var a = Grid.ToMm(path[path.Length - 1]) - from;
            foreach (var vertex in path)
            {
                var b = Grid.ToMm(vertex) - from;
                // Across the ray, and along it.
                double ya = d.X * a.Y - d.Y * a.X, yb = d.X * b.Y - d.Y * b.X;
                if (ya > 0 != yb > 0)
                {
                    double xa = d.X * a.X + d.Y * a.Y, xb = d.X * b.X + d.Y * b.Y;
                    var x = xa + (xb - xa) * ya / (ya - yb);
                    if (x > 0 && x < nearest) nearest = x;
                }
                a = b;
            }
        }
        return nearest;
    }
}
