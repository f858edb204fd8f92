namespace Caterpillar.Slicing;

/// <summary>Estimates the memory of the layers of a print, first by their number, then by their points.</summary>
internal sealed class SliceMemory(MemoryLimit limit)
{
    // A layer with its section, region, islands and steps; a point of an extrusion with its bead, until it is planned.
    private const double BytesPerLayer = 4000;
    private const double BytesPerPoint = 120;

    private long _layers;

    /// <exception cref="DiagnosticException">All layers planned so far would take too much.</exception>
    public void Plan(Body body, PlannedLayer[] layers)
    {
        _layers += layers.Length;
        limit.Check(_layers * BytesPerLayer, NumberFormatter.Format(_layers) + " layers", body.Source, "Increase the layer height.");
    }

    /// <summary>The same layers, counted as they come.</summary>
    /// <exception cref="DiagnosticException">What is in them takes too much.</exception>
    public IEnumerable<SlicedLayer> Watch(IEnumerable<SlicedLayer> layers)
    {
        long points = 0;
        var done = 0;
        foreach (var layer in layers)
        {
            done++;
            foreach (var step in layer.Steps) points += step.Path.RawPoints.Length;
            if (points * BytesPerPoint > limit.Bytes)
                limit.Check(points * BytesPerPoint, $"The first {NumberFormatter.Format(done)} of {NumberFormatter.Format(_layers)} layers", null,
                    "Increase the infill spacing, line width or layer height.");
            yield return layer;
        }
    }
}
