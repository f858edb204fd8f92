using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>The strands of the supports of a level.</summary>
internal static class SupportFiller
{
    // Islands of supports are numbered after those of the part.
    private const int FirstIsland = 1_000_000;
    private const double ArcTolerance = 0.02;

    // mm; nobody sees how closely supports follow their outline.
    private const double Coarse = 0.03;

    /// <summary>
    /// Adds the steps: a wall around each piece and lines in it. Near the part there are dense lines across them instead, which rest on the walls below.
    /// </summary>
    public static void Add(SupportLevel level, PrintSettings settings, LayerTools tools, List<PathStep> steps)
    {
        var engine = tools.Engine;
        var (rules, width) = (level.Work.Rules, settings.LineWidth);
        // Where a support is thin, a single strand: two walls would lie in each other's place.
        var builder = new WallBuilder(rules.Walls with { Count = 1, VariableWidth = true, Tolerance = Coarse }, engine);
        var islands = level.Pieces.Islands;
        for (var i = 0; i < level.Bundles.Count; i++)
        {
            var bundle = level.Bundles[i];
            var line = new SupportLine(level, bundle.Region, FirstIsland + islands.Count + i, steps);
            if (bundle.Trunks.Count > 1)
            {
                foreach (var wall in builder.Outline(bundle.Region, false).Paths) line.Add(wall.ToPath(level.Top, rules.Walls), Role.Support, 0);
                continue;
            }
            var ring = Array.ConvertAll(bundle.Trunks[0].Ring(width / 2), p => p.WithZ(level.Top));
            line.Add(PrintPath.Own(ring, [rules.Bead(width)], closed: true), Role.Support, 0);
        }
        for (var i = 0; i < islands.Count; i++)
        {
            var island = islands[i];
            var line = new SupportLine(level, island, FirstIsland + i, steps);
            var near = ThinParts.Thick(island.Intersect(level.Interface.Cropped(island.Box), engine), width / 2, engine);
            var dense = Dense(near);
            if (!dense.IsEmpty && Inset(island.Subtract(dense, engine), width / 2).IsEmpty) continue;
            var lattice = level.Lattice.Select(r => r.Cropped(island.Box)).Where(r => !r.IsEmpty).ToArray();
            var walls = builder.Outline(island, settings.Support == SupportKind.Grid || lattice.Length > 0);
            var role = near.Area > island.Area / 2 ? Role.SupportInterface : Role.Support;
            foreach (var wall in walls.Paths) Wall(wall.ToPath(level.Top, rules.Walls), role);
            if (settings.Support == SupportKind.Grid)
                Fill(Inset(walls.Inside.Subtract(dense, engine), width / 4), rules.Pitch(width) * 100 / settings.SupportPercent, 0, true, Role.Support, 1);
            // Rows over the tips, which stand in the same places.
            else if (!walls.Inside.IsEmpty)
                Fill(Inset(walls.Inside.Subtract(near, engine).Intersect(lattice, engine), width / 4), settings.SupportTipDistance, 0, false, Role.Support, 1);

            // Lines in all pieces that are wide enough for some.
            Region Dense(Region near)
            {
                var filled = Region.Empty;
                foreach (var piece in near.Islands)
                {
                    var area = Inset(piece, width / 2);
                    if (area.IsEmpty || Inset(area, width / 4).IsEmpty) continue;
                    Fill(area, rules.Pitch(width) * 100 / settings.SupportInterfacePercent, 90, true, Role.SupportInterface, 2);
                    filled = filled.Union(piece, engine);
                }
                return filled;
            }

            // Without what is in the place of dense lines.
            void Wall(PrintPath path, Role role)
            {
                if (dense.IsEmpty || path.OnlyBead is not { } bead)
                {
                    line.Add(path, role, 0);
                    return;
                }
                foreach (var piece in dense.ClipLines([new Polyline(path.RawPoints, path.IsClosed)], outside: true))
                {
                    if (piece.Length >= width) line.Add(PrintPath.Own(Array.ConvertAll(piece.Raw, p => p.WithZ(level.Top)), [bead], piece.IsClosed), role, 0);
                }
            }

            void Fill(Region area, double spacing, double angle, bool linked, Role role, int rank)
            {
                if (area.IsEmpty) return;
                var request = new InfillRequest(area, InfillPattern.Lines, spacing, width)
                {
                    Angle = angle, Z = level.Top, Layer = level.Work.Index, Linked = linked,
                };
                foreach (var found in tools.Infill.Fill(request))
                {
                    if (found.Points.Length > 1) line.Add(PrintPath.Own(found.Points, [rules.Bead(width)], found.Closed), role, rank);
                }
            }
        }

        Region Inset(Region region, double distance) => region.Offset(-distance, JoinStyle.Miter, 2, ArcTolerance, engine);
    }

    private readonly record struct SupportLine(SupportLevel Level, Region Island, int Number, List<PathStep> Steps)
    {
        public void Add(PrintPath path, Role role, int rank)
            => Steps.Add(new PathStep(path.With(role, Level.Work.Layer), new StepGroup(Level.Work.Number, Number, rank)) { Region = Island });
    }
}
