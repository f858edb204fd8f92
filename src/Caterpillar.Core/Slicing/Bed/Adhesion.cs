namespace Caterpillar.Slicing;

/// <summary>Skirt and brim: loops around the parts on the bed, printed first. A skirt primes the nozzle, and a brim holds the part on the bed.</summary>
internal static class Adhesion
{
    private const double ArcTolerance = 0.05;

    /// <summary>The first layer with the loops in front of its steps, by the tool of the first one.</summary>
    /// <param name="first">The layer.</param>
    /// <param name="parts">Area of the parts on the bed.</param>
    /// <param name="covered">Area of all on the bed.</param>
    /// <param name="settings">The settings of the print.</param>
    public static SlicedLayer Around(SlicedLayer first, Region parts, Region covered, PrintSettings settings)
    {
        if (!settings.HasSkirtOrBrim) return first;
        var rules = SliceRules.Of(settings, first.Layer.Thickness, first: true);
        var steps = new List<PathStep>();
        // They go around all objects and belong to none.
        var layer = first.Layer with { Object = "" };
        var pitch = rules.Pitch(rules.Width);
        var hasBrim = settings.BrimWidth > 0 && settings.BrimType != BrimType.Ears;
        var brim = hasBrim ? Math.Max(1, (int)Math.Floor(settings.BrimWidth / pitch + 0.5)) : 0;
        var outside = settings.BrimType != BrimType.InnerOnly;
        var reach = brim > 0 && outside ? settings.BrimGap + brim * pitch : 0;
        // Arcs need points that lie near them.
        var chords = settings.ArcFittingTolerance > 0 ? Math.Min(ArcTolerance, settings.ArcFittingTolerance / 4) : ArcTolerance;
        var ears = BrimEars.Around(parts, covered.Offset(settings.BrimGap + brim * pitch, JoinStyle.Round, arcTolerance: chords), settings, chords);
        var around = Region.Union([covered, ears]);
        // From the outside in, so that each loop has the next one to lean on.
        for (var loop = settings.SkirtLoops - 1; loop >= 0; loop--)
            Loops(around, reach + settings.SkirtDistance + rules.Width / 2 + loop * pitch, Role.Skirt, outer: true, holes: false);
        for (var loop = brim - 1; loop >= 0; loop--)
            Loops(covered, settings.BrimGap + rules.Width / 2 + loop * pitch, Role.Brim, outside, settings.BrimType != BrimType.OuterOnly);
        var builder = new WallBuilder(rules.Walls, new RegionEngine());
        foreach (var ear in ears.Islands)
        {
            foreach (var loop in builder.Fill(ear).Paths) Add(loop.ToPath(first.Layer.Z, rules.Walls), Role.Brim);
        }
        steps.AddRange(first.Steps);
        return first with { Steps = steps };

        void Loops(Region inner, double distance, Role role, bool outer, bool holes)
        {
            foreach (var contour in inner.Offset(distance, JoinStyle.Round, arcTolerance: chords).Contours)
            {
                var isHole = contour.SignedAreaXY < 0;
                if (!(isHole ? holes : outer)) continue;
                var points = Array.ConvertAll(contour.Raw, p => p.WithZ(first.Layer.Z));
                Add(PrintPath.Own(points, [rules.Bead(rules.Width)], closed: true), role);
            }
        }

        // One rank for each loop keeps their order.
        void Add(PrintPath path, Role role)
            => steps.Add(new PathStep(path with { Role = role, Layer = layer, Tool = first.Steps[0].Path.Tool }, new StepGroup(0, -1, steps.Count)));
    }
}
