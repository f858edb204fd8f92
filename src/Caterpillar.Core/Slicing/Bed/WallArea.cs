namespace Caterpillar.Slicing;

/// <summary>The area that single walls cover, for layers without any other area.</summary>
internal static class WallArea
{
    /// <summary>The region of a layer; if it has none, what its extrusions cover in plan.</summary>
    public static Region Of(SlicedLayer layer, BeadShape shape)
        => layer.Region.IsEmpty ? Region.From(layer.Steps.SelectMany(s => Strips(s.Path, shape)), FillRule.NonZero) : layer.Region;

    private static IEnumerable<Polyline> Strips(PrintPath path, BeadShape shape)
    {
        for (var i = 0; i < path.SegmentCount; i++)
        {
            Vec3 from = path.RawPoints[i], along = (path.EndOf(i) - from).WithZ(0);
            if (along.LengthXY == 0) continue;
            var half = path.BeadOf(i).Width(shape) / 2;
            var ahead = along.Unit() * half;
            var aside = new Vec3(-ahead.Y, ahead.X);
            yield return new Polyline([from - ahead - aside, from + along + ahead - aside, from + along + ahead + aside, from - ahead + aside], closed: true);
        }
    }
}
