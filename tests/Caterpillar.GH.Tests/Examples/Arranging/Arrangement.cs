using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.CanvasPictures;

namespace Caterpillar.GH.Tests.Examples.Arranging;

/// <summary>
/// Places the objects of a definition: stages from left to right by what they need, those of one step below each other in their order; inside a stage columns
/// by what feeds what, with inputs next to what they feed. Heights then follow the wires; <see cref="Search"/> betters them, and
/// <see cref="Tightening"/> takes out empty space.
/// </summary>
internal sealed class Arrangement
{
    private const double ColumnGap = 44;
    private const double StageGap = 44;
    private const double Left = 40;
    private const double Top = 40;
    private readonly List<Block> _passing = [];
    private readonly Definition _definition;

    /// <summary>Each group of the definition is a stage; what is in none stands above all.</summary>
    public Arrangement(Definition definition)
    {
        _definition = definition;
        foreach (var group in definition.Groups)
        {
            var block = new Block(group.NickName);
            foreach (var item in definition.Items.Where(i => group.Members.Contains(i.Id)))
                block.Nodes.Add(new Node(item, block, Nodes.Count + block.Nodes.Count));
            Blocks.Add(block);
            Nodes.AddRange(block.Nodes);
        }
        Connect();
        foreach (var block in Blocks) SetColumns(block);
        SetSteps();
        SetPasses();
        SetAcross();
    }

    public List<Node> Nodes { get; } = [];

    public List<Link> Links { get; } = [];

    /// <summary>The stages.</summary>
    public List<Block> Blocks { get; } = [];

    /// <summary>Objects, and the rooms of wires that pass columns.</summary>
    public List<Node> Movable { get; } = [];

    /// <summary>Stages, and the rooms of wires that pass between them.</summary>
    public List<Block> Rows { get; } = [];

    /// <summary>Where the pivots belong, by id.</summary>
    public Dictionary<Guid, Spot> Run()
    {
        foreach (var block in Blocks) block.Settle(24, true);
        SettleBlocks(true);
        var search = new Search(this);
        search.Run();
        new Tightening(this, search.Cost).Run();
        var notes = _definition.Items.Where(i => Nodes.All(n => n.Item.Id != i.Id)).ToArray();
        var all = new Dictionary<Guid, Spot>();
        var x = Left;
        // Notes stand close above what is below them.
        var right = Left + notes.Sum(n => n.Bounds.Width + 20);
        var bottom = Blocks.Where(b => b.Nodes.Min(n => n.X) - Frame.Margin < right).Min(b => b.Top) - Frame.Margin - Frame.Caption - 24;
        var up = notes.Select(n => bottom - n.Bounds.Height).Concat(Blocks.Select(b => b.Top - Frame.Margin - Frame.Caption)).Min();
        foreach (var note in notes)
        {
            all.Add(note.Id, new Spot(x, Math.Round(bottom - note.Bounds.Height + Top - up)));
            x += note.Bounds.Width + 20;
        }
        foreach (var node in Nodes) all.Add(node.Item.Id, new Spot(Math.Round(node.X - node.Shape.Box.X),
            Math.Round(node.Top + node.Block.Top + Top - up - node.Shape.Box.Y)));
        return all;
    }

    /// <summary>Brings all as near to its wires as the orders allow.</summary>
    public void Settle()
    {
        foreach (var block in Blocks) block.Settle(6, false);
        SettleBlocks(false);
    }

    private void Connect()
    {
        var outputs = new Dictionary<Guid, (Node Node, int Port)>();
        foreach (var node in Nodes)
        {
            for (var i = 0; i < node.Item.Outputs.Count; i++) outputs[node.Item.Outputs[i].Id] = (node, i);
        }
        foreach (var node in Nodes)
        {
            for (var i = 0; i < node.Item.Inputs.Count; i++)
            {
                foreach (var source in node.Item.Inputs[i].Sources)
                {
                    var (from, port) = outputs[source];
                    var link = new Link(from, port, node, i);
                    Links.Add(link);
                    from.Out.Add(link);
                    node.In.Add(link);
                }
            }
        }
    }

    private static void SetColumns(Block block)
    {
        for (var changed = true; changed;)
        {
            changed = false;
            foreach (var link in block.Nodes.SelectMany(n => n.In).Where(l => l.Inside && l.To.Column <= l.From.Column))
            {
                link.To.Column = link.From.Column + 1;
                changed = true;
            }
        }
        // Inputs stand beside what they feed, in the order of its ports.
        foreach (var node in block.Nodes.Where(n => !n.In.Any(l => l.Inside) && n.Out.Any(l => l.Inside)))
        {
            var links = node.Out.Where(l => l.Inside).OrderBy(l => l.To.Rank).ToArray();
            node.Column = links.Min(l => l.To.Column) - 1;
            node.IsSource = true;
            if (node.Item.Look == Look.Component) continue;
            var middle = links[(links.Length - 1) / 2];
            node.Rank = middle.To.Rank - 1 + (middle.Input + 1) / 100.0;
        }
        block.SetColumns();
    }

    // A stage stands after all stages that it needs.
    private void SetSteps()
    {
        for (int changed = 1, rounds = 0; changed > 0; rounds++)
        {
            if (rounds > Blocks.Count) throw new InvalidOperationException("The stages need each other: " + string.Join(", ", Blocks.Select(b => b.Name)));
            changed = 0;
            foreach (var link in Links.Where(l => !l.Inside && l.To.Block.Step <= l.From.Block.Step))
            {
                link.To.Block.Step = link.From.Block.Step + 1;
                changed++;
            }
        }
        // What needs nothing stands next to what it feeds; a setup is read first.
        foreach (var block in Blocks.Where(b => b.Name != "Setup" && !Links.Any(l => !l.Inside && l.To.Block == b)))
        {
            var next = Links.Where(l => !l.Inside && l.From.Block == block).Select(l => l.To.Block.Step).DefaultIfEmpty(1).Min();
            block.Step = Math.Max(next - 1, 0);
        }
    }

    // Where a wire passes a column or a stage, it takes room as an object would.
    private void SetPasses()
    {
        foreach (var block in Blocks)
        {
            var last = block.Nodes.Max(n => n.Column);
            var passes = new HashSet<(Node, int, int)>();
            foreach (var link in Links.Where(l => l.From.Block == block || l.To.Block == block))
            {
                var first = link.From.Block == block ? link.From.Column + 1 : 0;
                var end = link.To.Block == block ? link.To.Column - 1 : last;
                for (var column = first; column <= end; column++)
                {
                    if (passes.Add((link.From, link.Output, column))) block.Passes.Add(new Node(link, column, block));
                }
            }
            block.SetColumns();
        }
        foreach (var link in Links)
        {
            for (var step = link.From.Block.Step + 1; step < link.To.Block.Step; step++)
            {
                if (_passing.Any(p => p.Step == step && p.Passing!.From == link.From && p.Passing.Output == link.Output)) continue;
                _passing.Add(new Block("") { Step = step, Passing = link });
            }
        }
        Movable.AddRange(Nodes);
        Movable.AddRange(Blocks.SelectMany(b => b.Passes));
        Rows.AddRange(Blocks);
        Rows.AddRange(_passing);
    }

    private void SetAcross()
    {
        var x = Left + Frame.Margin;
        foreach (var step in Blocks.GroupBy(b => b.Step).OrderBy(g => g.Key))
        {
            foreach (var block in step) block.SetAcross(x, ColumnGap);
            x = step.Max(b => b.Right) + 2 * Frame.Margin + StageGap;
        }
    }

    private void SettleBlocks(bool first)
    {
        foreach (var block in Rows) block.Top = 0;
        for (var sweep = 0; sweep < 8; sweep++)
        {
            foreach (var step in Rows.GroupBy(b => b.Step).OrderBy(g => sweep % 2 == 0 ? g.Key : -g.Key))
            {
                foreach (var block in step) block.Wanted = Wish(block) + block.Bias;
                var rows = Ordered(step.OrderBy(b => first && sweep < 4 ? b.Wanted + b.Height / 2 : b.Order).ToList());
                for (var i = 0; i < rows.Count; i++) rows[i].Order = i;
                var tops = Spread.Out(rows.Select(b => b.Wanted).ToArray(), rows.Select(b => b.Height).ToArray(),
                    rows.Select((b, i) => Between(i == 0 ? b : rows[i - 1], b)).ToArray());
                for (var i = 0; i < rows.Count; i++) rows[i].Top = tops[i];
            }
        }
    }

    // Wires pass anywhere; stages keep their order.
    private List<Block> Ordered(List<Block> rows)
    {
        var stages = new Queue<Block>(Blocks.Where(rows.Contains));
        return rows.ConvertAll(b => b.Passing is null ? stages.Dequeue() : b);
    }

    /// <summary>The least distance of neighbors in a step.</summary>
    public static double Between(Block above, Block below)
        => (above.Passing is null ? Frame.Margin + 7 : 2) + (below.Passing is null ? Frame.Margin + Frame.Caption + 7 : 2);

    private static double Wish(Block block)
    {
        if (block.Passing is { } link)
        {
            double from = link.From.Block.Top + link.From.Top + link.FromY, to = link.To.Block.Top + link.To.Top + link.ToY;
            double part = (double)(block.Step - link.From.Block.Step) / (link.To.Block.Step - link.From.Block.Step);
            return from + (to - from) * part * part * (3 - 2 * part) - block.Height / 2;
        }
        var outside = block.Nodes.SelectMany(n => n.In.Concat(n.Out)).Where(l => !l.Inside).ToArray();
        if (outside.Length == 0) return block.Top;
        return outside.Average(l => l.To.Block == block ? l.From.Block.Top + l.From.Top + l.FromY - l.To.Top - l.ToY
            : l.To.Block.Top + l.To.Top + l.ToY - l.From.Top - l.FromY);
    }
}
