using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>
/// Makes strands print their piece exactly: strands that go on straight are joined, branches begin at the edge of what they branch from, ends reach the
/// outline.
/// </summary>
internal sealed class StrandFinisher(Region piece)
{
    private const int Slices = 16;

    public void Finish(List<MedialStrand> strands)
    {
        // A lone center in the bead of a strand is a piece of it.
        var covered = strands.FindAll(s => s.Count == 1 && strands.Exists(other => other.Count > 1 && other.Clearance(s.Points[0]) < 0));
        strands.RemoveAll(covered.Contains);
        foreach (var strand in strands)
        {
            if (strand.Count == 1) Stretch(strand);
            for (var side = 0; side < 2; side++)
            {
                strand.Reverse();
                // At the end of the shape its outline is near; else the strand ended in a corner at the side of another, or in one.
                if (strand.End == StrandEnd.Outline && (!(Ahead(strand) < 3) || EndsIn(strand, strands))) strand.End = StrandEnd.Junction;
            }
        }
        Join(strands);
        foreach (var strand in strands)
        {
            if (strand.Closed) continue;
            for (var side = 0; side < 2; side++)
            {
                strand.Reverse();
                var end = strand.Points[strand.Count - 1];
                if (strand.End == StrandEnd.Junction) Trim(strand, strands);
                // A junction without a strand that passes is an end like others.
                var free = strand.End == StrandEnd.Junction && strand.Points[strand.Count - 1] == end && Ahead(strand) < 3;
                if (strand.End == StrandEnd.Outline || free) Extend(strand);
            }
        }
    }

    // A lone center becomes a short line in the direction in which its piece is longest.
    private void Stretch(MedialStrand strand)
    {
        var center = strand.Points[0];
        var longest = -1.0;
        var along = Vec3.UnitX;
        for (var degrees = 0; degrees < 180; degrees += 15)
        {
            var (sin, cos) = Angle.SinCos(degrees);
            var d = new Vec3(cos, sin);
            var length = Math.Min(Ray(center, d), 1e3) + Math.Min(Ray(center, -d), 1e3);
            if (length > longest + 1e-6) (longest, along) = (length, d);
        }
        var radius = strand.Radii[0];
        strand.Points[0] = center - along * 1e-3;
        strand.Add(center + along * 1e-3, radius);
        strand.Start = strand.End = StrandEnd.Outline;
    }

    // Where only ends meet and no strand passes, the straightest two become one strand.
    private static void Join(List<MedialStrand> strands)
    {
        while (true)
        {
            int bestA = -1, bestB = -1, pairing = 0;
            var straightest = 0.3;
            for (var a = 0; a < strands.Count; a++)
            {
                for (var b = a; b < strands.Count; b++)
                {
                    for (var k = 0; k < 4; k++)
                    {
                        if ((a == b && k != 2) || strands[a].Closed || strands[b].Closed) continue;
                        var (p, r, headingA) = EndOf(strands[a], atEnd: k >= 2);
                        var (q, t, headingB) = EndOf(strands[b], atEnd: (k & 1) == 1);
                        if (p.Kind != StrandEnd.Junction || q.Kind != StrandEnd.Junction || (p.At - q.At).LengthXY > 0.75 * (r + t)) continue;
                        if (a == b && strands[a].Length < 4 * r) continue;
                        var dot = headingA.X * headingB.X + headingA.Y * headingB.Y;
                        if (dot < straightest && !Passed(strands, a, b, p.At)) (straightest, bestA, bestB, pairing) = (dot, a, b, k);
                    }
                }
            }
            if (bestA < 0) return;
            var first = strands[bestA];
            if (bestA == bestB)
            {
                first.Closed = true;
                continue;
            }
            var second = strands[bestB];
            if (pairing < 2) first.Reverse();
            if ((pairing & 1) == 1) second.Reverse();
            for (var i = 0; i < second.Count; i++) first.Add(second.Points[i], second.Radii[i]);
            first.End = second.End;
            strands.RemoveAt(bestB);
        }
    }

    private static bool EndsIn(MedialStrand strand, List<MedialStrand> strands)
    {
        var end = strand.Points[strand.Count - 1];
        return strands.Exists(other => other != strand && other.Clearance(end) < 0);
    }

    private static bool Passed(List<MedialStrand> strands, int a, int b, Vec3 at)
    {
        for (var i = 0; i < strands.Count; i++)
        {
            if (i != a && i != b && strands[i].Passes(at)) return true;
        }
        return false;
    }

    private static ((Vec3 At, StrandEnd Kind) End, double Radius, Vec3 Heading) EndOf(MedialStrand strand, bool atEnd)
    {
        if (!atEnd) strand.Reverse();
        var radius = strand.Radii[strand.Count - 1];
        var result = ((strand.Points[strand.Count - 1], strand.End), radius, strand.Heading(2 * radius));
        if (!atEnd) strand.Reverse();
        return result;
    }

    private static void Trim(MedialStrand strand, List<MedialStrand> strands)
    {
        // By those that pass where it ends; others are near because they end there, too.
        var end = strand.Points[strand.Count - 1];
        foreach (var other in strands)
        {
            if (other != strand && other.Clearance(end) < 0) strand.TrimEnd(other);
        }
        // A bowl comes back to its own stem.
        var own = new MedialStrand();
        var left = strand.Length - 5 * strand.Radii[strand.Count - 1];
        for (var i = 0; i < strand.Count && left > 0; i++)
        {
            own.Add(strand.Points[i], strand.Radii[i]);
            if (i + 1 < strand.Count) left -= (strand.Points[i + 1] - strand.Points[i]).LengthXY;
        }
        if (own.Count > 1) strand.TrimEnd(own);
    }

    // Distance from the end to the outline, in radii.
    private double Ahead(MedialStrand strand)
    {
        var radius = strand.Radii[strand.Count - 1];
        var d = strand.Heading(radius);
        return d == Vec3.Zero ? 0 : Ray(strand.Points[strand.Count - 1], d) / radius;
    }

    // As far as its bead has the area of what is left of the piece ahead: to the end where that is square, not as far where it is round or pointed.
    private void Extend(MedialStrand strand)
    {
        var end = strand.Points[strand.Count - 1];
        var radius = strand.Radii[strand.Count - 1];
        var d = strand.Heading(radius);
        var reach = Ray(end, d);
        if (d == Vec3.Zero || !(reach < 4 * radius)) return;
        var last = Across(end + d * (0.98 * reach), d, 1.3 * radius) / 2;
        if (last >= 0.9 * radius)
        {
            if (reach > 1e-4) strand.Add(end + d * reach, last);
            return;
        }
        var area = 0.0;
        for (var k = 0; k < Slices; k++) area += Across(end + d * (reach * (k + 0.5) / Slices), d, 2 * radius);
        var length = Math.Min(reach, area * reach / Slices / (2 * radius));
        if (length > 1e-4) strand.Add(end + d * length, radius);
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
