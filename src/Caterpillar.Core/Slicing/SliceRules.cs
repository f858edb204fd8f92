using Caterpillar.Expressions;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>The numbers of the settings that slicing one layer needs. Lengths in mm.</summary>
/// <param name="Settings">The settings themselves.</param>
/// <param name="Walls">The rules of its walls; they also know what a bead of a width covers.</param>
/// <param name="Thickness">Thickness of the layer.</param>
internal sealed record SliceRules(PrintSettings Settings, WallRules Walls, double Thickness)
{
    /// <summary>The formula of the infill, where it has one.</summary>
    public Formula? InfillFormula { get; init; }

    public static SliceRules Of(PrintSettings settings, double thickness) => new(settings, WallRules.Of(settings, thickness), thickness)
    {
        InfillFormula = settings.InfillFormula.Length > 0 ? Formula.Compile(settings.InfillFormula, LevelSet.Variables).Value : null,
    };

    /// <summary>Width of the strands of infill.</summary>
    public double Width => Settings.LineWidth;

    public double SkinWidth => Settings.SkinWidth > 0 ? Settings.SkinWidth : Settings.LineWidth;

    /// <summary>How far fillings reach into the walls.</summary>
    public double Overlap => Settings.WallCount == 0 ? 0 : Settings.InfillOverlapPercent / 100 * Settings.LineWidth;

    /// <summary>Area filled per length of infill; 0 for no infill.</summary>
    public double InfillSpacing => Settings.InfillSpacing > 0
        ? Settings.InfillSpacing / InfillFiller.Families(Settings.InfillPattern)
        : Settings.InfillPercent > 0 ? Pitch(Width) * 100 / Settings.InfillPercent : 0;

    /// <summary>Whether the infill leaves no gaps.</summary>
    public bool IsSolid => InfillSpacing > 0 && InfillSpacing <= Pitch(Width) * (1 + 1e-9);

    /// <summary>Neighbors lie so far apart that the strands fill the layer.</summary>
    public double Pitch(double width) => Walls.Spacing(width);

    public Bead Bead(double width) => new(Walls.Area(width), Thickness);
}
