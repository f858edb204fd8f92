using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>The numbers of the settings that slicing one layer needs. Lengths in mm.</summary>
internal sealed record SliceRules(
    double Width, double Pitch, Bead Bead, int Walls, double InfillSpacing, double InfillAngle, double InfillOverlap, double Simplify, WallRules WallRules)
{
    public static SliceRules Of(PrintSettings settings, double thickness)
    {
        var bead = Bead.FromWidth(settings.LineWidth, thickness, shape: settings.BeadShape);
        // Neighbors lie so far apart that the strands fill the layer: area = pitch × thickness.
        var pitch = bead.Area / thickness;
        return new SliceRules(
            settings.LineWidth,
            pitch,
            bead,
            settings.WallCount,
            settings.InfillSpacing > 0 ? settings.InfillSpacing : settings.InfillPercent > 0 ? pitch * 100 / settings.InfillPercent : 0,
            settings.InfillAngle,
            settings.InfillOverlapPercent / 100 * settings.LineWidth,
            settings.SimplifyTolerance,
            WallRules.Of(settings, thickness));
    }
}
