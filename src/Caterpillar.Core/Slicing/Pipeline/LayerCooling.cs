namespace Caterpillar.Slicing;

/// <summary>Slows down small layers to the minimum layer time. Layers of several models at one height cool together.</summary>
internal sealed class LayerCooling(PrintSettings settings)
{
    private int _quick;
    private double _first;

    /// <summary>Slows down the layers of one height, in place.</summary>
    public void Apply(IList<SlicedLayer> layers)
    {
        double Speed(PrintPath path, int segment)
            => path.BeadOf(segment).Speed is > 0 and var own ? own : settings.SpeedOf(path.Role, path.Layer is { Index: 0 });

        if (!(settings.MinLayerTime > 0) || LastsLongEnough(layers, settings.MinLayerTime, Speed)) return;
        var paths = layers.SelectMany(layer => layer.Steps).Select(step => step.Path).ToArray();
        var slowed = SlowDown.To(paths, Speed, settings.MinLayerTime, settings.MinPrintSpeed, out var reached);
        var next = 0;
        for (var i = 0; i < layers.Count; i++)
        {
            var steps = new List<PathStep>(layers[i].Steps.Count);
            foreach (var step in layers[i].Steps) steps.Add(step with { Path = slowed[next++] });
            layers[i] = layers[i] with { Steps = steps };
        }
        if (!reached && _quick++ == 0) _first = layers[0].Layer.Z;
    }

    /// <summary>Reports layers below the minimum layer time.</summary>
    public void Report(DiagnosticList problems)
    {
        // Where the machine waits, they do.
        if (_quick == 0 || settings.LayerTimeWait != LayerTimeWait.None) return;
        problems.Add(Severity.Note, "slice.layer_time",
            $"A layer takes less than {NumberFormatter.Format(settings.MinLayerTime, 1)} s even at {NumberFormatter.Format(settings.MinPrintSpeed, 1)} mm/s "
            + $"(first at z = {NumberFormatter.Format(_first, 3)} mm) and may stay too hot.", null, _quick);
    }

    private static bool LastsLongEnough(IList<SlicedLayer> layers, double wanted, Func<PrintPath, int, double> speed)
    {
        var time = 0.0;
        foreach (var layer in layers)
        {
            foreach (var step in layer.Steps)
            {
                time += SlowDown.TimeOf(step.Path, speed);
                if (time >= wanted) return true;
            }
        }
        return false;
    }
}
