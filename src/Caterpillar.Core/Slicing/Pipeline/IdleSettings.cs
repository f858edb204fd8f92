namespace Caterpillar.Slicing;

/// <summary>
/// Reports settings that have no effect because of another one. A value is idle if it is not the default and the other key rules it out in all settings of
/// the print that have it. The values 0 and false are never idle.
/// </summary>
internal static class IdleSettings
{
    private static readonly PrintSettings Usual = new();

    // What was asked for and is not printed is worth a warning, a value for something that is off a note.
    private static readonly Rule[] Rules =
    [
        new(Severity.Warning, "with spiral_vase=true", "A vase has one wall and solid bottom layers, and no supports, top layers or infill", s => s.SpiralVase,
            SupportKeys.Support, TopBottomKeys.TopLayers, TopBottomKeys.TopThickness, TopBottomKeys.Ironing, SettingsKeys.InfillDensityPercent,
                SettingsKeys.InfillSpacing,
            InfillKeys.InfillPattern, InfillKeys.CombineInfillLayers),
        new(Severity.Warning, "above the bottom layers with spiral_vase=true", "The wall of a vase has one width and no seam", s => s.SpiralVase,
            SurfaceKeys.FuzzySkinThickness, SeamKeys.ScarfSeamLength, WallWidthKeys.ArcFittingTolerance, SeamKeys.SeamEnforcers),
        new(Severity.Note, "above the bottom layers with spiral_vase=true", "A vase has one wall", s => s.SpiralVase && s.WallCount > 1,
            SettingsKeys.WallCount),
        new(Severity.Warning, "with wall_count=0", "The print has no walls", s => s is { WallCount: 0, SpiralVase: false },
            WallWidthKeys.AlternateExtraWall, WallWidthKeys.ExtraWallsOnOverhangs, WallWidthKeys.SmallLoopSpeed,
            SurfaceKeys.FuzzySkinThickness, SeamKeys.ScarfSeamLength, WallWidthKeys.ArcFittingTolerance, SeamKeys.SeamEnforcers),
        new(Severity.Warning, "with layer_height_formula", "The formula sets the layer height", s => s.LayerFormula.Length > 0, LayerKeys.AdaptiveLayers),
        new(Severity.Warning, "with top_layers=0 and top_thickness_mm=0", "The print has no solid top layers", s => !s.SpiralVase && !HasTop(s),
            TopBottomKeys.Ironing),
        new(Severity.Warning, "with infill_density_percent=0 and infill_spacing_mm=0", "The print has no infill", s => !s.SpiralVase && !HasInfill(s),
            InfillKeys.InfillPattern, InfillKeys.CombineInfillLayers, InfillKeys.InfillAnchor, InfillKeys.InfillAnchorMax),
        new(Severity.Note, "with infill_pattern=curves", "Curves are printed as they are", s => s.InfillPattern == InfillPattern.Curves,
            InfillKeys.InfillAnchor, InfillKeys.InfillAnchorMax),
        new(Severity.Note, "with infill_spacing_mm", "The spacing sets the density", s => s.InfillSpacing > 0, SettingsKeys.InfillDensityPercent),
        new(Severity.Note, "with open_contours=walls", "Open contours are printed as they are", s => s.OpenContours == OpenContours.Walls,
            SettingsKeys.SliceGapClosing, SettingsKeys.MaxAreaLossPercent),
        Unless("adaptive_layers=true", s => !s.AdaptiveLayers, LayerKeys.AdaptiveMinHeight, LayerKeys.AdaptiveMaxHeight, LayerKeys.AdaptiveCuspHeight),
        Unless("ironing=true", s => !s.Ironing, TopBottomKeys.IroningSpacing, TopBottomKeys.IroningFlowPercent, TopBottomKeys.IroningSpeed),
        Unless("infill_pattern=formula", s => s.InfillPattern != InfillPattern.Formula, InfillKeys.InfillFormula),
        Unless("infill_pattern=curves", s => s.InfillPattern != InfillPattern.Curves, InfillKeys.InfillCurves),
        Unless("bridges=true", s => !s.Bridges, TopBottomKeys.BridgeFlowRatio, TopBottomKeys.BridgeSpeed, TopBottomKeys.BridgeFanSpeedPercent),
        Unless("infill_bridges=true", s => !s.InfillBridges, TopBottomKeys.InfillBridgeFlowRatio, TopBottomKeys.InfillBridgeSpeed),
        Unless("wall_count is above 1", s => s.WallCount < 2 && !s.AlternateExtraWall,
            WallWidthKeys.OnlyOneWallFirstLayer, WallWidthKeys.OnlyOneWallTop),
        Unless("small_loop_speed_mm_s is above 0", s => s.SmallLoopSpeed == 0, WallWidthKeys.SmallLoopRadius),
        Unless("hole_to_polyhole=true", s => !s.HoleToPolyhole, LayerKeys.HoleToPolyholeTwisted, LayerKeys.HoleToPolyholeThreshold),
        Unless("variable_wall_width=true", s => !s.VariableWallWidth, WallWidthKeys.MinWallWidth, WallWidthKeys.MaxWallWidth),
        Unless("seam_position=point", s => s.SeamPosition != SeamPosition.Point, SeamKeys.SeamPoint),
        Unless("seam_position=random", s => s.SeamPosition != SeamPosition.Random, SeamKeys.SeamSeed),
        Unless("scarf_seam_length_mm is above 0", s => s.ScarfSeamLength == 0, SeamKeys.ScarfSeamSteps),
        Unless("fuzzy_skin_thickness_mm is above 0", s => s.FuzzySkinThickness == 0, SurfaceKeys.FuzzySkinPointDistance, SurfaceKeys.FuzzySkinSeed),
        Unless("spiral_vase=true", s => !s.SpiralVase, SurfaceKeys.SpiralVaseMinFlowPercent),
        Unless("min_layer_time_s is above 0", s => s.MinLayerTime == 0, SurfaceKeys.MinPrintSpeed, TravelKeys.LayerTimeWait),
        Unless("skirt_loops is above 0", s => s.SkirtLoops == 0, BedKeys.SkirtDistance),
        Unless("brim_width_mm is above 0", s => s.BrimWidth == 0, BedKeys.BrimType),
        Unless("brim_width_mm is above 0", s => s.BrimWidth == 0 && s.BrimEars.Count == 0, BedKeys.BrimGap),
        Unless("brim_type=ears", s => s.BrimType != BrimType.Ears, BedKeys.BrimEarsMaxAngle),
        Unless("raft_layers is above 0", s => s.RaftLayers == 0, BedKeys.RaftExpansion, BedKeys.RaftLayerHeight, BedKeys.RaftGap, BedKeys.RaftDensityPercent),
        new(Severity.Warning, "with print_sequence=by_object", "The head would hit a tower beside the models",
            s => s.PrintSequence == PrintSequence.ByObject, ToolKeys.PurgeTower),
        Unless("purge_tower=true", s => !s.PurgeTower, ToolKeys.PurgeTowerWidth, ToolKeys.PurgeTowerBrimWidth),
        Unless("purge_tower=true or purge_into_infill=true", s => s is { PurgeTower: false, PurgeIntoInfill: false }, ToolKeys.PurgeVolume),
        Unless("support=grid or support=tree", s => s.Support == SupportKind.None,
            SupportKeys.SupportPlacement, SupportKeys.SupportAngle, SupportKeys.MaxBridgeLength, SupportKeys.SupportXyGap, SupportKeys.SupportTopGap,
            SupportKeys.SupportBottomGap, SupportKeys.SupportDensityPercent, SupportKeys.SupportInterfaceLayers,
            SupportKeys.SupportInterfaceDensityPercent, SupportKeys.TreeTipDistance, SupportKeys.TreeBranchAngle, SupportKeys.TreeBranchDiameterAngle,
            SupportKeys.TreeBranchDiameter, SupportKeys.SupportSpeed, WidthKeys.SupportLineWidth, ToolKeys.SupportInterfaceTool),
        Unless("support=tree", s => s.Support == SupportKind.Grid,
            SupportKeys.TreeTipDistance, SupportKeys.TreeBranchAngle, SupportKeys.TreeBranchDiameterAngle, SupportKeys.TreeBranchDiameter),
        Unless("support=grid", s => s.Support == SupportKind.Tree, SupportKeys.SupportDensityPercent),
        Unless("support_interface_layers is above 0", s => s.Support != SupportKind.None && s.SupportInterfaceLayers == 0,
            SupportKeys.SupportInterfaceDensityPercent, ToolKeys.SupportInterfaceTool),
    ];

    /// <summary>One diagnostic for each reason.</summary>
    /// <param name="models">Models, including modifiers and support blockers and enforcers.</param>
    /// <param name="common">The settings of the print.</param>
    public static IEnumerable<Diagnostic> Of(IReadOnlyList<SliceModel> models, PrintSettings common)
    {
        var all = models.Select(m => m.Settings).Concat([common]).Select(s => s.AsGiven).Distinct().ToArray();
        foreach (var rule in Rules)
        {
            var idle = rule.Keys.Where(k => Asking(k, all) is { Length: > 0 } asking && asking.All(rule.Holds)).Select(k => k.Name).ToArray();
            if (idle.Length == 0) continue;
            var why = rule.Why.Length > 0 ? $" {rule.Why}." : "";
            yield return new Diagnostic(
                rule.Severity, "slice.no_effect", $"{string.Join(", ", idle)} {(idle.Length == 1 ? "has" : "have")} no effect {rule.Place}.{why}");
        }
    }

    private static PrintSettings[] Asking(ProfileKey<PrintSettings> key, PrintSettings[] all)
        => Array.FindAll(all, s => !key.IsSame(s, Usual) && key.Get(s) is not (0.0 or false));

    private static bool HasTop(PrintSettings s) => s.TopLayers > 0 || s.TopThickness > 0;

    private static bool HasInfill(PrintSettings s) => s.InfillDensityPercent > 0 || s.InfillSpacing > 0;

    private static Rule Unless(string condition, Func<PrintSettings, bool> isOff, params ProfileKey<PrintSettings>[] keys)
        => new(Severity.Note, "unless " + condition, "", isOff, keys);

    // When keys have no effect, and why.
    private sealed record Rule(Severity Severity, string Place, string Why, Func<PrintSettings, bool> Holds, params ProfileKey<PrintSettings>[] Keys);
}
