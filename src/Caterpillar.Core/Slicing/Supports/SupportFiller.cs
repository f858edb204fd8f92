namespace Caterpillar.Slicing;

/// <summary>
/// The extrusions of the supports of a level: a wall around each piece and lines in it. Near the part there are dense lines across them instead, which rest on
/// the walls below.
/// </summary>
internal sealed class SupportFiller(SupportLevel level, PrintSettings settings, LayerTools tools)
{
    // Islands of supports are numbered after those of the part.
    private const int FirstIsland = 1_000_000;
    private const double ArcTolerance = 0.02;

    // mm; nobody sees how closely supports follow their outline.
    private const double Coarse = 0.03;

    // mm; so far from supports nothing is retracted.
    private const double Threads = 15;

    private readonly RegionEngine _engine = tools.Engine;
    private readonly SliceRules _rules = level.Work.Rules;
    private readonly double _width = level.Work.Rules.SupportWidth;

    // Where a support is thin, a single extrusion: two walls would lie in each other's place.
    private readonly WallBuilder _walls = new(Walls(level.Work.Rules), tools.Engine, tools.Strips);
    private readonly List<PathStep> _steps = [];

    // Where the nozzle goes from support to support without retraction: threads do no harm there.
    private Region _reach = Region.Empty;

    private static WallRules Walls(SliceRules rules) => rules.Walls with
    {
        Count = 1, VariableWidth = true, Tolerance = Coarse, OuterWidth = rules.SupportWidth, InnerWidth = rules.SupportWidth,
    };

    /// <summary>The steps that print the supports.</summary>
    public List<PathStep> Fill()
    {
        // Grown by a part of it, nothing is so small any more that a coarse outline loses it.
        var near = level.Pieces.Simplified(Threads / 50, _engine).Offset(Threads / 5, JoinStyle.Round, 2, Threads / 50, _engine);
        var coarse = near.Simplified(Threads / 20, _engine);
        _reach = coarse.Offset(Threads - Threads / 5, JoinStyle.Round, 2, Threads / 10, _engine).Subtract(level.Forbidden, _engine);
        var (islands, reaches) = (level.Pieces.Islands, _reach.Islands.ToList());
        for (var i = 0; i < islands.Count; i++)
        {
            // All branches that are reached without a retraction are printed in one go.
            var number = settings.Support == SupportKind.Grid ? i : reaches.FindIndex(r => islands[i].Contours[0].Raw.Any(p => r.Contains(p.X, p.Y)));
            Add(islands[i], FirstIsland + number);
        }
        return _steps;
    }

    private void Add(Region island, int number)
    {
        var piece = new Piece(_reach, number);
        var near = ThinParts.Thick(island.Intersect(level.Interface.Cropped(island.Box), _engine), _width / 2, _engine);
        var dense = Dense(near, piece);
        if (!dense.IsEmpty && Inset(island.Subtract(dense, _engine), _width / 2).IsEmpty) return;
        var isGrid = settings.Support == SupportKind.Grid;
        var lattice = level.Roofs.Select(r => r.Cropped(island.Box)).Where(r => !r.IsEmpty).ToArray();
        var walls = _walls.Outline(island, isGrid || lattice.Length > 0);
        var role = near.Area > island.Area / 2 ? Role.SupportInterface : Role.Support;
        foreach (var wall in walls.Paths) AddWall(wall.ToPath(level.Top, _rules.Walls), piece, role, dense);
        if (isGrid)
        {
            var spacing = _rules.Pitch(_width) * 100 / settings.SupportDensityPercent;
            AddLines(piece, Inset(walls.Inside.Subtract(dense, _engine), _width / 4), Role.Support, 1, spacing, 0, linked: true);
        }
        else if (!walls.Inside.IsEmpty)
        {
            // Rows over the tips, which stand in the same places.
            var area = Inset(walls.Inside.Subtract(near, _engine).Intersect(lattice, _engine), _width / 4);
            AddLines(piece, area, Role.Support, 1, settings.TreeTipDistance, 0, linked: false);
        }
    }

    // Lines in all places that are wide enough for some; returns those.
    private Region Dense(Region near, Piece piece)
    {
        var filled = Region.Empty;
        var spacing = _rules.Pitch(_width) * 100 / settings.SupportInterfaceDensityPercent;
        // Lines may miss the narrow roofs that trees have on slopes.
        if (settings.Support == SupportKind.Tree) near = ThinParts.Thick(near, (_width + spacing) / 2, _engine);
        foreach (var place in near.Islands)
        {
            var area = Inset(place, _width / 2);
            if (area.IsEmpty || Inset(area, _width / 4).IsEmpty) continue;
            // Links at the edge of the roof of a tree would touch what it holds; those of a grid lie beside it.
            AddLines(piece, area, Role.SupportInterface, 2, spacing, 90, linked: settings.Support == SupportKind.Grid);
            filled = filled.Union(place, _engine);
        }
        return filled;
    }

    // Without what is in the place of dense lines.
    private void AddWall(PrintPath path, Piece piece, Role role, Region dense)
    {
        if (dense.IsEmpty || path.OnlyBead is not { } bead)
        {
            Add(path, piece, role, 0);
            return;
        }
        foreach (var part in dense.ClipLines([new Polyline(path.RawPoints, path.IsClosed)], outside: true))
        {
            if (part.Length >= _width) Add(PrintPath.Own(Array.ConvertAll(part.Raw, p => p.WithZ(level.Top)), [bead], part.IsClosed), piece, role, 0);
        }
    }

    private void AddLines(Piece piece, Region area, Role role, int rank, double spacing, double angle, bool linked)
    {
        if (area.IsEmpty) return;
        var request = new InfillRequest(area, InfillPattern.Lines, spacing, _width)
        {
            Angle = angle, Z = level.Top, Layer = level.Work.Index, Linked = linked,
        };
        foreach (var found in tools.Infill.Fill(request))
        {
            if (found.Points.Length > 1) Add(PrintPath.Own(found.Points, [_rules.Bead(_width)], found.Closed), piece, role, rank);
        }
    }

    private void Add(PrintPath path, Piece piece, Role role, int rank)
    {
        path = path with { Role = role, Layer = level.Work.Layer, Tool = settings.ToolOf(role, _rules.Top) };
        _steps.Add(new PathStep(path, new StepGroup(level.Work.Number, piece.Number, rank)) { Region = piece.Region });
    }

    private Region Inset(Region region, double distance) => region.Offset(-distance, JoinStyle.Miter, 2, ArcTolerance, _engine);

    // A connected piece of the supports, and its number among the islands of the layer.
    private readonly record struct Piece(Region Region, int Number);
}
