namespace Caterpillar.Slicing;

/// <summary>The walls of an island as steps: the loops of each contour one after the other, in the order of the settings.</summary>
internal static class WallSteps
{
    public static void Add(LayerWork layer, IslandWork island, int number, RegionEngine engine, List<PathStep> steps, List<WallChain> chains)
    {
        var settings = island.Rules.Settings;
        var below = layer.BelowHanging(island.Region);
        var overhangs = below is null || settings.OverhangClasses.Count == 0 ? null : new OverhangSplitter(island.Rules, below, engine);
        // Where an extrusion touches the layer below at all: half of its width farther than its center line may lie.
        var held = below?.Offset(island.Rules.Walls.OuterWidth / 2, JoinStyle.Miter, 2, 0.01, engine);
        var air = held is null ? null : new LineClipper(held.Index, outside: true);
        var group = new StepGroup(layer.Number, number, StepRank.Walls);
        foreach (var wall in island.OverAir)
        {
            var path = wall.ToPath(layer.Plan.Top, island.Rules.Walls) with { Role = Role.InnerWall, Layer = layer.Layer };
            var rank = Math.Max(StepRank.OverAir, StepRank.Walls - wall.Index);
            steps.Add(new PathStep(island.Rules.Own(overhangs?.Split(path) ?? path), group with { Rank = rank }) { Region = island.Region });
        }
        for (var i = 0; i < island.Walls.Count; i++)
        {
            if (WallChains.IsLoop(island.Walls[i])) continue;
            var path = Path(layer, island.Rules, island.Walls[i], i);
            steps.Add(new PathStep(island.Rules.Own(overhangs?.Split(path) ?? path), group) { Region = island.Region });
        }
        foreach (var chain in WallChains.Find(island.Walls))
        {
            var hangsOver = false;
            var paths = new PrintPath[chain.Count];
            var supports = air is null ? null : new LoopSupport?[chain.Count];
            for (var i = 0; i < paths.Length; i++)
            {
                var path = Path(layer, island.Rules, island.Walls[chain[i]], chain[i]);
                var split = overhangs?.Split(path) ?? path;
                hangsOver |= !ReferenceEquals(split, path);
                paths[i] = island.Rules.Own(Slowed(split, settings));
                if (supports is not null && overhangs is not { IsSupported: true }) supports[i] = LoopSupport.Of(split.RawPoints, air!);
            }
            var outerFirst = WallChains.OuterFirst(settings, layer.Index, hangsOver);
            if (!outerFirst)
            {
                Array.Reverse(paths);
                if (supports is not null) Array.Reverse(supports);
            }
            chains.Add(new WallChain(steps.Count, paths.Length, outerFirst ? steps.Count : steps.Count + paths.Length - 1, supports));
            for (var i = 0; i < paths.Length; i++) steps.Add(new PathStep(paths[i], group) { Region = island.Region, Joined = i > 0 });
        }
    }

    private static PrintPath Path(LayerWork layer, SliceRules rules, WallPath wall, int number)
    {
        var settings = rules.Settings;
        if (settings.FuzzySkinThickness > 0 && wall is { Index: 0, Closed: true } && layer.Index > 0) wall = FuzzySkinThickness.Apply(wall, settings,
            layer.Number, number);
        var role = wall.Index == 0 ? Role.OuterWall : wall.IsExtrusion ? Role.GapFill : Role.InnerWall;
        return wall.ToPath(layer.Plan.Top, rules.Walls) with { Role = role, Layer = layer.Layer };
    }

    // Around small holes and pins there is little time to cool, and much acceleration.
    private static PrintPath Slowed(PrintPath path, PrintSettings settings)
    {
        var most = settings.SmallLoopSpeed;
        if (most == 0 || path.Length > 2 * Math.PI * settings.SmallLoopRadius || most >= settings.SpeedOf(path.Role, path.Layer!.Index == 0)) return path;
        return path.WithBeads(i => path.BeadOf(i).Speed is > 0 and var own && own <= most ? path.BeadOf(i) : path.BeadOf(i) with { Speed = most });
    }

    /// <summary>Contours that are printed as single walls.</summary>
    public static void AddOpen(LayerWork layer, List<PathStep> steps)
    {
        var width = layer.Rules.Walls.OuterWidth;
        var bead = layer.Rules.Bead(width);
        for (var i = 0; i < layer.OpenLines.Count; i++)
        {
            var line = layer.OpenLines[i];
            if (line.Count < 2 || line.Length < width) continue;
            var path = PrintPath.Own(Array.ConvertAll(line.Raw, p => p.WithZ(layer.Plan.Top)), [bead], line.IsClosed)
                with { Role = Role.OuterWall, Layer = layer.Layer };
            steps.Add(new PathStep(layer.Rules.Own(path), new StepGroup(layer.Number, layer.Islands.Length, StepRank.Walls)));
        }
    }
}
