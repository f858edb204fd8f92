namespace Caterpillar.Slicing;

/// <summary>Fills the areas of one island, or of a part of it that has settings of its own.</summary>
internal sealed class AreaFiller(LayerWork layer, IslandWork island, SliceRules rules, int number, LayerTools tools, List<PathStep> steps)
{
    private const double ArcTolerance = 0.005;

    // mm; a tenth of an extrusion. Arcs need points that lie nearer to them.
    private const double UsualChords = 0.04;
    private readonly PrintSettings _settings = rules.Settings;

    /// <summary>Adds the steps.</summary>
    /// <param name="areas">Areas by their fill.</param>
    /// <param name="thick">Part of the infill that is printed here for several layers at once, or left to a layer above.</param>
    public void Fill(IslandAreas areas, ThickInfill thick)
    {
        var angle = _settings.SolidInfillAngle + (layer.Index % 2 == 0 ? 0 : 90);
        foreach (var bridge in areas.Bridges) Solid(bridge.Area, Role.Bridge, InfillPattern.Lines, bridge.Angle, StepRank.Bottom);
        Solid(areas.Bottom, Role.BottomSurface, _settings.BottomPattern, angle, StepRank.Bottom);
        var solid = areas.Solid;
        foreach (var bridge in InfillBridges.Find(layer, rules, areas.Solid, tools.Engine))
        {
            Solid(bridge.Area, Role.Bridge, InfillPattern.Lines, bridge.Angle, StepRank.Solid, overInfill: true);
            solid = solid.Subtract(bridge.Area, tools.Engine);
        }
        Solid(solid, Role.SolidInfill, InfillPattern.Lines, angle, StepRank.Solid);
        Solid(areas.Top, Role.TopSurface, _settings.TopPattern, angle, StepRank.Top);
        if (_settings.Ironing) Iron(areas.Top, angle);
        if (thick.Area.IsEmpty)
        {
            Sparse(areas.Sparse, rules.Thickness);
            return;
        }
        Sparse(areas.Sparse.Subtract(thick.Area, tools.Engine), rules.Thickness);
        if (thick.Thickness > 0) Sparse(areas.Sparse.Intersect(thick.Area, tools.Engine), thick.Thickness);
    }

    private void Sparse(Region area, double thickness)
    {
        if (area.IsEmpty || rules.InfillSpacing <= 0) return;
        var angle = rules.InfillAngle(layer.Index);
        var rank = _settings.InfillFirst ? StepRank.EarlyInfill : StepRank.Infill;
        if (rules.IsSolid && thickness == rules.Thickness)
        {
            // Trees leave most of an area open.
            var closing = _settings.InfillPattern == InfillPattern.Lightning ? InfillPattern.Lines : _settings.InfillPattern;
            Solid(area, Role.SolidInfill, closing, angle, rank);
            return;
        }
        var thick = thickness == rules.Thickness ? rules : rules with { Walls = WallRules.Of(_settings, thickness, rules.First), Thickness = thickness };
        var pattern = layer.Body.InfillLines is null ? _settings.InfillPattern : InfillPattern.Curves;
        var request = Request(area, pattern, rules.InfillSpacing, rules.InfillWidth, angle, solid: false);
        Add(tools.Infill.Fill(request), thick.Bead(rules.InfillWidth), Role.Infill, rank);
    }

    private void Solid(Region area, Role role, InfillPattern pattern, double angle, int rank, bool overInfill = false)
    {
        if (role == Role.SolidInfill && pattern == InfillPattern.Lines) area = NarrowParts(area, rank);
        if (area.IsEmpty) return;
        var width = role == Role.TopSurface ? rules.TopWidth : rules.SolidWidth;
        var bead = overInfill ? rules.Bead(width) with { Speed = _settings.InfillBridgeSpeed } : rules.Bead(width);
        var share = overInfill ? _settings.InfillBridgeFlowRatio : role == Role.Bridge ? _settings.BridgeFlowRatio : 1;
        var request = Request(area, pattern, rules.Pitch(width), width, angle, solid: true);
        var isInside = role == Role.SolidInfill && !rules.IsSolid;
        // Bridges hang from the walls below.
        var lines = tools.Infill.Fill(request with { Hidden = isInside || role == Role.Bridge, Early = isInside ? request.Spacing / 2 : 0 });
        // Rows between walls know what each of them has to fill.
        var rows = pattern is InfillPattern.Lines or InfillPattern.Monotonic && _settings.WallCount > 0;
        var flow = rows ? share : Balance(lines, area.Area * rules.Thickness, bead) * share;
        Add(lines, bead with { Area = bead.Area * flow }, role, rank);
    }

    // Narrow pieces are filled along their outline: lines across them would be short, and all corners. Returns the others.
    private Region NarrowParts(Region area, int rank)
    {
        var half = _settings.NarrowSolidInfill / 2;
        if (half <= 0 || area.IsEmpty || !rules.Walls.VariableWidth) return area;
        List<GridPoint[]> wide = [], narrow = [];
        foreach (var piece in area.Islands)
            (piece.Offset(-half, JoinStyle.Miter, 2, ArcTolerance, tools.Engine).IsEmpty ? narrow : wide).AddRange(piece.Paths);
        if (narrow.Count == 0) return area;
        var group = new StepGroup(layer.Number, number, rank);
        var walls = rules.Walls with { InnerWidth = rules.SolidWidth };
        // The corners that walls have rounded are sharp again, so that rounds from both sides meet everywhere. Chords lie inside their arc.
        var round = 1.4 * (walls.OuterSpacing / 2 + (walls.Count - 1) * rules.Walls.InnerSpacing);
        var pieces = Region.Own(narrow.ToArray()).Simplified(walls.InnerTolerance, tools.Engine);
        if (walls.Corners == JoinStyle.Round) pieces = Pointed(Pointed(pieces, round), -round).Intersect(pieces, tools.Engine);
        foreach (var wall in new WallBuilder(walls, tools.Engine, tools.Strips).Fill(pieces, first: 1).Paths)
        {
            var path = wall.ToPath(layer.Plan.Top, walls) with { Role = Role.SolidInfill, Layer = layer.Layer };
            steps.Add(new PathStep(rules.Own(path), group) { Region = island.Region });
        }
        return Region.Own(wide.ToArray());
    }

    private Region Pointed(Region area, double distance) => area.Offset(distance, JoinStyle.Miter, ThinParts.MiterLimit, ArcTolerance, tools.Engine);

    // The nozzle goes over the top surface at its height. Its lines stay inside, so that the edge stays sharp.
    private void Iron(Region top, double angle)
    {
        if (top.IsEmpty || !(_settings.IroningFlowPercent > 0)) return;
        var area = top.Offset(-rules.TopWidth / 2, JoinStyle.Miter, 2, ArcTolerance, tools.Engine);
        var request = new InfillRequest(area, InfillPattern.Monotonic, _settings.IroningSpacing, _settings.IroningSpacing)
        {
            Angle = angle + 90, Z = layer.Plan.Top, Layer = layer.Index,
        };
        var bead = new Bead(_settings.IroningSpacing * rules.Thickness * _settings.IroningFlowPercent / 100, rules.Thickness);
        Add(tools.Infill.Fill(request), bead, Role.Ironing, StepRank.Ironing);
    }

    // Center lines keep half a pitch from the edge of the area, less the overlap.
    private InfillRequest Request(Region area, InfillPattern pattern, double spacing, double width, double angle, bool solid)
        => new(CenterLines(area, rules, width, solid ? rules.SolidOverlap : rules.Overlap, tools.Engine), pattern, spacing, width)
        {
            Overlap = solid ? rules.SolidOverlap : 0, LongestLink = solid ? 0 : _settings.InfillAnchorMax, Anchor = solid ? 0 : _settings.InfillAnchor,
            Chords = _settings.ArcFittingTolerance > 0 ? Math.Min(UsualChords, _settings.ArcFittingTolerance / 4) : UsualChords,
            Angle = angle, Z = layer.Plan.Top, Layer = layer.Index, Solid = solid, Linked = pattern != InfillPattern.Curves, Formula = rules.InfillFormula,
            Curves = pattern switch
            {
                InfillPattern.Lightning => LightningPlan.TreesOf(layer.Body)[layer.Index],
                InfillPattern.Curves => layer.Body.InfillLines?.Invoke(layer.Plan.Top) ?? rules.InfillCurves,
                _ => null,
            },
        };

    /// <summary>Where the center lines of extrusions that fill an area may run.</summary>
    public static Region CenterLines(Region area, SliceRules rules, double width, double overlap, RegionEngine engine)
    {
        var inset = rules.Settings.WallCount == 0 ? 0 : rules.Pitch(width) / 2 - overlap;
        return inset == 0 ? area : area.Offset(-inset, JoinStyle.Miter, 2, ArcTolerance, engine);
    }

    // The factor with which the lines hold exactly the volume of their area, whatever their number, their links and their overlap with the walls.
    private static double Balance(IReadOnlyList<InfillLine> lines, double volume, Bead bead)
    {
        const double Most = 1.25;
        var sum = 0.0;
        foreach (var line in lines) sum += line.Length;
        return sum > 0 ? Math.Min(Most, Math.Max(1 / Most, volume / (sum * bead.Area))) : 1;
    }

    private void Add(IReadOnlyList<InfillLine> lines, Bead bead, Role role, int rank)
    {
        var fan = role == Role.Bridge && _settings.BridgeFanSpeedPercent > 0 ? new PathOverrides(Fan: _settings.BridgeFanSpeedPercent / 100) : null;
        // What a pattern has put into order stays so.
        var keep = role == Role.Ironing || (role == Role.TopSurface && _settings.TopPattern == InfillPattern.Monotonic);
        foreach (var line in lines)
        {
            if (line.Points.Length < 2) continue;
            Bead[] beads;
            if (line.Flow is null)
            {
                beads = [bead];
            }
            else
            {
                beads = new Bead[line.Flow.Length];
                for (var i = 0; i < beads.Length; i++) beads[i] = bead with { Area = bead.Area * line.Flow[i] };
            }
            var path = PrintPath.Own(line.Points, beads, line.Closed) with { Role = role, Layer = layer.Layer, Overrides = fan };
            steps.Add(new PathStep(rules.Own(path), new StepGroup(layer.Number, number, keep ? rank++ : rank)) { Region = island.Region, KeepStart = keep });
        }
    }
}
