using System;
using System.Collections.Generic;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>The example definitions of examples/gh, made from code.</summary>
internal static class Definitions
{
    /// <summary>A sketch of each definition, by name.</summary>
    public static IReadOnlyDictionary<string, Func<string, Sketch>> All { get; } = new SortedDictionary<string, Func<string, Sketch>>(StringComparer.Ordinal)
    {
        ["bake"] = ToolpathDefinitions.Bake,
        ["between_boundaries"] = SliceDefinitions.BetweenBoundaries,
        ["check"] = ToolpathDefinitions.Check,
        ["check_and_repair"] = ToolpathDefinitions.CheckAndRepair,
        ["cup_with_skirt"] = TraceDefinitions.CupWithSkirt,
        ["curved_roof"] = SliceDefinitions.CurvedRoof,
        ["custom_printer"] = ToolpathDefinitions.CustomPrinter,
        ["decode_and_remix"] = ToolpathDefinitions.DecodeAndRemix,
        ["gap_bead"] = TraceDefinitions.GapBead,
        ["globe_from_image"] = TraceDefinitions.GlobeFromImage,
        ["helix_to_sphere"] = TraceDefinitions.HelixToSphere,
        ["l_system_tree"] = TurtleDefinitions.Tree,
        ["modulated_ring"] = TraceDefinitions.ModulatedRing,
        ["planar_slice"] = SliceDefinitions.PlanarSlice,
        ["print_on_terrain"] = SliceDefinitions.PrintOnTerrain,
        ["simulate"] = ToolpathDefinitions.Simulate,
        ["turtle_commands"] = TurtleDefinitions.Commands,
        ["turtle_star"] = TurtleDefinitions.Star,
        ["user_curves"] = TraceDefinitions.UserCurves,
        ["cooled_tower"] = TraceDefinitions.CooledTower,
        ["rhino_curves"] = TraceDefinitions.RhinoCurves,
        ["first_print"] = SliceDefinitions.FirstPrint,
        ["modifiers"] = SliceDefinitions.Modifiers,
        ["infill_curves"] = SliceDefinitions.InfillCurves,
        ["wave_layers"] = SliceDefinitions.WaveLayers,
        ["draw_on_dome"] = SliceDefinitions.DrawOnDome,
        ["imported_printer"] = ToolpathDefinitions.ImportedPrinter,
        ["edit_toolpath"] = ToolpathDefinitions.EditToolpath,
        ["vase"] = SliceDefinitions.Vase,
        ["slanted_layers"] = SliceDefinitions.SlantedLayers,
        ["tilted_tool"] = SliceDefinitions.TiltedTool,
        ["flat_drawing"] = MoveDefinitions.FlatDrawing,
        ["widths_and_events"] = MoveDefinitions.WidthsAndEvents,
        ["frames_for_robots"] = MoveDefinitions.FramesForRobots,
    };
}
