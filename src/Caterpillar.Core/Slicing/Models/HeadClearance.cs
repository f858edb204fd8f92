namespace Caterpillar.Slicing;

/// <summary>Clearance of the print head next to printed models.</summary>
internal static class HeadClearance
{
    /// <summary>
    /// Distance in mm that the nozzle must keep from something as high as stated while it prints on the bed: from the outline of the head (straight
    /// between its points) and from the farthest corner of each of its boxes that hangs so low.
    /// </summary>
    public static double Beside(Printer printer, double height)
    {
        var distance = 0.0;
        var outline = printer.HeadOutline;
        for (var i = 0; i < outline.Count; i++)
        {
            if (height > outline[i].Height) distance = Math.Max(distance, outline[i].Radius);
            else if (i > 0 && height > outline[i - 1].Height)
            {
                var part = (height - outline[i - 1].Height) / (outline[i].Height - outline[i - 1].Height);
                distance = Math.Max(distance, outline[i - 1].Radius + part * (outline[i].Radius - outline[i - 1].Radius));
            }
        }
        return printer.HeadBoxes.Where(box => box.Min.Z < height).Select(box => box.ReachXY).Prepend(distance).Max();
    }
}
