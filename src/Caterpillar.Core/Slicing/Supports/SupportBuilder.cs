namespace Caterpillar.Slicing;

/// <summary>
/// Finds where supports stand, in three passes: what hangs over (each level for itself); from the top down, where it has to be held; from the bottom up, what
/// of that is carried.
/// </summary>
internal sealed class SupportBuilder(SupportStack stack, ParallelOptions options)
{
    private const double ArcTolerance = 0.02;

    // mm; a step that is too wide by no more than twice this is not.
    private const double Least = 0.005;
    // mm; supports need not follow the part more closely.
    private const double Coarse = 0.06;
    // mm; overhangs less than twice this apart are held by one piece.
    private const double Joined = 1;
    private readonly PrintSettings _settings = stack.Settings;
    private readonly SupportLevel[] _levels = stack.Levels;
    private readonly double _width = stack.LineWidth;

    /// <summary>Fills the levels of the stack.</summary>
    /// <param name="others">Layers of all other bodies, which supports keep away from.</param>
    /// <param name="blockers">Bodies in which nothing is supported.</param>
    /// <param name="enforcers">Bodies in which everything is.</param>
    public void Build(IReadOnlyList<LayerWork> others, IReadOnlyList<TriMesh> blockers, IReadOnlyList<TriMesh> enforcers)
    {
        FindOverhangs();
        if (_settings.SupportRemoveSmallOverhang) SmallOverhangs.Remove(_levels, _width, options.CancellationToken);
        Apply(SectionsOf(blockers), SectionsOf(enforcers));
        if (Array.TrueForAll(_levels, l => l.Overhang.IsEmpty)) return;
        var gaps = new SupportGaps(stack);
        gaps.Find(Array.FindLastIndex(_levels, l => !l.Overhang.IsEmpty), others, options);
        FindContacts();
        var carried = new CarriedSupports(stack);
        if (_settings.Support == SupportKind.Tree) new TreeSupport(stack, gaps, options).Grow(carried);
        else Drop(gaps);
        carried.Keep(options.CancellationToken);
        FindInterfaces();
    }

    private Region[]? SectionsOf(IReadOnlyList<TriMesh> meshes)
    {
        if (meshes.Count == 0) return null;
        var mesh = TriMesh.Merge(meshes);
        // Part layers may have been lifted by a raft, which these bodies know nothing of.
        var lift = Raft.Lift(_settings);
        var heights = Array.ConvertAll(_levels, l => l.Top - lift - l.Thickness / 2);
        var sections = MeshSections.At(mesh, heights, new SectionOptions(), null, options.CancellationToken).Value!;
        return sections.Select(s => Region.From(s.Loops)).ToArray();
    }

    private void FindOverhangs() => RegionEngine.ForEach(1, _levels.Length, options, (i, engine) =>
    {
        var (level, below) = (_levels[i], _levels[i - 1].Part);
        var reach = _settings.SupportAngle < 90 ? Math.Min(1000, level.Thickness * Angle.Sin(_settings.SupportAngle) / Angle.Cos(_settings.SupportAngle))
            : 1000;
        if (reach == 1000 || below.Surrounds(level.Part)) return;
        level.Overhang = below.IsEmpty ? level.Part : WithoutBridges(LeaningOut(level.Part, below, reach, engine), level.Part, below, engine);
    });

    private void Apply(Region[]? blockers, Region[]? enforcers) => RegionEngine.ForEach(1, _levels.Length, options, (i, engine) =>
    {
        var (level, overhang) = (_levels[i], _levels[i].Overhang);
        if (blockers is not null) overhang = overhang.Subtract(blockers[i], engine);
        if (enforcers is not null) overhang = overhang.Union(level.Part.Subtract(_levels[i - 1].Part, engine).Intersect(enforcers[i], engine), engine);
        level.Overhang = overhang;
    });

    // What leans out farther than a distance over what is below, and all of the step that it is the edge of.
    private static Region LeaningOut(Region part, Region below, double reach, RegionEngine engine)
    {
        var held = below.Offset(reach, JoinStyle.Round, 2, ArcTolerance, engine);
        if (held.Surrounds(part)) return Region.Empty;
        var far = ThinParts.Thick(part.Subtract(held, engine), Least, engine);
        if (far.IsEmpty) return far;
        var near = far.Offset(reach + Least, JoinStyle.Round, 2, ArcTolerance, engine);
        return near.Intersect([part.Cropped(near.Box)], engine).Subtract(below.Cropped(near.Box), engine);
    }

    private Region WithoutBridges(Region overhang, Region part, Region below, RegionEngine engine)
    {
        if (!_settings.Bridges || _settings.MaxBridgeLength == 0 || overhang.IsEmpty) return overhang;
        var islands = overhang.Islands;
        var left = islands.Where(o => !BridgeFinder.Holds(o, part, below, _width, _settings.MaxBridgeLength, engine)).ToArray();
        return left.Length == islands.Count ? overhang : Region.Own([.. left.SelectMany(o => o.Paths)]);
    }

    // Overhangs are held from the highest level that leaves the gap open.
    private void FindContacts()
    {
        var contacts = new List<Region>[_levels.Length];
        for (var i = 1; i < _levels.Length; i++)
        {
            if (_levels[i].Overhang.IsEmpty) continue;
            var at = stack.LevelBelow(_levels[i].Top - _levels[i].Thickness - _settings.SupportTopGap);
            if (at >= 0) (contacts[at] ??= []).Add(_levels[i].Overhang);
        }
        RegionEngine.ForEach(0, _levels.Length, options, (i, engine) =>
        {
            if (contacts[i] is { } list) _levels[i].Contact = JoinedPieces(Region.Union(list, engine), engine);
        });
    }

    // Many small pieces would be printed one by one, and fall over.
    private static Region JoinedPieces(Region pieces, RegionEngine engine)
        => pieces.Offset(Joined, JoinStyle.Round, 2, Coarse, engine).Offset(-Joined, JoinStyle.Miter, 2, Coarse, engine).Simplified(Coarse, engine);

    // Columns: from each overhang straight down until the part begins.
    private void Drop(SupportGaps gaps)
    {
        var engine = new RegionEngine();
        var needed = Region.Empty;
        for (var i = _levels.Length - 1; i >= 0; i--)
        {
            options.CancellationToken.ThrowIfCancellationRequested();
            var level = _levels[i];
            if (!level.Contact.IsEmpty) needed = JoinedPieces(needed.Union(level.Contact, engine), engine);
            if (needed.IsEmpty) continue;
            needed = needed.Subtract(level.Part, engine).Simplified(Coarse, engine);
            level.Pieces = needed;
        }
        RegionEngine.ForEach(0, _levels.Length, options, (i, clipper) =>
        {
            if (!_levels[i].Pieces.IsEmpty) _levels[i].Pieces = gaps.Clear(i, [_levels[i].Pieces], clipper);
        });
    }

    private void FindInterfaces() => RegionEngine.ForEach(0, _levels.Length, options, (i, engine) =>
    {
        var level = _levels[i];
        if (level.Pieces.IsEmpty) return;
        // In a grid so far that the dense lines reach a line or the wall of it below on all sides; else so little that outlines, which are the same but for
        // tolerances, do not cross all along.
        var reach = _settings.Support == SupportKind.Grid ? Math.Min(_width * 50 / _settings.SupportDensityPercent, 10 * _width) : Coarse / 2;
        level.Interface = Region.Union(stack.ContactsOver(i, _settings.SupportInterfaceLayers), engine).Offset(reach, JoinStyle.Miter, 2, Coarse, engine);
    });
}
