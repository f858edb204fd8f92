namespace Caterpillar.Slicing;

/// <summary>One level of bodies that share their layers, with its supports.</summary>
/// <param name="work">The layer that prints the supports of the level.</param>
internal sealed class SupportLevel(LayerWork work)
{
    public LayerWork Work { get; } = work;

    public double Top => Work.Plan.Top;

    public double Thickness => Work.Plan.Thickness;

    /// <summary>What the bodies cover.</summary>
    public Region Part { get; set; } = Region.Empty;

    /// <summary>What supports keep out of: all bodies and their distance from them.</summary>
    public Region Forbidden { get; set; } = Region.Empty;

    /// <summary>The same and, where it reaches out of that, what is above and below within the gaps.</summary>
    public Region[] Obstacles { get; set; } = [];

    /// <summary>Overhangs of this level that are too long.</summary>
    public Region Overhang { get; set; } = Region.Empty;

    /// <summary>The overhangs of higher levels that are held from right here.</summary>
    public Region Contact { get; set; } = Region.Empty;

    /// <summary>What the supports cover.</summary>
    public Region Pieces { get; set; } = Region.Empty;

    /// <summary>Where pieces are dense.</summary>
    public Region Interface { get; set; } = Region.Empty;

    /// <summary>What rests on the tips of trees: dense lines below what they hold, or rows of lines from tip to tip that carry those.</summary>
    public Region[] Roofs { get; set; } = [];
}

/// <summary>Bodies whose layers are at the same heights, from the bed up.</summary>
internal sealed class SupportStack(PrintSettings settings, SupportLevel[] levels)
{
    public PrintSettings Settings { get; } = settings;

    /// <summary>Width of extrusions, mm.</summary>
    public double LineWidth { get; } = settings.WidthOf(settings.SupportLineWidth, false);

    public SupportLevel[] Levels { get; } = levels;

    /// <summary>The stacks of all bodies that want supports: those of equal settings together, unless each object is printed on its own.</summary>
    public static List<SupportStack> Of(IReadOnlyList<Body> bodies, PrintSettings common)
    {
        var stacks = new List<SupportStack>();
        var left = bodies.Where(b => b.Layers.Length > 0 && b.Layers[0].Rules.Settings is { Support: not SupportKind.None, SpiralVase: false }).ToList();
        while (left.Count > 0)
        {
            var settings = left[0].Layers[0].Rules.Settings;
            var alone = common.PrintSequence == PrintSequence.ByObject || settings.AdaptiveLayers;
            var members = alone ? [left[0]] : left.Where(b => b.Layers[0].Rules.Settings == settings).ToList();
            left.RemoveAll(members.Contains);
            var tallest = members.OrderByDescending(b => b.Layers.Length).ThenBy(b => b.Number).First();
            var levels = new SupportLevel[tallest.Layers.Length];
            for (var i = 0; i < levels.Length; i++)
            {
                var at = i;
                var part = Region.Union(members.Where(b => at < b.Layers.Length).Select(b => b.Layers[at].Region));
                levels[i] = new SupportLevel(tallest.Layers[i]) { Part = part };
            }
            stacks.Add(new SupportStack(settings, levels));
        }
        return stacks;
    }

    /// <summary>The contacts that so many layers hold, of which a level is the lowest.</summary>
    public Region[] ContactsOver(int level, int layers)
        => Levels.Skip(level).Take(layers).Select(l => l.Contact).Where(c => !c.IsEmpty).ToArray();

    /// <summary>The highest level that ends at or below a height, or −1.</summary>
    public int LevelBelow(double z)
    {
        const double Rounding = 1e-6;
        return Search.First(0, Levels.Length, (Levels, Z: z + Rounding), static (s, i) => s.Levels[i].Top > s.Z) - 1;
    }
}
