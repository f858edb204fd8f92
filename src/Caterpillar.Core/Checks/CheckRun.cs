using System;
using System.Collections.Generic;
using System.Threading;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>Shows a toolpath to checks, move by move.</summary>
internal static class CheckRun
{
    private const int Pulse = 4096;

    public static void Run(Toolpath toolpath, IMoveCheck[] checks, IProgress<double>? progress, CancellationToken cancel)
    {
        var seen = new CheckedMove { End = toolpath.Start ?? Vec3.Zero };
        var known = toolpath.Start is not null;
        var next = 0;
        var homes = false;
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var c = toolpath.Blocks[block].Columns;
            var first = toolpath.FirstOf(block);
            for (var i = 0; i < c.Count; i++)
            {
                if ((i & (Pulse - 1)) == 0)
                {
                    cancel.ThrowIfCancellationRequested();
                    progress?.Report((first + i) / (double)toolpath.Count);
                }
                HomeEvent? home = null;
                for (; next < toolpath.Events.Count && toolpath.Events[next].Move <= first + i; next++)
                {
                    home = toolpath.Events[next].Event as HomeEvent ?? home;
                    foreach (var check in checks) check.Event(toolpath.Events[next]);
                }
                Fill(ref seen, toolpath, c, i);
                seen.Index = first + i;
                seen.IsHoming = home is not null && seen.Kind == MoveKind.Travel && seen.E == 0 && seen.End == home.Home(seen.Start);
                // Where a head comes from after it has homed is the machine's own.
                seen.StartKnown = known && !seen.IsHoming && !(homes && home is null) && home is null;
                homes = seen.IsHoming;
                known = true;
                foreach (var check in checks) check.Move(seen);
            }
        }
        for (; next < toolpath.Events.Count; next++)
        {
            foreach (var check in checks) check.Event(toolpath.Events[next]);
        }
        foreach (var check in checks) check.End(toolpath);
    }

    private static void Fill(ref CheckedMove move, Toolpath toolpath, ToolpathColumns c, int i)
    {
        move.Start = move.End;
        move.End = new Vec3(c.X[i], c.Y[i], c.Z[i]);
        move.Kind = c.Kind[i];
        move.Role = c.Role[i];
        move.Layer = c.Layer[i];
        move.Tool = c.Tool[i];
        move.E = c.E[i];
        move.Speed = c.Speed[i];
        move.Arc = c.TryGetArc(i, out var arc) ? arc : null;
        move.Length = move.Arc is null ? move.Start.DistanceTo(move.End) : arc.Length(move.Start, move.End);
        var volume = toolpath.VolumePerE(move.Tool) ?? double.NaN;
        move.Deposited = c.Deposited[i] * volume;
        move.Pushed = move.E * volume;
        move.Thickness = toolpath.ThicknessOf(move.Layer);
    }
}
