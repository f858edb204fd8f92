namespace Caterpillar.Slicing;

/// <summary>What the supports of each level keep out of, so that the gaps beside, above and below them stay open.</summary>
/// <param name="stack">The bodies to support.</param>
internal sealed class SupportGaps(SupportStack stack)
{
    // mm; outlines of supports and of what they keep out of are followed so closely.
    private const double Tolerance = 0.03;
    private readonly PrintSettings _settings = stack.Settings;
    private readonly SupportLevel[] _levels = stack.Levels;

    /// <summary>Finds it for the levels below one.</summary>
    /// <param name="top">Number of that level.</param>
    /// <param name="others">Layers of all other bodies, which supports keep away from.</param>
    /// <param name="options">Threads, and cancelling.</param>
    public void Find(int top, IReadOnlyList<LayerWork> others, ParallelOptions options) => RegionEngine.ForEach(0, top, options, (i, engine) =>
    {
        var level = _levels[i];
        var near = others.Where(o => o.Plan.Top > level.Top - level.Thickness + 1e-9 && o.Plan.Top - o.Plan.Thickness < level.Top - 1e-9).Select(o => o.Region);
        // Moved outward by a bit more than the gap, so that simplified outlines, also those of supports, are nowhere nearer.
        level.Forbidden = Region.Union(near.Append(level.Part), engine)
            .Offset(_settings.SupportXyGap + 3 * Tolerance, JoinStyle.Round, 2, Tolerance, engine).Simplified(Tolerance, engine);
        level.Obstacles = [level.Forbidden, .. PartsAround(i).Where(p => !level.Forbidden.Surrounds(p))];
    });

    /// <summary>What of some regions, together, is clear of everything.</summary>
    public Region Clear(int level, IReadOnlyList<Region> supports, RegionEngine engine)
        => Region.Difference(supports, _levels[level].Obstacles, engine).Simplified(Tolerance, engine);

    // What the part covers within the gaps above and below a level.
    private IEnumerable<Region> PartsAround(int i)
    {
        var level = _levels[i];
        for (var k = i + 1; k < _levels.Length && _levels[k].Top - _levels[k].Thickness < level.Top + _settings.SupportTopGap - 1e-6; k++)
            yield return _levels[k].Part;
        for (var k = i - 1; k >= 0 && _levels[k].Top > level.Top - level.Thickness - _settings.SupportBottomGap + 1e-6; k--) yield return _levels[k].Part;
    }
}
