using System;
using System.Linq;
using Caterpillar.CanvasPictures;

namespace Caterpillar.GH.Tests.Examples.Arranging;

/// <summary>Looks for the heights of an arrangement at which wires are short, cross little, and none is hidden by an object.</summary>
internal sealed class Search(Arrangement all)
{
    private const double Clear = 3;

    // A wire across the name of a stage.
    public const double Crossing = 1500;
    private const int Trials = 4000;
    private const int Starts = 20;

    // Starts after the first without a hidden wire.
    private const int MoreStarts = 2;

    // A wire under an object, compared with a pixel of height.
    private const double Hiding = 1_000_000;
    private readonly Node[] _passes = all.Movable.Where(n => n.Passing is not null).ToArray();
    private readonly Chance _chance = new();

    /// <summary>Leaves the arrangement at the best heights found.</summary>
    public void Run()
    {
        var first = State();
        var best = (Cost: double.MaxValue, State: first);
        var good = 0;
        for (var start = 0; start < Starts && good <= MoreStarts; start++)
        {
            first();
            Improve(ref best);
            if (best.Cost < Hiding) good++;
        }
        best.State();
    }

    // Tries other heights and orders, at first also worse ones, and keeps the best.
    private void Improve(ref (double Cost, Action State) best)
    {
        all.Settle();
        var cost = Cost();
        for (var trial = 0; trial < Trials; trial++)
        {
            var before = State();
            Change();
            all.Settle();
            var tried = Cost();
            var patience = 500.0 * (Trials - trial) / Trials;
            if (tried > cost + (_chance.Next(3) == 0 ? patience : 0))
            {
                before();
                continue;
            }
            cost = tried;
            if (cost < best.Cost) best = (cost, State());
        }
    }

    // What sets everything back to where it is now.
    private Action State()
    {
        var nodes = all.Movable.ConvertAll(n => (n, n.Order, n.Bias, n.Top));
        var blocks = all.Rows.ConvertAll(b => (b, b.Order, b.Bias, b.Top, b.Height));
        return () =>
        {
            foreach (var (node, order, bias, top) in nodes) (node.Order, node.Bias, node.Top) = (order, bias, top);
            foreach (var (block, order, bias, top, height) in blocks) (block.Order, block.Bias, block.Top, block.Height) = (order, bias, top, height);
        };
    }

    // Objects and stages move up or down; wires that pass change places with their neighbors.
    private void Change()
    {
        int Next(int count) => _chance.Next(count);
        var kind = Next(5);
        var row = all.Rows[Next(all.Rows.Count)];
        var node = all.Movable[Next(all.Movable.Count)];
        if (kind == 0) row.Bias = Next(4) == 0 ? 0 : row.Bias + (Next(17) - 8) * (Next(2) == 0 ? 8 : 40);
        else if (kind == 1 && all.Rows.Find(b => b.Step == row.Step && b.Order == row.Order + 1) is { } under)
            (row.Order, under.Order) = (under.Order, row.Order);
        else if (kind == 2 && _passes.Length > 0) Pass(_passes[Next(_passes.Length)], Next(2) == 0 ? 1 : -1);
        else node.Bias = Next(4) == 0 ? 0 : node.Bias + (Next(17) - 8) * (Next(2) == 0 ? 5 : 30);
    }

    private static void Pass(Node node, int down)
    {
        var other = node.Block.Nodes.Concat(node.Block.Passes).FirstOrDefault(n => n.Column == node.Column && n.Order == node.Order + down);
        if (other is not null) (node.Order, other.Order) = (other.Order, node.Order);
    }

    /// <summary>What a reader would pay for the heights as they are, in pixels.</summary>
    public double Cost()
    {
        foreach (var node in all.Nodes) node.Now = node.There();
        foreach (var block in all.Blocks) block.SetTitle();
        var wires = all.Links.ConvertAll(l => l.Now);
        double cost = 0;
        foreach (var wire in wires)
        {
            cost += Math.Abs(wire.End.Y - wire.Start.Y);
            foreach (var node in all.Nodes)
            {
                if (Faults.Hides(node.Now, wire, Clear)) cost += Hiding;
            }
            foreach (var block in all.Blocks)
            {
                if (Faults.Crosses(wire, block.Title)) cost += Crossing;
            }
        }
        for (var i = 0; i < wires.Count; i++)
        {
            for (var k = i + 1; k < wires.Count; k++)
            {
                if (Cross(wires[i], wires[k])) cost += 150;
                // Several wires at an input are read from above.
                if (wires[i].End == wires[k].End && wires[i].Start.Y > wires[k].Start.Y) cost += 200;
            }
        }
        var height = all.Blocks.Max(b => b.Top + b.Height) - all.Blocks.Min(b => b.Top);
        return cost + 3 * height + all.Blocks.Sum(b => b.Height);
    }

    // Wires cross where one is above the other at the begin of what they share, and below at its end.
    private static bool Cross(Wire a, Wire b)
    {
        double from = Math.Max(a.Start.X, b.Start.X), to = Math.Min(a.End.X, b.End.X);
        if (from >= to || a.Start == b.Start || a.End == b.End) return false;
        double Height(Wire w, double x)
        {
            var t = (x - w.Start.X) / (w.End.X - w.Start.X);
            return w.Start.Y + (w.End.Y - w.Start.Y) * t * t * (3 - 2 * t);
        }
        return (Height(a, from) - Height(b, from)) * (Height(a, to) - Height(b, to)) < 0;
    }
}
