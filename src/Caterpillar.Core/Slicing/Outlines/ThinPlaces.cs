namespace Caterpillar.Slicing;

/// <summary>Reports areas that are too thin to print, over all layers of a body.</summary>
internal static class ThinPlaces
{
    /// <summary>Adds one warning with layers, place and area, or none if every area is printed.</summary>
    public static void Report(Body body, List<Diagnostic> findings)
    {
        int layers = 0, places = 0;
        double total = 0, from = 0, to = 0, z = 0;
        var largest = default(ThinPlace);
        foreach (var layer in body.Layers)
        {
            if (layer.TooThin.Count == 0) continue;
            if (layers++ == 0) from = layer.Plan.Top;
            to = layer.Plan.Top;
            foreach (var place in layer.TooThin)
            {
                places++;
                total += place.Area;
                if (place.Area > largest.Area) (largest, z) = (place, layer.Plan.Top);
            }
        }
        if (places == 0) return;
        var heights = layers == 1 ? $"1 layer (z {Mm(from)} mm)" : $"{NumberFormatter.Format(layers)} layers (z {Mm(from)} to {Mm(to)} mm)";
        var largestPlace = $"X {Mm(largest.Place.X)} Y {Mm(largest.Place.Y)} Z {Mm(z)}";
        var message = $"Areas thinner than the narrowest wall are not printed: {Mm(total)} mm² on {heights}, the largest {Mm(largest.Area)} mm² at "
            + $"{largestPlace}. Reduce min_wall_width_mm or line_width_mm, or make the model thicker.";
        findings.Add(new Diagnostic(Severity.Warning, "slice.too_thin", message, body.Source, places));
    }

    private static string Mm(double value) => NumberFormatter.Format(value, 2);
}
