namespace Caterpillar.Curved;

/// <summary>
/// Finds vertical faces in the middle of a surface, as of pockets and ribs: no layer goes through them, and a mesh would be divided along them without end.
/// </summary>
internal static class PlanSteps
{
    // Steeper than any head allows, mm per mm.
    private const double Steep = 11;

    // mm.
    private const double Least = 0.1;
    private const double Edge = 0.05;

    public static void Check(PlanSurface plan, PartColumns part, DiagnosticList problems)
    {
        if (double.IsInfinity(plan.Detail)) return;
        var near = 1.01 * Math.Max(part.Bounds.Size.X, part.Bounds.Size.Y) / PartColumns.Cells;
        var places = part.Columns.Where(c => plan.Covers(c.X, c.Y)).Select(c => new Vec3(c.X, c.Y)).ToArray();
        if (places.Length == 0) return;
        var (highest, at) = (0.0, Vec3.Zero);
        Look(places);
        Look(places.OrderBy(p => p.X).ThenBy(p => p.Y).ToArray());
        // Outer walls that lean by less than can be printed.
        var center = part.Bounds.Center;
        foreach (var place in places)
        {
            var inside = place + new Vec3(Edge * Math.Sign(center.X - place.X), Edge * Math.Sign(center.Y - place.Y));
            if (plan.Covers(inside.X, inside.Y)) Compare(place, inside, plan.Height(place.X, place.Y), plan.Height(inside.X, inside.Y));
        }
        if (highest == 0) return;
        problems.Add(Severity.Error, "curved.plan_steps",
            $"The plan has a step of {NumberFormatter.Format(highest, 2)} mm at {at}, which no layer can follow.{PlanSurface.Otherwise}");

        void Look(Vec3[] row)
        {
            var last = plan.Height(row[0].X, row[0].Y);
            for (var i = 1; i < row.Length; i++)
            {
                var next = plan.Height(row[i].X, row[i].Y);
                if (row[i].DistanceTo(row[i - 1]) < near) Compare(row[i - 1], row[i], last, next);
                last = next;
            }
        }

        // The half in which the height changes more, until it is narrower than any feature.
        void Compare(Vec3 from, Vec3 to, double low, double high)
        {
            if (!(Math.Abs(high - low) > Math.Max(Least, Steep * from.DistanceTo(to)))) return;
            while (from.DistanceTo(to) > 1e-3)
            {
                var middle = Vec3.Lerp(from, to, 0.5);
                var height = plan.Height(middle.X, middle.Y);
                if (Math.Abs(height - low) > Math.Abs(high - height)) (to, high) = (middle, height);
                else (from, low) = (middle, height);
            }
            if (Math.Abs(high - low) > Math.Max(highest, Least)) (highest, at) = (Math.Abs(high - low), from.WithZ(low));
        }
    }
}
