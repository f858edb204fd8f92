namespace Caterpillar.Slicing;

/// <summary>Leaves of supports what is carried, from the bed up: what lies on the bed, on supports below, or (everywhere) closely above the part.</summary>
internal sealed class CarriedSupports(SupportStack stack)
{
    /// <summary>Of the line width; half of the width below which a roof is too thin: those of trees on steep slopes lean on each other.</summary>
    public const double ThinRoof = 0.3;

    private const double ArcTolerance = 0.03;

    // mm²; less is rounding.
    private const double Film = 1e-3;
    private readonly PrintSettings _settings = stack.Settings;
    private readonly SupportLevel[] _levels = stack.Levels;
    private readonly double _width = stack.LineWidth;

    // mm; half of the width below which an extrusion is too thin.
    private readonly double _thin = stack.LineWidth * (stack.Settings.Support == SupportKind.Tree ? ThinRoof : 0.5);
    private readonly RegionEngine _engine = new();

    /// <summary>Removes all supports that nothing carries.</summary>
    public void Keep(CancellationToken cancel)
    {
        for (var i = 0; i < _levels.Length; i++)
        {
            cancel.ThrowIfCancellationRequested();
            Keep(i);
        }
    }

    private void Keep(int i)
    {
        var level = _levels[i];
        if (i == 0)
        {
            level.Pieces = ThinParts.Thick(level.Pieces, _thin, _engine);
            return;
        }
        if (level.Pieces.IsEmpty) return;
        var below = _levels[i - 1].Pieces;
        // A spot as small as a dot has no extrusion, and carries nothing.
        var islands = level.Pieces.Islands.Where(o => o.Area > _width * _width).ToArray();
        // What is below, with what extrusions may lean out over it.
        var carrying = below.Near([.. islands.Select(r => r.Box)], 2 * Lean(level)).Offset(Lean(level), JoinStyle.Square, 2, ArcTolerance, _engine);
        var pieces = new List<Region>();
        var cut = new List<Region>();
        foreach (var island in islands) (carrying.Surrounds(island) ? pieces : cut).Add(island);
        Hold(i, cut, below, carrying, pieces);
        level.Pieces = Region.Beside(pieces);
    }

    // Leaves of islands what is carried, stands on the part, or is where the roof of a tree spans what is between its tips.
    private void Hold(int i, List<Region> islands, Region below, Region carrying, List<Region> pieces)
    {
        var spanning = new List<Region>();
        foreach (var island in islands)
        {
            var held = island.Intersect([carrying.Cropped(island.Box)], _engine);
            if (held.Area >= island.Area - Film) pieces.Add(island);
            else if (_levels[i].Roofs.All(r => r.IsApartFrom(island))) pieces.Add(OnGround(i, island, held));
            else spanning.Add(island);
        }
        if (spanning.Count == 0) return;
        // A roof may lean out by a line over the level below, and spans what is between tips.
        var span = 0.75 * _settings.TreeTipDistance + _width;
        var spanned = below.Near(spanning.ConvertAll(r => r.Box), 2 * span)
            .Offset(span, JoinStyle.Round, 2, 2 * ArcTolerance, _engine).Offset(_width - span, JoinStyle.Round, 2, 2 * ArcTolerance, _engine);
        foreach (var island in spanning)
            pieces.Add(OnGround(i, island, island.Intersect([carrying.Cropped(island.Box), spanned.Cropped(island.Box)], _engine)));
    }

    // With what stands on the part.
    private Region OnGround(int i, Region island, Region held)
    {
        if (held.Area >= island.Area - Film) return island;
        if (_settings.SupportPlacement == SupportPlacement.Everywhere && Ground(i, island) is { Count: > 0 } ground)
            held = island.Intersect([held, .. ground], _engine);
        return Region.Beside(ThinParts.Thick(held, _thin, _engine).Islands.Where(o => o.Area > _width * _width));
    }

    // mm that extrusions may lean out over the level below; of branches, corners and sides differ from their circles, too.
    private double Lean(SupportLevel level)
        => _settings.Support == SupportKind.Grid ? level.Thickness
            : level.Thickness * Angle.Sin(_settings.TreeBranchAngle) / Angle.Cos(_settings.TreeBranchAngle) + 2 * TreeNode.Tolerance;

    // The surface of the part as far below a level as the gaps explain: at walls that are not upright, supports begin a bit above it.
    private List<Region> Ground(int i, Region island)
    {
        var ground = new List<Region>();
        var bottom = _levels[i].Top - _levels[i].Thickness;
        var from = stack.LevelBelow(bottom - _settings.SupportBottomGap);
        if (from < 0) return ground;
        var box = island.Box;
        for (var k = Math.Max(0, stack.LevelBelow(bottom - _settings.SupportBottomGap - _settings.SupportXyGap)); k <= from; k++)
        {
            var part = _levels[k].Part;
            if (!part.IsApartFrom(island)) ground.Add(part.Cropped(box));
        }
        return ground;
    }
}
