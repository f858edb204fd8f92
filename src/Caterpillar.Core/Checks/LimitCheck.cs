using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>
/// Looks for moves that the printer cannot or must not make: outside the space it can reach, below the bed, more material than the hot end can push, extrusion
/// while cold, faster than its axes. Problems of one kind are one diagnostic, with the first move and a count.
/// </summary>
public static class LimitCheck
{
    // mm; what is written has three decimals.
    private const double Tolerance = 0.001;

    /// <summary>Checks a toolpath against a printer, material and settings.</summary>
    /// <returns>
    /// Errors <c>bed.outside</c>, <c>bed.below</c>, <c>limit.flow</c>, <c>limit.cold_extrusion</c>, <c>limit.tool</c>,
    /// <c>limit.nozzle_temperature</c>, <c>limit.bed_temperature</c>, <c>limit.stationary</c>; warnings (remarks for travels)
    /// <c>limit.speed</c>; the
    /// source of each is the first such move with its step or line.
    /// </returns>
    public static IReadOnlyList<Diagnostic> Run(Toolpath toolpath, PrintSetup setup, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        var findings = new Findings(toolpath);
        var needed = setup.Printer.ExtrusionUnit == ExtrusionUnit.None ? 0 : setup.Printer.MinExtrusionTemperature;
        var nozzles = needed > 0 ? new NozzleTemperatures(toolpath, setup.Material.NozzleTemperature) : null;
        var start = toolpath.Start ?? Vec3.Zero;
        var known = toolpath.Start is not null;
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            cancel.ThrowIfCancellationRequested();
            progress?.Report((double)block / toolpath.Blocks.Count);
            var columns = toolpath.Blocks[block].Columns;
            var first = toolpath.FirstOf(block);
            for (var i = 0; i < columns.Count; i++)
            {
                var end = new Vec3(columns.X[i], columns.Y[i], columns.Z[i]);
                CheckPosition(columns, i, first + i, start, end, setup.Printer, findings);
                CheckStationary(toolpath, columns, i, first + i, known ? start : end, end, setup.Printer, findings);
                if (known) CheckRates(toolpath, columns, i, first + i, start, end, setup, findings);
                if (columns.E[i] > 0 && nozzles?.At(first + i, columns.Tool[i]) is { } celsius && celsius < needed)
                    ReportCold(celsius, first + i, setup.Printer, findings);
                known = true;
                start = end;
            }
        }
        TemperatureCheck.Run(toolpath, setup, findings);
        progress?.Report(1);
        return findings.ToList();
    }

    /// <summary>
    /// Checks a decoded file, which may heat by itself or leave that to a macro of the firmware. Where it does not state the diameter of its filament, that of
    /// the material holds.
    /// </summary>
    /// <inheritdoc cref="Run(Toolpath, PrintSetup, IProgress{double}?, CancellationToken)" path="/returns"/>
    public static IReadOnlyList<Diagnostic> Run(
        DecodedGCode file, PrintSetup setup, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (file is null) throw new ArgumentNullException(nameof(file));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        var findings = Run(WithVolumes(file.Toolpath, setup), SetupForFile(setup, file.Toolpath), progress, cancel);
        if (file.Report.File is not { Length: > 0 } name) return findings;
        return findings.Select(d => d with { Source = (d.Source ?? new SourceLocation()) with { File = name } }).ToArray();
    }

    /// <summary>The toolpath of a file with the filament of the material for the tools whose filament it does not state.</summary>
    internal static Toolpath WithVolumes(Toolpath toolpath, PrintSetup setup)
    {
        if (toolpath.Tools.All(t => t.VolumePerE is not null) || setup.Printer.ExtrusionUnit == ExtrusionUnit.None) return toolpath;
        var known = new ToolpathTool(ExtrusionModel.FilamentAreaOf(setup.Material.FilamentDiameter));
        return toolpath.WithTools(toolpath.Tools.Select(t => t.VolumePerE is null ? known : t));
    }

    /// <summary>
    /// The setup to check a decoded file against, which may heat by itself: one that does begins cold; one that leaves the heating to a macro of the firmware
    /// is taken as hot.
    /// </summary>
    public static PrintSetup SetupForFile(PrintSetup setup, Toolpath toolpath)
    {
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        foreach (var entry in toolpath.Events)
        {
            if (entry.Event is NozzleTemperatureEvent) return setup with { Material = setup.Material with { NozzleTemperature = 0 } };
        }
        return setup;
    }

    private static void CheckPosition(ToolpathColumns columns, int i, int move, Vec3 start, Vec3 end, Printer printer, Findings findings)
    {
        var reachable = printer.CanReach(end, Tolerance);
        if (reachable && columns.TryGetArc(i, out var arc))
            reachable = printer.BedShape == BedShape.Round ? ReachesAlong(arc, start, end, printer)
                : printer.BuildBounds.Contains(arc.Bounds(start, end), Tolerance);
        if (!reachable) ReportPosition(move, end, printer, findings);
    }

    private static void ReportPosition(int move, Vec3 end, Printer printer, Findings findings)
    {
        if (end.Z < -Tolerance && printer.CanReach(end.WithZ(0), Tolerance))
            findings.Add(Severity.Error, "bed.below", move, () => $"A move goes to Z {NumberFormatter.Format(end.Z, 3)} mm, below the bed.");
        else
            findings.Add(Severity.Error, "bed.outside", move, () => $"A move goes to {end}, outside the build volume of {printer.Title}: "
                + $"{printer.BuildBounds}{(printer.BedShape == BedShape.Round ? ", round" : "")}.");
    }

    private static bool ReachesAlong(Arc arc, Vec3 start, Vec3 end, Printer printer)
    {
        var chords = arc.ChordCount(start, 0.05);
        for (var k = 1; k < chords; k++)
        {
            if (!printer.CanReach(arc.PointAt(start, end, (double)k / chords), 0.05)) return false;
        }
        return true;
    }

    private static void CheckRates(Toolpath toolpath, ToolpathColumns columns, int i, int move, Vec3 start, Vec3 end, PrintSetup setup, Findings findings)
    {
        var printer = setup.Printer;
        if (columns.Tool[i] >= printer.ToolCount) ReportTool(columns.Tool[i], move, printer, findings);
        var speed = columns.Speed[i];
        var path = end - start;
        var length = columns.TryGetArc(i, out var arc) ? arc.Length(start, end) : path.Length;
        if (length <= 0 || speed <= 0) return;
        var most = MaxSpeed(path, length, printer.MaxSpeed);
        // Travels are slowed down without harm; a strand printed more slowly is not the one that was asked for.
        if (speed > most * (1 + 1e-9)) ReportSpeed(columns.Kind[i] == MoveKind.Print ? Severity.Warning
            : Severity.Remark, speed, most, move, printer, findings);
        var limit = setup.MaxFlow;
        if (columns.Kind[i] != MoveKind.Print || toolpath.VolumePerE(columns.Tool[i]) is not { } volume) return;
        var flow = columns.Deposited[i] * volume / length * Math.Min(speed, most);
        if (flow > limit * 1.001) ReportFlow(flow, limit, move, findings);
    }

    private static void CheckStationary(Toolpath toolpath, ToolpathColumns columns, int i, int move, Vec3 start, Vec3 end, Printer printer, Findings findings)
    {
        if (start != end || columns.E[i] == 0 || columns.TryGetArc(i, out _) || toolpath.VolumePerE(columns.Tool[i]) is not { } factor) return;
        var volume = columns.E[i] * factor;
        if (Math.Abs(volume) <= printer.MaxStationaryVolume * (1 + 1e-9)) return;
        findings.Add(Severity.Error, "limit.stationary", move,
            () => $"{Figures.Short(Math.Abs(volume))} mm³ are {(volume > 0 ? "pushed out" : "pulled back")} while the head stands still; "
                + $"{printer.Title} allows {Figures.Short(printer.MaxStationaryVolume)} mm³.");
    }

    private static void ReportTool(int tool, int move, Printer printer, Findings findings)
        => findings.Add(Severity.Error, "limit.tool", move,
            () => $"A move is for tool {NumberFormatter.Format(tool)}; {printer.Title} has {NumberFormatter.Format(printer.ToolCount)}, counted from 0.");

    private static void ReportSpeed(Severity severity, double speed, double most, int move, Printer printer, Findings findings)
        => findings.Add(severity, "limit.speed", move,
            () => $"A move asks for {Figures.Short(speed)} mm/s; {printer.Title} moves there at {Figures.Short(most)} mm/s and will "
                + $"slow down.");

    private static void ReportFlow(double flow, double limit, int move, Findings findings)
        => findings.Add(Severity.Error, "limit.flow", move,
            () => $"A move asks for {Figures.Short(flow)} mm³/s of material; the limit is {Figures.Short(limit)} mm³/s.");

    // What the axes allow in a direction; an arc is taken by its chord in Z and by the slower of X and Y.
    private static double MaxSpeed(Vec3 path, double length, AxisValues axes)
    {
        var most = double.MaxValue;
        if (path.X != 0) most = Math.Min(most, axes.X * length / Math.Abs(path.X));
        if (path.Y != 0) most = Math.Min(most, axes.Y * length / Math.Abs(path.Y));
        if (path.Z != 0) most = Math.Min(most, axes.Z * length / Math.Abs(path.Z));
        return most == double.MaxValue ? Math.Min(axes.X, axes.Y) : most;
    }

    private static void ReportCold(double celsius, int move, Printer printer, Findings findings)
        => findings.Add(Severity.Error, "limit.cold_extrusion", move,
            () => $"A move extrudes at {NumberFormatter.Format(celsius, 0)} °C; {printer.Title} needs "
                + $"{NumberFormatter.Format(printer.MinExtrusionTemperature, 0)} °C.");
}
