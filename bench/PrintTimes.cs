using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Simulation;
using Caterpillar.Slicing;
using Caterpillar.Tests.Geometry.Meshes;
using Caterpillar.Toolpaths;

namespace Caterpillar.Bench;

/// <summary>
/// How long the same part prints as sliced by Caterpillar and by the slicers that are installed: equal layers, widths, walls, skins, infill, speeds and
/// retraction, every file timed by the same model of the firmware.
/// </summary>
internal static class PrintTimes
{
    private const double ShortMove = 0.1;

    // No heating, no start and end code: motion alone. Travels as the peers make them, without a lift.
    private static readonly Printer Printer = new() { NozzleHeating = 0, BedHeating = 0, RetractionLength = 0.8, RetractionSpeed = 35 };

    private static readonly PrintSettings Settings = new()
    {
        LayerHeight = 0.2, FirstLayerHeight = 0.2, LineWidth = 0.45, WallCount = 2, InfillDensityPercent = 20, TopLayers = 4, BottomLayers = 4,
        TopThickness = 0, BottomThickness = 0, PrintSpeed = 60, OuterWallSpeed = 40, InfillSpeed = 80, SolidInfillSpeed = 60, TopSurfaceSpeed = 60,
        BridgeSpeed = 60, InfillBridgeSpeed = 60, FirstLayerSpeed = 25, TravelSpeed = 150, RetractionMinTravel = 1.5, ZHopType = ZHopType.None,
        MinLayerTime = 0, OverhangClasses = ValueList<OverhangClass>.Empty,
    };

    /// <summary>A table in Markdown. What the peers write is kept in a folder and not made again.</summary>
    public static void Run(string folder, string[] models)
    {
        Directory.CreateDirectory(folder);
        Console.WriteLine("| mesh | program | printed | travel | retractions | moves | below 0.1 mm | time |");
        Console.WriteLine("|---|---|---|---|---|---|---|---|");
        foreach (var file in models)
        {
            var name = Path.GetFileNameWithoutExtension(file);
            var setup = new PrintSetup { Printer = Printer, Settings = Settings };
            var placed = ModelPlacement.OnBed(MeshReader.Read(file).Value!, Printer.BuildBounds.Center);
            Row(name, "Caterpillar", Planner.Plan(PlanarSlicer.Slice(placed, Settings).Value!.ToSteps(), setup).Value!);
            var stl = Path.Combine(folder, name + ".stl");
            if (!File.Exists(stl)) File.WriteAllBytes(stl, StlWriter.ToBytes(TriMesh.Merge(placed.Select(m => m.Mesh).ToArray())));
            Peer(name, "PrusaSlicer", Path.Combine(folder, name + ".prusa.gcode"), output => Prusa(stl, output));
            Peer(name, "CuraEngine", Path.Combine(folder, name + ".cura.gcode"), output => Cura(stl, output));
        }
    }

    private static void Peer(string name, string program, string output, Func<string, ProcessStartInfo> command)
    {
        if (!File.Exists(output) && !Finish(command(output))) return;
        if (!File.Exists(output)) return;
        var decoded = GCodeDecoder.Decode(File.ReadAllBytes(output), new DecodeOptions { Flavor = FlavorTable.Marlin2, FilamentDiameter = 1.75 }).Value!;
        Row(name, program, decoded.Toolpath);
    }

    private static bool Finish(ProcessStartInfo start)
    {
        try
        {
            start.RedirectStandardOutput = start.RedirectStandardError = true;
            using var process = Process.Start(start)!;
            process.OutputDataReceived += (_, _) => { };
            process.ErrorDataReceived += (_, _) => { };
            process.BeginOutputReadLine();
            process.BeginErrorReadLine();
            process.WaitForExit();
            return true;
        }
        catch (System.ComponentModel.Win32Exception)
        {
            return false;
        }
    }

    private static void Row(string mesh, string program, Toolpath toolpath)
    {
        var statistics = PrintStatistics.Of(Timeline.Of(toolpath, new PrintSetup { Printer = Printer }));
        var printed = toolpath.Moves().Where(m => m.Kind == MoveKind.Print && m.Length > 0).ToList();
        var tiny = 100.0 * printed.Count(m => m.Length < ShortMove) / printed.Count;
        var (length, travel) = (printed.Sum(m => m.Length) / 1000, statistics.TravelLength / 1000);
        var work = string.Create(CultureInfo.InvariantCulture, $"{length:0.0} m | {travel:0.0} m | {statistics.Retractions} | {printed.Count}");
        Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"| {mesh} | {program} | {work} | {tiny:0.0} % | {statistics.Duration:0} s |"));
    }

    private static ProcessStartInfo Prusa(string stl, string output) => new("prusa-slicer",
        "--export-gcode --loglevel 0 -o " + output
        + " --nozzle-diameter 0.4 --filament-diameter 1.75 --layer-height 0.2 --first-layer-height 0.2 --center 110,110 --perimeters 2 --fill-density 20%"
        + " --fill-pattern rectilinear --top-solid-layers 4 --bottom-solid-layers 4 --top-solid-min-thickness 0 --bottom-solid-min-thickness 0 --skirts 0"
        + " --extrusion-width 0.45 --perimeter-extrusion-width 0.45 --external-perimeter-extrusion-width 0.45 --infill-extrusion-width 0.45"
        + " --solid-infill-extrusion-width 0.45 --top-infill-extrusion-width 0.45 --first-layer-extrusion-width 0.45 --perimeter-speed 60"
        + " --external-perimeter-speed 40 --small-perimeter-speed 40 --infill-speed 80 --solid-infill-speed 60 --top-solid-infill-speed 60 --bridge-speed 60"
        + " --gap-fill-speed 60 --first-layer-speed 25 --travel-speed 150 --retract-length 0.8 --retract-speed 35 --deretract-speed 35"
        + " --retract-before-travel 1.5 --retract-lift 0 --no-retract-layer-change --machine-limits-usage ignore --default-acceleration 0 --no-cooling"
        + " --only-retract-when-crossing-perimeters --no-overhangs --no-thick-bridges --no-ensure-vertical-shell-thickness"
        + " --start-gcode G90 --end-gcode G90 " + stl);

    private static ProcessStartInfo Cura(string stl, string output)
    {
        const string Resources = "/usr/share/cura/resources/";
        string[] values =
        [
            "layer_height=0.2", "layer_height_0=0.2", "wall_line_count=2", "infill_pattern=lines", "infill_sparse_density=20", "infill_line_distance=2.035",
            "top_layers=4", "bottom_layers=4", "initial_bottom_layers=4", "adhesion_type=none", "support_enable=false", "machine_nozzle_size=0.4",
            "machine_width=220", "machine_depth=220", "machine_height=250", "machine_center_is_zero=false", "center_object=true", "line_width=0.45",
            "wall_line_width=0.45", "wall_line_width_0=0.45", "wall_line_width_x=0.45", "infill_line_width=0.45", "skin_line_width=0.407",
            "retraction_enable=true", "retraction_amount=0.8", "retraction_speed=35", "retraction_retract_speed=35", "retraction_prime_speed=35",
            "retraction_min_travel=1.5", "retraction_hop_enabled=false", "speed_print=60", "speed_wall=60", "speed_wall_0=40", "speed_wall_x=60",
            "speed_infill=80", "speed_topbottom=60", "speed_roofing=60", "speed_travel=150", "speed_layer_0=25", "speed_print_layer_0=25",
            "speed_travel_layer_0=150", "speed_slowdown_layers=1", "cool_min_layer_time=0", "acceleration_enabled=false", "jerk_enabled=false",
            "material_print_temperature=210", "material_print_temperature_layer_0=210", "material_diameter=1.75",
        ];
        var start = new ProcessStartInfo("CuraEngine", "slice -j " + Resources + "definitions/fdmprinter.def.json -o " + output
            + string.Concat(values.Select(v => " -s " + v)) + " -e0 -s material_diameter=1.75 -l " + stl);
        start.Environment["CURA_ENGINE_SEARCH_PATH"] = Resources + "definitions:" + Resources + "extruders";
        return start;
    }
}
