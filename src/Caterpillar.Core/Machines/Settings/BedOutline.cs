namespace Caterpillar.Machines;

/// <summary>A bed from the points of its outline, as <c>0x0,220x0,220x220,0x220</c>.</summary>
/// <param name="Size">Its size, mm; Z is 0.</param>
/// <param name="Origin">Where X 0, Y 0 is.</param>
/// <param name="Shape">A rectangle, or round.</param>
internal sealed record BedOutline(Vec3 Size, BedOrigin Origin, BedShape Shape)
{
    /// <summary>The bed, or null if the text has no area.</summary>
    public static BedOutline? Read(string text)
    {
        var bounds = Bounds.Empty;
        var count = 0;
        foreach (var point in text.Split(','))
        {
            if (RawValues.ParseNumbers(point) is not object[] { Length: 2 } xy) return null;
            bounds = bounds.Include(new Vec3((double)xy[0], (double)xy[1]));
            count++;
        }
        if (bounds.IsEmpty || bounds.Size.X < 1 || bounds.Size.Y < 1) return null;
        // What a bed reaches beyond its corner is lost, which is safe.
        var centered = Math.Abs(bounds.Center.X) < bounds.Size.X / 10 && Math.Abs(bounds.Center.Y) < bounds.Size.Y / 10;
        var size = centered ? new Vec3(2 * Math.Min(-bounds.Min.X, bounds.Max.X), 2 * Math.Min(-bounds.Min.Y, bounds.Max.Y)) : bounds.Max.WithZ(0);
        return new BedOutline(size, centered ? BedOrigin.Center : BedOrigin.Corner, count > 12 ? BedShape.Round : BedShape.Rectangle);
    }

    /// <summary>The value of one of the keys of printers that describe the bed.</summary>
    /// <param name="key">The key.</param>
    /// <param name="height">Height of the build volume, mm.</param>
    public string ValueOf(string key, string height) => key switch
    {
        "origin" => Words.Snake(Origin.ToString()),
        "bed_shape" => Words.Snake(Shape.ToString()),
        _ => $"{NumberFormatter.Format(Size.X, 3)},{NumberFormatter.Format(Size.Y, 3)},{height}",
    };
}
