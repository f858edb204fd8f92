using System.Collections.Generic;
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

    /// <summary>Adds the steps: a wall around each piece and lines in it; dense lines across them near the part.</summary>
    public static void Add(SupportLevel level, PrintSettings settings, LayerTools tools, List<PathStep> steps)
    {
        var engine = tools.Engine;
        var width = settings.LineWidth;
        // Where a support is thin, a single strand: two walls would lie in each other's place.
        var builder = new WallBuilder(level.Work.Rules.Walls with { Count = 1, VariableWidth = true }, engine);
        var islands = level.Support.Islands;
        for (var i = 0; i < islands.Count; i++)
        {
            var island = islands[i];
            var line = new SupportLine(level, island, FirstIsland + i, steps);
            var walls = builder.Outline(island);
            var near = level.Interface.IsEmpty ? Region.Empty : island.Intersect(level.Interface, engine);
            var role = near.Area > island.Area / 2 ? Role.SupportInterface : Role.Support;
            foreach (var wall in walls.Paths) line.Add(wall.ToPath(level.Top, level.Work.Rules.Walls), role, 0);
            var inside = walls.Inside;
            var dense = near.IsEmpty ? near : inside.Intersect(near, engine);
            if (!dense.IsEmpty) Lines(dense, settings.SupportInterfacePercent, 90, Role.SupportInterface, 2);
            if (settings.Support == SupportKind.Grid)
            {
                Lines(dense.IsEmpty ? inside : inside.Subtract(dense, engine), settings.SupportPercent, 0, Role.Support, 1);
            }

            void Lines(Region area, double percent, double angle, Role role, int rank)
            {
                // Ends keep half a width from the wall.
                var lines = area.Offset(-width / 4, JoinStyle.Miter, 2, ArcTolerance, engine);
                if (lines.IsEmpty) return;
                var spacing = level.Work.Rules.Pitch(width) * 100 / percent;
                var request = new InfillRequest(lines, InfillPattern.Lines, spacing, width) { Angle = angle, Z = level.Top, Layer = level.Work.Index };
                foreach (var found in tools.Infill.Fill(request))
                {
                    if (found.Points.Length > 1) line.Add(PrintPath.Own(found.Points, [level.Work.Rules.Bead(width)], found.Closed), role, rank);
                }
            }
        }
    }

    private readonly record struct SupportLine(SupportLevel Level, Region Island, int Number, List<PathStep> Steps)
    {
        public void Add(PrintPath path, Role role, int rank)
            => Steps.Add(new PathStep(path.With(role, Level.Work.Layer), new StepGroup(Level.Work.Number, Number, rank)) { Region = Island });
    }
}
