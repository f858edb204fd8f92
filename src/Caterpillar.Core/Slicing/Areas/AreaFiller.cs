using System;
using System.Collections.Generic;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>Fills the areas of one island.</summary>
internal sealed class AreaFiller(LayerWork layer, IslandWork island, int number, LayerTools tools, List<PathStep> steps)
{
    private const double ArcTolerance = 0.005;
    private readonly SliceRules _rules = layer.Rules;
    private readonly PrintSettings _settings = layer.Rules.Settings;

    public void Fill(IslandAreas areas)
    {
        var turned = layer.Index % 2 == 0 ? 0 : 90;
        var skin = _settings.SkinAngle + turned;
        foreach (var bridge in areas.Bridges) Solid(bridge.Area, Role.Bridge, InfillPattern.Lines, bridge.Angle, StepRank.Bottom);
        Solid(areas.Bottom, Role.BottomSkin, _settings.BottomPattern, skin, StepRank.Bottom);
        Solid(areas.Solid, Role.SolidInfill, InfillPattern.Lines, skin, StepRank.Solid);
        Solid(areas.Top, Role.TopSkin, _settings.TopPattern, skin, StepRank.Top);
        Sparse(areas.Sparse);
    }

    private void Sparse(Region area)
    {
        if (area.IsEmpty || _rules.InfillSpacing <= 0) return;
        var angle = _settings.InfillAngle + layer.Index * _settings.InfillTurn;
        if (_rules.IsSolid)
        {
            Solid(area, Role.SolidInfill, _settings.InfillPattern, angle, StepRank.Infill);
            return;
        }
        var request = Request(area, _settings.InfillPattern, _rules.InfillSpacing, _rules.Width, angle, solid: false);
        Add(tools.Infill.Fill(request), _rules.Bead(_rules.Width), 1, Role.Infill, StepRank.Infill);
    }

    private void Solid(Region area, Role role, InfillPattern pattern, double angle, int rank)
    {
        if (area.IsEmpty) return;
        var width = role == Role.SolidInfill ? _rules.Width : _rules.SkinWidth;
        var bead = _rules.Bead(width);
        if (role == Role.Bridge) bead = bead.WithArea(bead.Area * _settings.BridgeFlow);
        var lines = tools.Infill.Fill(Request(area, pattern, _rules.Pitch(width), width, angle, solid: true));
        Add(lines, bead, Balance(lines, area.Area * _rules.Thickness, _rules.Bead(width)), role, rank);
    }

    // Center lines keep half a pitch from the edge of the area, less the overlap.
    private InfillRequest Request(Region area, InfillPattern pattern, double spacing, double width, double angle, bool solid)
    {
        var inset = _settings.WallCount == 0 ? 0 : _rules.Pitch(width) / 2 - _rules.Overlap;
        var lines = inset == 0 ? area : area.Offset(-inset, JoinStyle.Miter, 2, ArcTolerance, tools.Engine);
        return new InfillRequest(lines, pattern, spacing, width) { Angle = angle, Z = layer.Plan.Top, Layer = layer.Index, Solid = solid };
    }

    // The factor with which the lines hold exactly the volume of their area, whatever their number, their links and their overlap with the walls.
    private static double Balance(IReadOnlyList<InfillLine> lines, double volume, Bead bead)
    {
        const double Most = 1.25;
        var sum = 0.0;
        foreach (var line in lines) sum += line.Length;
        return sum > 0 ? Math.Min(Most, Math.Max(1 / Most, volume / (sum * bead.Area))) : 1;
    }

    private void Add(IReadOnlyList<InfillLine> lines, Bead bead, double flow, Role role, int rank)
    {
        foreach (var line in lines)
        {
            if (line.Points.Length < 2) continue;
            Bead[] beads;
            if (line.Flow is null)
            {
                beads = [bead.WithArea(bead.Area * flow)];
            }
            else
            {
                beads = new Bead[line.Flow.Length];
                for (var i = 0; i < beads.Length; i++) beads[i] = bead.WithArea(bead.Area * flow * line.Flow[i]);
            }
            var path = PrintPath.Own(line.Points, beads, line.Closed).With(role, layer.Layer);
            steps.Add(new PathStep(path, new StepGroup(layer.Number, number, rank)) { Region = island.Region });
        }
    }
}
