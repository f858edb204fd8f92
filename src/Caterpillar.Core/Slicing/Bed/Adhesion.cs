namespace Caterpillar.Slicing;

/// <summary>Skirt and brim: loops around the parts on the bed, printed first. A skirt primes the nozzle, and a brim holds the part on the bed.</summary>
internal static class Adhesion
{
    private const double ArcTolerance = 0.05;

    /// <summary>The first layer with the loops in front of its steps, by the tool of the first one.</summary>
    /// <param name="first">The layer.</param>
    /// <param name="covered">Area of the parts on the bed.</param>
    /// <param name="settings">The settings of the print.</param>
    public static SlicedLayer Around(SlicedLayer first, Region covered, PrintSettings settings)
    {
        if (settings.SkirtLoops == 0 && settings.BrimWidth == 0) return first;
        var rules = SliceRules.Of(settings, first.Layer.Thickness);
        var steps = new List<PathStep>();
        var pitch = rules.Pitch(rules.Width);
        var brim = settings.BrimWidth > 0 ? Math.Max(1, (int)Math.Floor(settings.BrimWidth / pitch + 0.5)) : 0;
        var outside = settings.BrimType != BrimType.InnerOnly;
        var reach = brim > 0 && outside ? settings.BrimGap + brim * pitch : 0;
        // From the outside in, so that each loop has the next one to lean on.
        for (var loop = settings.SkirtLoops - 1; loop >= 0; loop--)
            Add(reach + settings.SkirtDistance + rules.Width / 2 + loop * pitch, Role.Skirt, outer: true, holes: false);
        for (var loop = brim - 1; loop >= 0; loop--)
            Add(settings.BrimGap + rules.Width / 2 + loop * pitch, Role.Brim, outside, settings.BrimType != BrimType.OuterOnly);
        steps.AddRange(first.Steps);
        return first with { Steps = steps };

        void Add(double distance, Role role, bool outer, bool holes)
        {
            foreach (var contour in covered.Offset(distance, JoinStyle.Round, arcTolerance: ArcTolerance).Contours)
            {
                var isHole = contour.SignedAreaXY < 0;
                if (!(isHole ? holes : outer)) continue;
                var points = Array.ConvertAll(contour.Raw, p => p.WithZ(first.Layer.Z));
                var path = PrintPath.Own(points, [rules.Bead(rules.Width)], closed: true).With(role, first.Layer, first.Steps[0].Path.Tool);
                // One rank for each loop keeps their order.
                steps.Add(new PathStep(path, new StepGroup(0, -1, steps.Count)));
            }
        }
    }
}
