using System;
using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Cli;

/// <summary>What a print is, in one line: layers, size, material, time.</summary>
internal sealed class PrintSummary
{
    // mm; what is thicker is pushed by a plunger.
    private const double ThickestFilament = 3.5;

    private readonly List<string> _parts = [];

    /// <param name="toolpath">What is printed.</param>
    /// <param name="diameter">Diameter of its filament in mm, 0 where it is not known.</param>
    /// <param name="density">Density of its material in g/cm³, 0 where it is not known.</param>
    /// <param name="seconds">How long it takes, where that is known.</param>
    private PrintSummary(Toolpath toolpath, double diameter, double density, double? seconds)
    {
        var box = Bounds.Empty;
        double length = 0, e = 0;
        double? volume = 0;
        foreach (var move in toolpath.Moves())
        {
            if (move.Kind != MoveKind.Print) continue;
            length += move.Length;
            e += move.Deposited;
            if (move.Deposited != 0) volume += toolpath.VolumeOf(move);
            if (move.Role is not (Role.Skirt or Role.Purge or Role.PrimeTower)) box = box.Include(move.Bounds);
        }
        var layers = toolpath.CountLayers();
        if (layers > 0) _parts.Add(layers == 1 ? "1 layer" : Number(layers, 0) + " layers");
        if (!box.IsEmpty) _parts.Add(Size(box, toolpath, length > 0 ? volume / length : null));
        _parts.Add(length == 0 ? "nothing is printed" : Amount(length, e, volume, diameter, density));
        if (seconds is > 0 and var time) _parts.Add("about " + Duration(time));
    }

    /// <summary>Of a plan.</summary>
    public static PrintSummary Of(Toolpath toolpath, PrintSetup setup, double seconds)
        => new(toolpath, setup.Material.FilamentDiameter, setup.Material.Density, seconds);

    /// <summary>Of a decoded file, whose moves may have been edited.</summary>
    public static PrintSummary Of(DecodedGCode decoding, Toolpath toolpath)
        => new(toolpath, Setting(decoding, "filament_diameter"), Setting(decoding, "filament_density"), null);

    public override string ToString() => string.Join(", ", _parts);

    /// <summary>Bytes as people read them: <c>1.2 MB</c>.</summary>
    public static string Size(long bytes) => bytes == 1 ? "1 byte" : MemoryLimit.Text(bytes);

    /// <summary>Hours and minutes, or minutes and seconds.</summary>
    public static string Duration(double seconds)
    {
        if (!(seconds < 1e9)) return "more than 30 years";
        var whole = (long)Math.Round(seconds);
        var minutes = (long)Math.Round(seconds / 60);
        return whole < 60 ? $"{NumberFormatter.Format(whole)} s"
            : whole < 3600 ? $"{NumberFormatter.Format(whole / 60)} min {NumberFormatter.Format(whole % 60)} s"
            : $"{NumberFormatter.Format(minutes / 60)} h {NumberFormatter.Format(minutes % 60)} min";
    }

    // From edge to edge: the box of the moves, and a strand of the mean width and of the thickness of the layers around them.
    private static string Size(Bounds box, Toolpath toolpath, double? area)
    {
        var thickness = toolpath.Layers.Count > 0 ? toolpath.Layers[^1].Thickness : 0;
        var width = area > 0 && thickness > 0 ? area.Value / thickness + thickness * (1 - Math.PI / 4) : 0;
        var (x, y, z) = (box.Size.X + width, box.Size.Y + width, box.Size.Z + (toolpath.Layers.Count > 0 ? toolpath.Layers[0].Thickness : 0));
        return $"{Number(x, 1)} × {Number(y, 1)}{(z > 0 ? " × " + Number(z, 1) : "")} mm";
    }

    private static string Amount(double length, double e, double? volume, double diameter, double density)
    {
        if (e == 0) return $"{Meters(length)} of strokes";
        if (volume is not > 0) return $"{Meters(length)} of strands, E {Number(e, 1)}";
        var mass = density > 0 ? $" ({Grams(volume.Value / 1000 * density)})" : "";
        if (diameter is not (> 0 and <= ThickestFilament)) return $"{Number(volume.Value / 1000, 2)} cm³{mass}";
        return $"{Meters(volume.Value / (Math.PI / 4 * diameter * diameter))} of filament{mass}";
    }

    // Slicers list one number for each tool.
    private static double Setting(DecodedGCode decoding, string key)
        => decoding.Settings.TryGetValue(key, out var text) && NumberReader.TryParse(text.Split(',', ';')[0].Trim(), out var value) && value > 0 ? value : 0;

    private static string Meters(double mm) => mm < 1000 ? Number(mm, mm < 100 ? 1 : 0) + " mm" : Number(mm / 1000, mm < 10_000 ? 2 : 1) + " m";

    private static string Grams(double grams) => Figures.Short(grams >= 10 ? Math.Round(grams) : grams) + " g";

    private static string Number(double value, int decimals) => NumberFormatter.Format(value, decimals);
}
