namespace Caterpillar.Checks;

/// <summary>Heights of flat extrusions, from which the layers of a file without layer comments are made.</summary>
internal static class FlatHeights
{
    /// <summary>The heights in mm in the order of the plan, as they are written, whenever they change. Null if comments begin the layers.</summary>
    public static IEnumerable<double>? Of(Toolpath plan, int decimals) => plan.Layers.Count > 0 ? null : In(plan, decimals);

    private static IEnumerable<double> In(Toolpath plan, int decimals)
    {
        long before = long.MinValue, last = long.MinValue;
        foreach (var block in plan.Blocks)
        {
            var c = block.Columns;
            for (var i = 0; i < c.Count; i++)
            {
                var height = NumberFormatter.ToUnits(c.Z[i], decimals);
                if (height == before && height != last && c.Kind[i] == MoveKind.Print) yield return NumberFormatter.FromUnits(last = height, decimals);
                before = height;
            }
        }
    }
}
