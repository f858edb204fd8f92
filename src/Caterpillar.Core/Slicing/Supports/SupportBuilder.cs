using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;

namespace Caterpillar.Slicing;

/// <summary>
/// Finds where supports stand, in three passes: what hangs over (each level for itself); from the top down, where it has to be held; from the bottom up, what
/// of that is carried.
/// </summary>
internal sealed class SupportBuilder
{
    private const double ArcTolerance = 0.02;

    // mm; a step that is too wide by no more than twice this is not.
    private const double Least = 0.005;
    // mm; supports need not follow the part more closely.
    private const double Coarse = 0.06;
    // mm; overhangs less than twice this apart are held by one piece.
    private const double Joined = 1;
    // mm²; less is rounding.
    private const double Film = 1e-3;
    private readonly SupportStack _stack;
    private readonly PrintSettings _settings;
    private readonly SupportLevel[] _levels;
    private readonly ParallelOptions _options;
    private readonly double _width;

    private SupportBuilder(SupportStack stack, ParallelOptions options)
    {
        _stack = stack;
        _settings = stack.Settings;
        _levels = stack.Levels;
        _options = options;
        _width = _settings.LineWidth;
    }

    /// <summary>Fills the levels of a stack.</summary>
    /// <param name="stack">The bodies to support.</param>
    /// <param name="others">Layers of all other bodies, which supports keep away from.</param>
    /// <param name="blockers">Bodies in which nothing is supported.</param>
    /// <param name="enforcers">Bodies in which everything is.</param>
    /// <param name="options">Threads, and cancelling.</param>
    public static void Build(
        SupportStack stack, IReadOnlyList<LayerWork> others, IReadOnlyList<TriMesh> blockers, IReadOnlyList<TriMesh> enforcers, ParallelOptions options)
    {
        var builder = new SupportBuilder(stack, options);
        builder.FindOverhangs(builder.SectionsOf(blockers), builder.SectionsOf(enforcers));
        if (Array.TrueForAll(stack.Levels, l => l.Overhang.IsEmpty)) return;
        builder.Forbid(others);
        builder.FindContacts();
        if (builder._settings.Support == SupportKind.Tree) new TreeSupport(stack, options).Grow(builder.IsClear);
        else builder.Drop();
        builder.Carry();
        builder.FindInterfaces();
    }

    private Region[]? SectionsOf(IReadOnlyList<TriMesh> meshes)
    {
        if (meshes.Count == 0) return null;
        var mesh = TriMesh.Merge(meshes);
        // Part layers may have been lifted by a raft, which these bodies know nothing of.
        var lift = Raft.Lift(_settings);
        var heights = Array.ConvertAll(_levels, l => l.Top - lift - l.Thickness / 2);
        var sections = MeshSections.At(mesh, heights, new SectionOptions(), null, _options.CancellationToken).Value!;
        return sections.Select(s => Region.From(s.Loops)).ToArray();
    }

    private void FindOverhangs(Region[]? blockers, Region[]? enforcers) => Parallel.For(1, _levels.Length, _options, i =>
    {
        var (level, below) = (_levels[i], _levels[i - 1].Part);
        var engine = new RegionEngine();
        var reach = _settings.SupportAngle < 90 ? Math.Min(1000, level.Thickness * Angle.Sin(_settings.SupportAngle) / Angle.Cos(_settings.SupportAngle))
            : 1000;
        if (reach < 1000 && below.Surrounds(level.Part)) return;
        var step = level.Part.Subtract(below, engine);
        var overhang = below.IsEmpty && reach < 1000 ? level.Part : Region.Empty;
        if (reach < 1000 && !below.IsEmpty)
        {
            // What leans out too far, and all of the step that it is the edge of.
            var far = ThinParts.Thick(step.Subtract(below.Offset(reach, JoinStyle.Round, 2, ArcTolerance, engine), engine), Least, engine);
            if (!far.IsEmpty) overhang = far.Offset(reach + Least, JoinStyle.Round, 2, ArcTolerance, engine).Intersect(step, engine);
        }
        if (blockers is not null) overhang = overhang.Subtract(blockers[i], engine);
        if (enforcers is not null) overhang = overhang.Union(step.Intersect(enforcers[i], engine), engine);
        level.Overhang = overhang;
    });

    private void Forbid(IReadOnlyList<LayerWork> others) => Parallel.For(0, Array.FindLastIndex(_levels, l => !l.Overhang.IsEmpty), _options, i =>
    {
        var level = _levels[i];
        var near = others.Where(o => o.Plan.Top > level.Top - level.Thickness + 1e-9 && o.Plan.Top - o.Plan.Thickness < level.Top - 1e-9).Select(o => o.Region);
        level.Forbidden = Simple(Region.Union(near.Append(level.Part)), _settings.SupportXyGap, new RegionEngine());
    });

    // Moved outward by a distance and a bit, so that simplified outlines, also those of supports, are nowhere nearer.
    private static Region Simple(Region region, double distance, RegionEngine engine)
        => region.Offset(distance + 1.5 * Coarse, JoinStyle.Round, 2, Coarse / 2, engine).Simplified(Coarse / 2, engine);


    // Overhangs are held from the highest level that leaves the gap open.
    private void FindContacts()
    {
        var contacts = new List<Region>[_levels.Length];
        for (var i = 1; i < _levels.Length; i++)
        {
            if (_levels[i].Overhang.IsEmpty) continue;
            var at = _stack.LevelBelow(_levels[i].Top - _levels[i].Thickness - _settings.SupportTopGap);
            if (at >= 0) (contacts[at] ??= []).Add(_levels[i].Overhang);
        }
        Parallel.For(0, _levels.Length, _options, i =>
        {
            if (contacts[i] is { } list) _levels[i].Contact = JoinedPieces(Region.Union(list), new RegionEngine());
        });
    }

    // Many small pieces would be printed one by one, and fall over.
    private static Region JoinedPieces(Region pieces, RegionEngine engine)
        => pieces.Offset(Joined, JoinStyle.Round, 2, Coarse, engine).Offset(-Joined, JoinStyle.Miter, 2, Coarse, engine).Simplified(Coarse, engine);

    // Columns: from each overhang straight down until the part begins.
    private void Drop()
    {
        var engine = new RegionEngine();
        var needed = Region.Empty;
        for (var i = _levels.Length - 1; i >= 0; i--)
        {
            _options.CancellationToken.ThrowIfCancellationRequested();
            var level = _levels[i];
            if (!level.Contact.IsEmpty) needed = JoinedPieces(needed.Union(level.Contact, engine), engine);
            if (needed.IsEmpty) continue;
            needed = needed.Subtract(level.Part, engine).Simplified(Coarse, engine);
            level.Pieces = needed;
        }
    }

    // Away from the walls, and so far above and below the part that the gaps stay open.
    private Region Clear(int i, Region support, RegionEngine engine)
    {
        support = support.Subtract(_levels[i].Forbidden, engine);
        foreach (var part in PartsAround(i)) support = support.Subtract(part, engine);
        return support.Simplified(Coarse / 2, engine);
    }

    private bool IsClear(int i, Region support)
        => _levels[i].Forbidden.IsApartFrom(support) && PartsAround(i).All(p => p.IsApartFrom(support));

    // What the part covers within the gaps above and below a level.
    private IEnumerable<Region> PartsAround(int i)
    {
        var level = _levels[i];
        for (var k = i + 1; k < _levels.Length && _levels[k].Top - _levels[k].Thickness < level.Top + _settings.SupportTopGap - 1e-6; k++)
            yield return _levels[k].Part;
        for (var k = i - 1; k >= 0 && _levels[k].Top > level.Top - level.Thickness - _settings.SupportBottomGap + 1e-6; k--) yield return _levels[k].Part;
    }

    // From the bed up: only what lies on the bed, on supports below, or (everywhere) closely above the part.
    private void Carry()
    {
        Parallel.For(0, _levels.Length, _options, i =>
        {
            if (!_levels[i].Pieces.IsEmpty) _levels[i].Pieces = Clear(i, _levels[i].Pieces, new RegionEngine());
        });
        var engine = new RegionEngine();
        var below = Region.Empty;
        for (var i = 0; i < _levels.Length; i++)
        {
            _options.CancellationToken.ThrowIfCancellationRequested();
            var level = _levels[i];
            var kept = Region.Empty;
            var loose = Region.Empty;
            foreach (var island in level.Pieces.Islands)
            {
                if (i > 0 && below.Near(island.Box).Surrounds(island)) kept = kept.Beside(island);
                else loose = loose.Beside(island);
            }
            if (!loose.IsEmpty) level.Pieces = kept.Beside(Held(i, loose, below, engine));
            if (i > 0) KeepBundles(i, below, engine);
            below = level.Support;
        }
    }

    // Bundles that are carried as they are; what is left of others are pieces.
    private void KeepBundles(int i, Region below, RegionEngine engine)
    {
        var level = _levels[i];
        if (level.Bundles.Count == 0) return;
        var carrying = _levels[i - 1].Bundles.SelectMany(b => b.Trunks).ToDictionary(t => t.Branch);
        var kept = new List<TrunkBundle>();
        foreach (var bundle in level.Bundles)
        {
            var whole = bundle.Trunks.All(t => carrying.TryGetValue(t.Below, out var carrier) && t.RestsOn(carrier, Lean(level)));
            if (!whole)
            {
                var leaning = Leaning(level, below, bundle.Region.Box, engine);
                var held = OnGround(i, bundle.Region, bundle.Region.Intersect(leaning, engine), engine);
                whole = held.Area > bundle.Region.Area - Film;
                if (!whole) level.Pieces = level.Pieces.Beside(held);
            }
            if (whole) kept.Add(bundle);
        }
        level.Bundles = kept;
    }

    // What of some pieces is carried.
    private Region Held(int i, Region loose, Region below, RegionEngine engine)
    {
        if (i == 0) return ThinParts.Thick(loose, _width / 2, engine);
        var held = below.IsEmpty ? Region.Empty : loose.Intersect(Carried(_levels[i], below, loose.Box, engine), engine);
        return OnGround(i, loose, held, engine);
    }

    // With what stands on the part.
    private Region OnGround(int i, Region loose, Region held, RegionEngine engine)
    {
        if (_settings.SupportPlace == SupportPlace.Everywhere && held.Area < loose.Area - Film)
            held = held.Union(loose.Intersect(Ground(i, loose.Box, engine), engine), engine);
        return ThinParts.Thick(held, _width / 2, engine);
    }

    // What is below a level, as far as strands may lean out over it; the lattice of a tree also spans what is between its tips.
    private Region Carried(SupportLevel level, Region below, in GridBox place, RegionEngine engine)
    {
        var leaning = Leaning(level, below, place, engine);
        var held = level.Work.Index + _settings.SupportInterfaceLayers;
        if (_settings.Support != SupportKind.Tree || _settings.SupportInterfaceLayers == 0 || held >= _levels.Length) return leaning;
        var span = 0.75 * _settings.SupportTipDistance;
        var contact = _levels[held].Contact.Near(place.Grown(span));
        if (contact.IsEmpty) return leaning;
        var near = below.Near(place.Grown(2 * span)).Intersect(contact.Offset(_width, JoinStyle.Miter, 2, Coarse, engine), engine);
        var spanned = near.Offset(span, JoinStyle.Round, 2, 2 * Coarse, engine).Offset(-span, JoinStyle.Round, 2, 2 * Coarse, engine);
        return leaning.Union(spanned, engine);
    }

    private Region Leaning(SupportLevel level, Region below, in GridBox place, RegionEngine engine)
    {
        var lean = Lean(level);
        return below.Near(place.Grown(2 * lean)).Offset(lean, JoinStyle.Square, 2, Coarse / 2, engine);
    }

    // mm that strands may lean out over the level below.
    private double Lean(SupportLevel level)
    {
        var angle = Math.Max(45, _settings.Support == SupportKind.Tree ? _settings.SupportBranchAngle : 0);
        return level.Thickness * Angle.Sin(angle) / Angle.Cos(angle);
    }

    // The contacts that so many layers, of which this is the lowest, hold.
    private Region RoofOver(SupportLevel level, int layers, RegionEngine engine)
    {
        var roof = Region.Empty;
        for (var k = level.Work.Index; k < Math.Min(_levels.Length, level.Work.Index + layers); k++)
            roof = roof.Union(_levels[k].Contact, engine);
        return roof;
    }

    // The surface of the part as far below a level as the gaps explain: at walls that are not upright, supports begin a bit above it.
    private Region Ground(int i, in GridBox near, RegionEngine engine)
    {
        var bottom = _levels[i].Top - _levels[i].Thickness;
        var from = _stack.LevelBelow(bottom - _settings.SupportBottomGap);
        if (from < 0) return Region.Empty;
        var to = Math.Max(0, _stack.LevelBelow(bottom - _settings.SupportBottomGap - _settings.SupportXyGap));
        var ground = _levels[from].Part.Near(near);
        for (var k = to; k < from; k++)
        {
            var part = _levels[k].Part.Near(near);
            if (!ground.Surrounds(part)) ground = ground.Union(part, engine);
        }
        return ground;
    }

    private void FindInterfaces() => Parallel.For(0, _levels.Length, _options, i =>
    {
        var level = _levels[i];
        if (level.Pieces.IsEmpty) return;
        var engine = new RegionEngine();
        var contact = RoofOver(level, _settings.SupportInterfaceLayers, engine);
        if (_settings.Support == SupportKind.Grid && !contact.IsEmpty)
        {
            // So far that the dense lines reach a line or the wall of the grid below on all sides.
            var reach = _width * 50 / _settings.SupportPercent;
            contact = contact.Offset(Math.Min(reach, 10 * _width), JoinStyle.Miter, 2, Coarse, engine);
        }
        level.Interface = ThinParts.Thick(contact.Intersect(level.Pieces.Near(contact.Box), engine), _width / 2, engine);
        if (_settings.Support != SupportKind.Tree) return;
        var roof = RoofOver(level, TreeSupport.RoofLayers(_settings), engine);
        level.Lattice = roof.Intersect(level.Pieces.Near(roof.Box), engine).Subtract(level.Interface, engine);
    });
}
