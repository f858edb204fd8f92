using System;
using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>Slows small layers down, so that each takes the least time of the settings. Layers of several objects at one height cool together.</summary>
internal static class LayerTime
{
    /// <summary>Layers of one height, in place; false where they stay below the time even at the least speed.</summary>
    public static bool Apply(SlicedLayer[] layers, int from, int to, PrintSettings settings)
    {
        double Speed(PrintPath path, int segment)
            => path.BeadOf(segment).Speed is > 0 and var own ? own : settings.SpeedOf(path.Role, path.Layer is { Index: 0 });

        if (LastsLongEnough(layers, from, to, settings.MinLayerTime, Speed)) return true;
        var paths = new List<PrintPath>();
        for (var i = from; i < to; i++)
        {
            foreach (var step in layers[i].Steps) paths.Add(step.Path);
        }
        var slowed = SlowDown.To(paths, Speed, settings.MinLayerTime, settings.MinSpeed, out var reached);
        var next = 0;
        for (var i = from; i < to; i++)
        {
            var steps = new List<PathStep>(layers[i].Steps.Count);
            foreach (var step in layers[i].Steps) steps.Add(step.With(slowed[next++]));
            layers[i] = layers[i] with { Steps = steps };
        }
        return reached;
    }

    /// <summary>Goes through all layers.</summary>
    public static void Apply(SlicedLayer[] layers, PrintSettings settings, DiagnosticList problems)
    {
        if (!(settings.MinLayerTime > 0)) return;
        var quick = 0;
        var first = 0.0;
        for (int from = 0, to; from < layers.Length; from = to)
        {
            to = from + 1;
            while (to < layers.Length && Math.Abs(layers[to].Layer.Z - layers[from].Layer.Z) < 1e-9) to++;
            if (Apply(layers, from, to, settings)) continue;
            if (quick++ == 0) first = layers[from].Layer.Z;
        }
        // Where the machine waits, they do.
        if (quick == 0 || settings.LayerWait != LayerWait.None) return;
        problems.Add(Severity.Remark, "slice.layer_time",
            $"Layers take less than {NumberFormatter.Format(settings.MinLayerTime, 1)} s even at {NumberFormatter.Format(settings.MinSpeed, 1)} mm/s, "
            + $"first at z = {NumberFormatter.Format(first, 3)} mm: they may not cool in time.", null, quick);
    }

    private static bool LastsLongEnough(SlicedLayer[] layers, int from, int to, double wanted, Func<PrintPath, int, double> speed)
    {
        var time = 0.0;
        for (var i = from; i < to; i++)
        {
            foreach (var step in layers[i].Steps)
            {
                time += SlowDown.TimeOf(step.Path, speed);
                if (time >= wanted) return true;
            }
        }
        return false;
    }
}
