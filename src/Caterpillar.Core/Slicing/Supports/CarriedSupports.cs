namespace Caterpillar.Slicing;

/// <summary>Leaves of supports what is carried, from the bed up: what lies on the bed, on supports below, or (everywhere) closely above the part.</summary>
internal sealed class CarriedSupports(SupportStack stack)
{
    private const double ArcTolerance = 0.03;

    // mm²; less is rounding.
    private const double Film = 1e-3;
    private readonly PrintSettings _settings = stack.Settings;
    private readonly SupportLevel[] _levels = stack.Levels;
    private readonly double _width = stack.Settings.WidthOf(stack.Settings.SupportLineWidth, false);
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
            level.Pieces = ThinParts.Thick(level.Pieces, _width / 2, _engine);
            return;
        }
        if (level.Pieces.IsEmpty && level.Bundles.Count == 0) return;
        var (resting, loose) = Divide(i);
        var below = _levels[i - 1].Support;
        Region[] islands = [.. level.Pieces.Islands, .. loose.Select(b => b.Region)];
        // What is below, with what extrusions may lean out over it.
        var carrying = below.Near(Array.ConvertAll(islands, r => r.Box), 2 * Lean(level)).Offset(Lean(level), JoinStyle.Square, 2, ArcTolerance, _engine);
        var pieces = new List<Region>();
        var cut = new List<Region>();
        for (var k = 0; k < islands.Length; k++)
        {
            if (!carrying.Surrounds(islands[k])) cut.Add(islands[k]);
            else if (k < level.Pieces.Islands.Count) pieces.Add(islands[k]);
            else resting.Add(loose[k - level.Pieces.Islands.Count]);
        }
        Hold(i, cut, below, carrying, pieces);
        level.Pieces = Region.Beside(pieces);
        level.Bundles = resting;
    }

    // Leaves of islands what is carried, stands on the part, or is where the lattice of a tree spans what is between its tips.
    private void Hold(int i, List<Region> islands, Region below, Region carrying, List<Region> pieces)
    {
        var contact = SpannedContact(i);
        var spanning = new List<Region>();
        foreach (var island in islands)
        {
            var held = island.Intersect([carrying.Cropped(island.Box)], _engine);
            if (held.Area >= island.Area - Film) pieces.Add(island);
            else if (contact.IsApartFrom(island)) pieces.Add(OnGround(i, island, held));
            else spanning.Add(island);
        }
        if (spanning.Count == 0) return;
        var spanned = Spanned(contact, below, spanning.ConvertAll(r => r.Box));
        foreach (var island in spanning)
            pieces.Add(OnGround(i, island, island.Intersect([carrying.Cropped(island.Box), spanned.Cropped(island.Box)], _engine)));
    }

    // Bundles whose trunks all rest on those below, and the others.
    private (List<TrunkBundle> Resting, List<TrunkBundle> Loose) Divide(int i)
    {
        var below = _levels[i - 1].Bundles.SelectMany(b => b.Trunks).ToDictionary(t => t.Branch);
        var reach = Lean(_levels[i]);
        var rests = _levels[i].Bundles.ToLookup(b => b.Trunks.All(t => below.TryGetValue(t.Below, out var carrier) && t.RestsOn(carrier, reach)));
        return ([.. rests[true]], [.. rests[false]]);
    }

    // With what stands on the part.
    private Region OnGround(int i, Region island, Region held)
    {
        if (held.Area >= island.Area - Film) return island;
        if (_settings.SupportPlacement == SupportPlacement.Everywhere && Ground(i, island) is { Count: > 0 } ground)
            held = island.Intersect([held, .. ground], _engine);
        return ThinParts.Thick(held, _width / 2, _engine);
    }

    // The contact whose lattice is on a level.
    private Region SpannedContact(int i)
    {
        var held = _levels[i].Work.Index + _settings.SupportInterfaceLayers;
        return _settings.Support == SupportKind.Tree && _settings.SupportInterfaceLayers > 0 && held < _levels.Length ? _levels[held].Contact : Region.Empty;
    }

    private Region Spanned(Region contact, Region below, List<GridBox> places)
    {
        var span = 0.75 * _settings.TreeTipDistance;
        var roof = contact.Near(places, span).Offset(_width, JoinStyle.Miter, 2, 2 * ArcTolerance, _engine);
        var tips = below.Near(places, 2 * span).Intersect(roof, _engine);
        return tips.Offset(span, JoinStyle.Round, 2, 4 * ArcTolerance, _engine).Offset(-span, JoinStyle.Round, 2, 4 * ArcTolerance, _engine);
    }

    // mm that extrusions may lean out over the level below.
    private double Lean(SupportLevel level)
    {
        var angle = Math.Max(45, _settings.Support == SupportKind.Tree ? _settings.TreeBranchAngle : 0);
        return level.Thickness * Angle.Sin(angle) / Angle.Cos(angle);
    }

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
