using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Tests.GCode;

/// <summary>
/// Round trips from a decoded file to another text and back; each gives the first difference between the expected and the decoded moves, or null.
/// </summary>
internal static class RoundTrips
{
    private static readonly Vec3 Shift = new(3, -2, 1);

    /// <summary>Every move shifted and faster.</summary>
    public static string? Shifted(DecodedGCode decoding)
    {
        var edited = decoding.Toolpath.Transform(Affine.Move(Shift)).ScaleSpeed(new MoveFilter(), 1.25);
        return Edited(decoding, edited, new MoveTolerance());
    }

    public static string? Edited(DecodedGCode decoding, Toolpath edited, MoveTolerance tolerance)
    {
        var result = GCodeEditor.ToDocument(decoding, edited);
        if (result.Value is null) return Said(result.Diagnostics);
        return SameMoves.Difference(edited, Decode(result.Value, decoding.Flavor).Toolpath, tolerance with { Fan = decoding.Flavor.Fan });
    }

    /// <summary>The whole toolpath written by the writer that knows no document.</summary>
    public static string? Written(DecodedGCode decoding, bool relative) => Written(decoding, decoding.Toolpath, relative);

    /// <summary>An edited toolpath of a file, in its flavor.</summary>
    public static string? Written(DecodedGCode decoding, Toolpath toolpath, bool relative)
    {
        var unit = decoding.Axis != ExtrusionAxis.None ? ExtrusionUnit.Mm : ExtrusionUnit.None;
        var format = new GCodeFormat(NewFile.Machine with { Flavor = decoding.Flavor, ExtrusionMode = NewFile.Mode(relative), ExtrusionUnit = unit });
        if (format.LacksAmounts(toolpath)) return decoding.Axis == ExtrusionAxis.Switched ? null : "lacks amounts";
        var back = Decode(GCodeDocument.FromBytes(NewFile.Of(toolpath, format)), decoding.Flavor);
        return SameMoves.Difference(toolpath, back.Toolpath,
            new MoveTolerance { Speed = 0.5 / 60 + 1e-6, Chords = 0.01, SameLayers = false, Fan = decoding.Flavor.Fan,
            LayersOfExtrusions = !ReferenceEquals(toolpath, decoding.Toolpath) });
    }

    /// <summary>Converted to another flavor or notation; null also if that is impossible and reported.</summary>
    public static string? Converted(DecodedGCode decoding, ConvertOptions options, double chords = 0)
    {
        var flavor = options.Flavor ?? decoding.Flavor;
        var result = GCodeConverter.ToDocument(decoding, options);
        if (result.Value is null)
        {
            // The amount of a switched extruder is unknown; some firmware takes E only as volume, some does not home or heat.
            var must = decoding.Axis == ExtrusionAxis.Switched && !flavor.SwitchedExtruder ? "gcode.no_e_values" : options.Volumetric == false
                && flavor.StartsVolumetric ? "gcode.volumetric_only" : "";
            return result.Diagnostics.Any(d => d.Code == must || d.Code == "gcode.start_lost") ? null : Said(result.Diagnostics);
        }
        var back = GCodeDecoder.Decode(result.Value, new DecodeOptions { Flavor = flavor, FilamentDiameter = options.FilamentDiameter }).Value!;
        var tolerance = new MoveTolerance
        {
            Xyz = NumberFormatter.FromUnits(1, options.DecimalsXyz ?? 3),
            E = NumberFormatter.FromUnits(1, options.DecimalsE ?? 5),
            Speed = 0.5 / 60 * NumberFormatter.FromUnits(1, options.DecimalsF ?? 2) + 1e-9,
            Chords = Math.Max(options.ChordTolerance, 1e-3),
            RetractionLength = flavor.FirmwareRetraction || !decoding.Flavor.FirmwareRetraction ? null : options.RetractionLength,
            Tools = flavor.ToolLimit > 0,
            Fan = flavor.Fan,
            Target = flavor.Name == decoding.Flavor.Name ? null : flavor,
            Amounts = decoding.Axis.HasAmounts && flavor.ExtruderLetters.Length > 0,
            EFactors = Factors(decoding, back, options),
        };
        return SameMoves.Difference(decoding.Toolpath, back.Toolpath, tolerance);
    }

    /// <summary>Extrusions fitted by arcs.</summary>
    public static string? Fitted(DecodedGCode decoding)
    {
        if (!decoding.Flavor.Arcs) return null;
        return Edited(decoding, decoding.Toolpath.FitArcs(0.02), new MoveTolerance { Chords = 0.01 });
    }

    // E stays, or is converted between mm³ and mm.
    private static double[] Factors(DecodedGCode before, DecodedGCode after, ConvertOptions options)
    {
        var isVolume = before.Toolpath.Tools[0].VolumePerE == 1;
        var becomes = options.Volumetric ?? after.Toolpath.Tools[0].VolumePerE == 1;
        var area = Math.PI / 4 * (options.FilamentDiameter ?? 1) * (options.FilamentDiameter ?? 1);
        return [isVolume == becomes ? 1 : becomes ? area : 1 / area];
    }

    public static DecodedGCode Decode(GCodeDocument document, FlavorRules? flavor)
        => GCodeDecoder.Decode(document, new DecodeOptions { Flavor = flavor }).Value!;

    private static double EDecimal(DecodedGCode decoding) => NumberFormatter.FromUnits(1, LineStyle.Of(decoding.Document!).DecimalsE);

    private static string Said(IEnumerable<Diagnostic> diagnostics) => "refused: " + string.Join(" ", diagnostics.Select(d => d.Message));
}
