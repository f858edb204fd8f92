using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.CanvasPictures;

namespace Caterpillar.GH.Tests.Examples.Arranging;

/// <summary>A stage with its columns of objects, or the room of a wire that passes between stages.</summary>
internal sealed class Block(string name)
{
    private List<List<Node>> _columns = [];

    public string Name { get; } = name;

    public List<Node> Nodes { get; } = [];

    public List<Node> Passes { get; } = [];

    /// <summary>The wire that passes here, if this is no stage.</summary>
    public Link? Passing { get; init; }

    public int Step { get; set; }

    /// <summary>Place among the rows of its step, from the top.</summary>
    public int Order { get; set; }

    public double Top { get; set; }

    public double Height { get; set; } = 8;

    public double Right { get; private set; }

    public double Bias { get; set; }

    public double Wanted { get; set; }

    /// <summary>Where the name stands, which wires should not cross.</summary>
    public Box Title { get; private set; }

    /// <summary>The colored frame.</summary>
    public Box Area
    {
        get
        {
            var left = Title.X;
            return new Box(left, Top - Frame.Margin, Nodes.Max(n => n.X + n.Shape.Box.Width) + Frame.Margin - left, Height + 2 * Frame.Margin);
        }
    }

    /// <summary>Puts the objects into columns, in their order.</summary>
    public void SetColumns()
    {
        _columns = Nodes.Concat(Passes).GroupBy(n => n.Column).OrderBy(g => g.Key).Select(g => g.ToList()).ToList();
        foreach (var column in _columns)
        {
            for (var i = 0; i < column.Count; i++) column[i].Order = i;
        }
    }

    public void SetAcross(double x, double gap)
    {
        foreach (var column in _columns)
        {
            var width = column.Max(n => n.Shape.Box.Width);
            // Beside sliders, which are wide, what feeds the next column stands at its side, too.
            var right = column.Exists(n => n.IsSource);
            foreach (var node in column) node.X = right && node.Out.Exists(l => l.Inside) ? x + width - node.Shape.Box.Width : x;
            x += width + gap;
        }
        Right = Math.Max(x - gap, _columns[0].Min(n => n.X) + Letters.Width(Name) * 1.5);
    }

    public void SetTitle()
        => Title = new Box(_columns[0].Where(n => n.Passing is null).Min(n => n.X) - Frame.Margin,
            Top - Frame.Margin - Frame.Caption, Letters.Width(Name) * 1.5, Frame.Caption);

    /// <summary>Brings all objects as near to their wires as their order allows; at first wires may pass where they like.</summary>
    public void Settle(int sweeps, bool first)
    {
        for (var sweep = 0; sweep < sweeps; sweep++)
        {
            foreach (var column in sweep % 2 == 0 ? _columns : Enumerable.Reverse(_columns))
            {
                foreach (var node in column) node.Wanted = Wish(node) + node.Bias;
                var rows = Ordered(column.OrderBy(n => first && sweep < sweeps / 2 ? n.Wanted + n.Height / 2 : n.Order).ToList());
                var tops = Spread.Out(rows.Select(n => n.Wanted).ToArray(), rows.Select(n => n.Height).ToArray(), rows.Select(n => n.Above).ToArray());
                for (var i = 0; i < rows.Count; i++)
                {
                    rows[i].Top = tops[i];
                    rows[i].Order = i;
                }
            }
        }
        Trim();
    }

    /// <summary>Makes the stage as high as its objects need, which stay where they are.</summary>
    public void Fit() => Top += Trim();

    // Measures objects from the highest one; gives how far below the old top that is.
    private double Trim()
    {
        var least = Nodes.Min(n => n.Top - (n.Item.Look == Look.Component ? 14 : 0));
        foreach (var node in Nodes.Concat(Passes)) node.Top -= least;
        Height = Nodes.Max(n => n.Top + n.Height);
        return least;
    }

    // Wires pass anywhere; objects keep their rank.
    private static List<Node> Ordered(List<Node> rows)
    {
        var ranked = new Queue<Node>(rows.Where(n => n.Passing is null).OrderBy(n => n.Rank));
        return rows.ConvertAll(n => n.Passing is null ? ranked.Dequeue() : n);
    }

    private static double Wish(Node node)
    {
        if (node.Passing is { } wire)
        {
            double from = wire.From.Top + wire.FromY, to = wire.To.Top + wire.ToY;
            return (wire.Inside ? (from + to) / 2 : wire.To.Block == node.Block ? to : from) - node.Height / 2;
        }
        var wishes = node.In.Where(l => l.Inside).Select(l => l.From.Top + l.FromY - l.ToY)
            .Concat(node.Out.Where(l => l.Inside).Select(l => l.To.Top + l.ToY - l.FromY)).ToArray();
        return wishes.Length == 0 ? node.Top : wishes.Average();
    }
}
