namespace Caterpillar.Slicing;

/// <summary>The numbers of the settings that slicing one layer needs. Lengths in mm.</summary>
/// <param name="Settings">The settings themselves.</param>
/// <param name="Walls">Rules for the walls, including the spacing of a bead of a width.</param>
/// <param name="Thickness">Thickness of the layer.</param>
internal sealed record SliceRules(PrintSettings Settings, WallRules Walls, double Thickness)
{
    /// <summary>The curves of the infill, at Z 0, mm.</summary>
    public IReadOnlyList<Polyline> InfillCurves { get; init; } = [];

    /// <summary>The settings of the whole print, which planning takes the usual speeds from.</summary>
    public PrintSettings Common { get; init; } = Settings;

    /// <summary>True in the first layer on the bed.</summary>
    public bool First { get; init; }

    /// <summary>Top of the layer above the bottom of the model.</summary>
    public double Top { get; init; }

    /// <summary>The tool of the walls.</summary>
    public int WallTool => Settings.ToolOf(Role.OuterWall, Top);

    /// <summary>Formula of the infill, or null.</summary>
    public Formula? InfillFormula { get; init; }

    /// <param name="settings">The settings that apply.</param>
    /// <param name="thickness">Thickness of the layer.</param>
    /// <param name="common">Those of the whole print.</param>
    /// <param name="first">Whether it is the first on the bed.</param>
    public static SliceRules Of(PrintSettings settings, double thickness, PrintSettings? common = null, bool first = false)
        => new(settings, WallRules.Of(settings, thickness, first), thickness)
    {
        First = first,
        Common = common ?? settings,
        InfillCurves = settings.InfillPattern == InfillPattern.Curves ? InfillPoint.Curves(settings.InfillCurves) : [],
        InfillFormula = settings.InfillFormula.Length > 0 ? Formula.Compile(settings.InfillFormula, LevelSet.Variables).Value : null,
    };

    /// <summary>Width of extrusions without one of their own.</summary>
    public double Width => Settings.WidthOf(0, First);

    public double InfillWidth => Settings.WidthOf(Settings.InfillLineWidth, First);

    public double SolidWidth => Settings.WidthOf(Settings.SolidInfillLineWidth, First);

    public double TopWidth => Settings.WidthOf(Settings.TopSurfaceLineWidth > 0 ? Settings.TopSurfaceLineWidth : Settings.SolidInfillLineWidth, First);

    public double SupportWidth => Settings.WidthOf(Settings.SupportLineWidth, First);

    /// <summary>How far infill reaches into the walls.</summary>
    public double Overlap => Settings.WallCount == 0 ? 0 : Settings.InfillOverlapPercent / 100 * Width;

    /// <summary>How far the turns of lines that close an area do: with more, as much is printed twice as stays open with less.</summary>
    public double SolidOverlap => Overlap * 2 / 3;

    /// <summary>Area filled per length of infill. 0 = no infill.</summary>
    public double InfillSpacing => Settings.InfillSpacing > 0
        ? Settings.InfillSpacing / InfillFiller.Families(Settings.InfillPattern)
        : Settings.InfillDensityPercent > 0 ? Pitch(InfillWidth) * 100 / Settings.InfillDensityPercent : 0;

    /// <summary>Whether the infill leaves no gaps. What the user drew stays as it is.</summary>
    public bool IsSolid => InfillSpacing > 0 && Settings.InfillPattern != InfillPattern.Curves && InfillSpacing <= Pitch(InfillWidth) * (1 + 1e-9);

    /// <summary>Direction of the infill of a layer, degrees from +X.</summary>
    public double InfillAngle(int layer) => Settings.InfillAngle + layer / Settings.CombineInfillLayers * Settings.InfillRotation;

    /// <summary>Spacing of neighbors at which extrusions fill the layer.</summary>
    public double Pitch(double width) => Walls.Spacing(width);

    /// <summary>Whether walls are laid as with other rules, so that areas of both may share them.</summary>
    public bool HasSameWalls(SliceRules other) => Walls == other.Walls && WallTool == other.WallTool
        && Settings.OnlyOneWallFirstLayer == other.Settings.OnlyOneWallFirstLayer && Settings.OnlyOneWallTop == other.Settings.OnlyOneWallTop
        && Settings.AlternateExtraWall == other.Settings.AlternateExtraWall && Settings.ExtraWallsOnOverhangs == other.Settings.ExtraWallsOnOverhangs;

    /// <summary>A path with the tool and the flow of these settings, and with their speed if it differs from the print.</summary>
    public PrintPath Own(PrintPath path)
    {
        if (Settings.ToolOf(path.Role, Top) is var tool && tool != path.Tool) path = path with { Tool = tool };
        var first = path.Layer is { Index: 0 };
        var speed = ReferenceEquals(Settings, Common) ? 0 : Settings.SpeedOf(path.Role, first);
        if (speed == Common.SpeedOf(path.Role, first)) speed = 0;
        if (speed == 0 && Settings.PartFlowRatio == 1) return path;
        return path.WithBeads(i =>
        {
            var bead = path.BeadOf(i);
            return new Bead(bead.Area * Settings.PartFlowRatio, bead.Height, bead.Speed > 0 ? bead.Speed : speed);
        });
    }

    public Bead Bead(double width) => new(Walls.Area(width), Thickness);
}
