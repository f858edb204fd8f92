using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.CanvasPictures;

namespace Caterpillar.GH.Tests.Examples.Arranging;

/// <summary>
/// Pulls together what <see cref="Search"/> left apart. It moves objects that belong together at once, which the search can't; all orders and least
/// distances are kept.
/// </summary>
internal sealed class Tightening(Arrangement all, Func<double> cost)
{
    private const int Trials = 30000;

    // A gap in a stage or between the inputs of an object that a reader notices.
    private const double Empty = 150;

    // A pixel of empty height in a stage, and one between the inputs of an object, compared with a pixel of height of a wire.
    private const double Tall = 2;
    private const double Torn = 4;

    // How far apart the inputs of an object may be and still look as one.
    private const double Together = 60;

    // A wire across the name of a component.
    private const double Struck = 600;
    private const double NameHeight = 14;

    // A wire across a stage that it has no end in.
    private const double Strange = 300;

    // How much worse a try may be at the beginning.
    private const double Patience = 400;
    private const double Rounding = 0.001;
    private readonly Chance _chance = new();
    private readonly List<Node>[] _columns = all.Nodes.GroupBy(n => (n.Block, n.Column)).Select(g => g.OrderBy(n => n.Top).ToList()).ToArray();
    private readonly List<Block>[] _steps = all.Blocks.GroupBy(b => b.Step).Select(g => g.OrderBy(b => b.Top).ToList()).ToArray();

    // The inputs of each object that stand beside it.
    private readonly List<Node>[] _sources = all.Nodes
        .Select(n => n.In.Where(l => l.Inside && l.From.IsSource && l.From.Column == n.Column - 1).Select(l => l.From).Distinct().OrderBy(f => f.Top).ToList())
        .Where(s => s.Count > 1).ToArray();

    /// <summary>Leaves the arrangement at the best heights found; one without much empty space or a wire across a name stays as it is.</summary>
    public void Run()
    {
        var now = Cost();
        if (all.Blocks.Max(Band) < Empty && !_sources.Any(s => Gaps(s) > Empty) && !all.Links.Exists(CrossesName)) return;
        var best = (Cost: now, Heights: Heights());
        for (var trial = 0; trial < Trials; trial++)
        {
            var before = Heights();
            var worse = _chance.Next(3) == 0 ? Patience * (Trials - trial) / Trials * _chance.Next(100) / 100 : 0;
            Change();
            foreach (var block in all.Blocks) block.Fit();
            var tried = Fits() ? Cost() : double.MaxValue;
            if (tried > now + worse)
            {
                Set(before);
                continue;
            }
            now = tried;
            if (now < best.Cost) best = (now, Heights());
        }
        Set(best.Heights);
    }

    private double Cost()
        => cost() + Tall * all.Blocks.Sum(b => b.Height) + Torn * _sources.Sum(Gaps) + Search.Crossing * all.Links.Count(CrossesName)
            + all.Links.Sum(l => Struck * NamesUnder(l) + Strange * StagesUnder(l));

    // The name stands on the frame, which the search believes to begin above the names of components.
    private bool CrossesName(Link link)
    {
        var wire = link.Now;
        return all.Blocks.Exists(b => Faults.Crosses(wire, b.Title with { Y = b.Nodes.Min(n => n.Now.Box.Y) - Frame.Margin - Frame.Caption }));
    }

    // The stages that a wire runs across without an end in them.
    private int StagesUnder(Link link)
    {
        var wire = link.Now;
        return all.Blocks.Count(b => b != link.From.Block && b != link.To.Block && Faults.Crosses(wire, b.Area));
    }

    // The names of components that a wire runs across.
    private int NamesUnder(Link link)
    {
        var wire = link.Now;
        return all.Nodes.Count(n => n.Item.Look == Look.Component && Faults.Hides(Name(n), wire));
    }

    private static Placed Name(Node node)
    {
        var box = node.Now.Box;
        var width = Letters.Width(node.Item.Name);
        return node.Now with { Box = new Box(box.MiddleX - width / 2, box.Y - NameHeight, width, NameHeight) };
    }

    private static double Gaps(List<Node> sources)
    {
        double gaps = 0;
        for (var i = 1; i < sources.Count; i++) gaps += Math.Max(sources[i].Top - sources[i - 1].Top - sources[i - 1].Height - Together, 0);
        return gaps;
    }

    // Height of the largest band across a stage in which nothing stands.
    private static double Band(Block block)
    {
        double band = 0, bottom = block.Nodes.Min(n => n.Top);
        foreach (var node in block.Nodes.OrderBy(n => n.Top))
        {
            band = Math.Max(band, node.Top - bottom);
            bottom = Math.Max(bottom, node.Top + node.Height);
        }
        return band;
    }

    private void Change()
    {
        var distance = (_chance.Next(2) == 0 ? 1 : -1) * (1 + _chance.Next(16)) * (1 << _chance.Next(6));
        var node = all.Nodes[_chance.Next(all.Nodes.Count)];
        switch (_chance.Next(7))
        {
            case 0:
                node.Top += distance;
                break;
            case 1:
                foreach (var other in Near(node, 1 + _chance.Next(3))) other.Top += distance;
                break;
            case 2:
                foreach (var other in node.In.Where(l => l.Inside && l.From.IsSource).Select(l => l.From).Distinct()) other.Top += distance;
                break;
            case 3:
                foreach (var other in node.Block.Nodes.Where(n => n.Top >= node.Top).ToList()) other.Top += distance;
                break;
            case 4:
                node.Block.Top += distance;
                break;
            case 5:
                if (_sources.Length > 0) Pack(_sources[_chance.Next(_sources.Length)], distance);
                break;
            default:
                var height = node.Block.Top + node.Top;
                foreach (var other in all.Nodes.Where(n => n.Block.Top + n.Top >= height).ToList()) other.Top += distance;
                break;
        }
    }

    // Stacks inputs close together, near where one of them was.
    private void Pack(List<Node> sources, double distance)
    {
        sources[0].Top = sources[_chance.Next(sources.Count)].Top + distance;
        for (var i = 1; i < sources.Count; i++) sources[i].Top = sources[i - 1].Top + sources[i - 1].Height + sources[i].Above;
    }

    // The object, those that follow on the wire from its first output, and the inputs of them all.
    private static HashSet<Node> Near(Node node, int count)
    {
        var near = new HashSet<Node>();
        for (var i = 0; i < count; i++)
        {
            near.Add(node);
            near.UnionWith(node.In.Where(l => l.Inside && l.From.IsSource).Select(l => l.From));
            if (node.Out.Count == 0) break;
            node = node.Out[0].To;
        }
        return near;
    }

    // Whether all distances between neighbors are kept.
    private bool Fits()
    {
        foreach (var column in _columns)
        {
            for (var i = 1; i < column.Count; i++)
            {
                if (column[i].Top < column[i - 1].Top + column[i - 1].Height + column[i].Above - Rounding) return false;
            }
        }
        foreach (var step in _steps)
        {
            for (var i = 1; i < step.Count; i++)
            {
                if (step[i].Top < step[i - 1].Top + step[i - 1].Height + Arrangement.Between(step[i - 1], step[i]) - Rounding) return false;
            }
        }
        return true;
    }

    private double[] Heights() => [.. all.Nodes.Select(n => n.Top), .. all.Blocks.SelectMany(b => new[] { b.Top, b.Height })];

    private void Set(double[] heights)
    {
        for (var i = 0; i < all.Nodes.Count; i++) all.Nodes[i].Top = heights[i];
        for (var i = 0; i < all.Blocks.Count; i++)
        {
            all.Blocks[i].Top = heights[all.Nodes.Count + 2 * i];
            all.Blocks[i].Height = heights[all.Nodes.Count + 2 * i + 1];
        }
    }
}
