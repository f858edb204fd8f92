using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.CanvasPictures;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>
/// Places the objects of a definition: stages from left to right by what they need, those of one step below each other; inside a stage columns by what feeds
/// what, with inputs next to what they feed. Heights then follow the wires, until none is hidden by an object.
/// </summary>
internal sealed class Arrangement
{
    private const double ColumnGap = 44;
    private const double StageGap = 44;
    private const double Left = 40;
    private const double Top = 40;
    private const double Clear = 3;

    // A wire across the name of a stage.
    private const double Crossing = 1500;
    private const int Trials = 2000;
    private const int Starts = 10;

    // A wire under an object, compared with a pixel of height.
    private const double Hiding = 1_000_000;
    private readonly List<Node> _nodes = [];
    private readonly List<Block> _blocks = [];
    private readonly List<Link> _links = [];
    private readonly List<Block> _passing = [];
    private readonly List<Node> _movable = [];
    private readonly List<Block> _rows = [];
    private readonly Definition _definition;
    private uint _random = 2463534242;

    /// <summary>Each group of the definition is a stage; what is in none stands above all.</summary>
    public Arrangement(Definition definition)
    {
        _definition = definition;
        foreach (var group in definition.Groups)
        {
            var block = new Block(group.NickName);
            foreach (var item in definition.Items.Where(i => group.Members.Contains(i.Id))) block.Nodes.Add(new Node(item, block));
            _blocks.Add(block);
            _nodes.AddRange(block.Nodes);
        }
        Connect();
        foreach (var block in _blocks) SetColumns(block);
        SetSteps();
        SetPasses();
        SetAcross();
    }

    /// <summary>Where the pivots belong, by id.</summary>
    public Dictionary<Guid, Spot> Run()
    {
        foreach (var block in _blocks) block.Settle(24, true);
        SettleBlocks(true);
        var best = (Cost: double.MaxValue, State: State());
        for (var start = 0; start < Starts && best.Cost >= Hiding; start++)
        {
            best.State();
            Improve(ref best);
        }
        best.State();
        var up = _blocks.Min(b => b.Top) - Frame.Margin - Frame.Caption;
        var notes = _definition.Items.Where(i => _nodes.All(n => n.Item.Id != i.Id)).ToArray();
        var all = new Dictionary<Guid, Spot>();
        double y = Top, x = Left;
        foreach (var note in notes)
        {
            all.Add(note.Id, new Spot(x, y));
            x += note.Bounds.Width + 20;
        }
        var down = notes.Length == 0 ? Top - up : Top + notes.Max(n => n.Bounds.Height) + 24 - up;
        foreach (var node in _nodes) all.Add(node.Item.Id, new Spot(Math.Round(node.X - node.Shape.Box.X),
            Math.Round(node.Top + node.Block.Top + down - node.Shape.Box.Y)));
        return all;
    }

    private void Connect()
    {
        var outputs = new Dictionary<Guid, (Node Node, int Port)>();
        foreach (var node in _nodes)
        {
            for (var i = 0; i < node.Item.Outputs.Count; i++) outputs[node.Item.Outputs[i].Id] = (node, i);
        }
        foreach (var node in _nodes)
        {
            for (var i = 0; i < node.Item.Inputs.Count; i++)
            {
                foreach (var source in node.Item.Inputs[i].Sources)
                {
                    var (from, port) = outputs[source];
                    var link = new Link(from, port, node, i);
                    _links.Add(link);
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
        // Inputs stand beside what they feed.
        foreach (var node in block.Nodes.Where(n => !n.In.Any(l => l.Inside) && n.Out.Any(l => l.Inside)))
        {
            node.Column = node.Out.Where(l => l.Inside).Min(l => l.To.Column) - 1;
            node.IsSource = true;
        }
        block.SetColumns();
    }

    // A stage stands after all stages that it needs.
    private void SetSteps()
    {
        for (int changed = 1, rounds = 0; changed > 0; rounds++)
        {
            if (rounds > _blocks.Count) throw new InvalidOperationException("The stages need each other: " + string.Join(", ", _blocks.Select(b => b.Name)));
            changed = 0;
            foreach (var link in _links.Where(l => !l.Inside && l.To.Block.Step <= l.From.Block.Step))
            {
                link.To.Block.Step = link.From.Block.Step + 1;
                changed++;
            }
        }
        // What needs nothing stands next to what it feeds; a setup is read first.
        foreach (var block in _blocks.Where(b => b.Name != "Setup" && !_links.Any(l => !l.Inside && l.To.Block == b)))
        {
            var next = _links.Where(l => !l.Inside && l.From.Block == block).Select(l => l.To.Block.Step).DefaultIfEmpty(1).Min();
            block.Step = Math.Max(next - 1, 0);
        }
    }

    // Where a wire passes a column or a stage, it takes room as an object would.
    private void SetPasses()
    {
        foreach (var block in _blocks)
        {
            var last = block.Nodes.Max(n => n.Column);
            var passes = new HashSet<(Node, int, int)>();
            foreach (var link in _links.Where(l => l.From.Block == block || l.To.Block == block))
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
        foreach (var link in _links)
        {
            for (var step = link.From.Block.Step + 1; step < link.To.Block.Step; step++)
            {
                if (_passing.Any(p => p.Step == step && p.Passing!.From == link.From && p.Passing.Output == link.Output)) continue;
                _passing.Add(new Block("") { Step = step, Passing = link });
            }
        }
        _movable.AddRange(_nodes);
        _movable.AddRange(_blocks.SelectMany(b => b.Passes));
        _rows.AddRange(_blocks);
        _rows.AddRange(_passing);
    }

    private void SetAcross()
    {
        var x = Left + Frame.Margin;
        foreach (var step in _blocks.GroupBy(b => b.Step).OrderBy(g => g.Key))
        {
            foreach (var block in step) block.SetAcross(x, ColumnGap);
            x = step.Max(b => b.Right) + 2 * Frame.Margin + StageGap;
        }
    }

    private void SettleBlocks(bool sort)
    {
        foreach (var block in _rows) block.Top = 0;
        for (var sweep = 0; sweep < 8; sweep++)
        {
            foreach (var step in _rows.GroupBy(b => b.Step).OrderBy(g => sweep % 2 == 0 ? g.Key : -g.Key))
            {
                var rows = step.OrderBy(b => b.Order).ToList();
                foreach (var block in rows) block.Wanted = Wish(block) + block.Bias;
                if (sort && sweep < 4) rows = rows.OrderBy(b => b.Wanted + b.Height / 2).ToList();
                for (var i = 0; i < rows.Count; i++) rows[i].Order = i;
                var tops = Spread.Out(rows.Select(b => b.Wanted).ToArray(), rows.Select(b => b.Height).ToArray(),
                    rows.Select((b, i) => Between(i == 0 ? b : rows[i - 1], b)).ToArray());
                for (var i = 0; i < rows.Count; i++) rows[i].Top = tops[i];
            }
        }
    }

    private static double Between(Block above, Block below)
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

    // Tries other heights and orders, at first also worse ones, and keeps the best.
    private void Improve(ref (double Cost, Action State) best)
    {
        Settle();
        var cost = Cost();
        for (var trial = 0; trial < Trials; trial++)
        {
            var before = State();
            Change();
            Settle();
            var tried = Cost();
            var patience = 500.0 * (Trials - trial) / Trials;
            if (tried > cost + (Next(3) == 0 ? patience : 0))
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
        var nodes = _movable.ConvertAll(n => (n, n.Order, n.Bias, n.Top));
        var blocks = _rows.ConvertAll(b => (b, b.Order, b.Bias, b.Top, b.Height));
        return () =>
        {
            foreach (var (node, order, bias, top) in nodes) (node.Order, node.Bias, node.Top) = (order, bias, top);
            foreach (var (block, order, bias, top, height) in blocks) (block.Order, block.Bias, block.Top, block.Height) = (order, bias, top, height);
        };
    }

    private void Settle()
    {
        foreach (var block in _blocks) block.Settle(6, false);
        SettleBlocks(false);
    }

    private void Change()
    {
        var kind = Next(5);
        var row = _rows[Next(_rows.Count)];
        var node = _movable[Next(_movable.Count)];
        if (kind == 0) row.Bias = Next(4) == 0 ? 0 : row.Bias + (Next(17) - 8) * (Next(2) == 0 ? 8 : 40);
        else if (kind == 1 && _rows.Find(b => b.Step == row.Step && b.Order == row.Order + 1) is { } under) (row.Order, under.Order) = (under.Order, row.Order);
        else if (kind == 2 && node.Block.Nodes.Concat(node.Block.Passes).FirstOrDefault(n => n.Column == node.Column && n.Order == node.Order + 1) is { } below)
            (node.Order, below.Order) = (below.Order, node.Order);
        else node.Bias = Next(4) == 0 ? 0 : node.Bias + (Next(17) - 8) * (Next(2) == 0 ? 5 : 30);
    }

    private double Cost()
    {
        foreach (var node in _nodes) node.Now = node.There();
        foreach (var block in _blocks) block.SetTitle();
        var wires = _links.ConvertAll(l => new Wire(l.From.Now, l.Output, l.To.Now, l.Input));
        double cost = 0;
        foreach (var wire in wires)
        {
            cost += Math.Abs(wire.End.Y - wire.Start.Y);
            foreach (var node in _nodes)
            {
                if (Faults.Hides(node.Now, wire, Clear)) cost += Hiding;
            }
            foreach (var block in _blocks)
            {
                if (Faults.Hides(block.Title, wire)) cost += Crossing;
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
        var height = _blocks.Max(b => b.Top + b.Height) - _blocks.Min(b => b.Top);
        return cost + 1.5 * height;
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

    private int Next(int count)
    {
        _random ^= _random << 13;
        _random ^= _random >> 17;
        _random ^= _random << 5;
        return (int)(_random % (uint)count);
    }

    private sealed class Link(Node from, int output, Node to, int input)
    {
        public Node From { get; } = from;

        public int Output { get; } = output;

        /// <summary>Height of the output below the top of its object.</summary>
        public double FromY { get; } = from.Shape.OutputAt(output).Y - from.Shape.Box.Y;

        public Node To { get; } = to;

        public int Input { get; } = input;

        public double ToY { get; } = to.Shape.InputAt(input).Y - to.Shape.Box.Y;

        public bool Inside => From.Block == To.Block;
    }

    private sealed class Node
    {
        private const double PassHeight = 8;

        public Node(Item item, Block block)
        {
            Block = block;
            Shape = Placed.Of(item with { Pivot = default, Bounds = item.Bounds with { X = 0, Y = 0 } });
            Now = Shape;
            Height = Shape.Box.Height;
            Above = item.Look == Look.Component ? 28 : 12;
        }

        /// <summary>Where a wire passes a column.</summary>
        public Node(Link passing, int column, Block block)
        {
            Block = block;
            Passing = passing;
            Column = column;
            Height = PassHeight;
            Above = PassHeight;
            Shape = Now = new Placed(passing.From.Shape.Item, default, default, [], []);
        }

        public Item Item => Shape.Item;

        /// <summary>The object with its pivot at the origin.</summary>
        public Placed Shape { get; }

        /// <summary>The object where it is tried.</summary>
        public Placed Now { get; set; }

        public Link? Passing { get; }

        public Block Block { get; }

        public List<Link> In { get; } = [];

        public List<Link> Out { get; } = [];

        public int Column { get; set; }

        public int Order { get; set; }

        public bool IsSource { get; set; }

        public double X { get; set; }

        /// <summary>Below the top of its block.</summary>
        public double Top { get; set; }

        public double Height { get; }

        // Names of components stand above them.
        public double Above { get; }

        public double Bias { get; set; }

        public double Wanted { get; set; }

        public Placed There()
        {
            double dx = X - Shape.Box.X, dy = Block.Top + Top - Shape.Box.Y;
            return new Placed(Shape.Item, Shape.Box.Moved(dx, dy), Shape.Core.Moved(dx, dy), Shape.Inputs.Select(b => b.Moved(dx, dy)).ToArray(),
                Shape.Outputs.Select(b => b.Moved(dx, dy)).ToArray());
        }
    }

    private sealed class Block(string name)
    {
        private List<List<Node>> _columns = [];

        public string Name { get; } = name;

        public List<Node> Nodes { get; } = [];

        public List<Node> Passes { get; } = [];

        /// <summary>The wire that passes here, if this is no stage.</summary>
        public Link? Passing { get; init; }

        public int Step { get; set; }

        public int Order { get; set; }

        public double Top { get; set; }

        public double Height { get; set; } = 8;

        public double Right { get; private set; }

        public double Bias { get; set; }

        public double Wanted { get; set; }

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
                foreach (var node in column) node.X = node.IsSource ? x + width - node.Shape.Box.Width : x;
                x += width + gap;
            }
            Right = Math.Max(x - gap, _columns[0].Min(n => n.X) + Letters.Width(Name) * 1.5);
        }

        /// <summary>Where the name stands, as an object that wires should not cross.</summary>
        public Placed Title { get; private set; } = new(null!, default, default, [], []);

        public void SetTitle()
            => Title = Title with { Box = new Box(_columns[0].Where(n => n.Passing is null).Min(n => n.X) - Frame.Margin,
                Top - Frame.Margin - Frame.Caption, Letters.Width(Name) * 1.5, Frame.Caption) };

        public void Settle(int sweeps, bool sort)
        {
            for (var sweep = 0; sweep < sweeps; sweep++)
            {
                foreach (var column in sweep % 2 == 0 ? _columns : Enumerable.Reverse(_columns))
                {
                    foreach (var node in column) node.Wanted = Wish(node) + node.Bias;
                    var rows = sort && sweep < sweeps / 2 ? column.OrderBy(n => n.Wanted + n.Height / 2).ToList() : column.OrderBy(n => n.Order).ToList();
                    var tops = Spread.Out(rows.Select(n => n.Wanted).ToArray(), rows.Select(n => n.Height).ToArray(), rows.Select(n => n.Above).ToArray());
                    for (var i = 0; i < rows.Count; i++)
                    {
                        rows[i].Top = tops[i];
                        rows[i].Order = i;
                    }
                }
            }
            var least = Nodes.Min(n => n.Top - (n.Item.Look == Look.Component ? 14 : 0));
            foreach (var node in Nodes.Concat(Passes)) node.Top -= least;
            Height = Nodes.Max(n => n.Top + n.Height);
        }

        private static double Wish(Node node)
        {
            if (node.Passing is { } wire)
            {
                double from = wire.From.Top + wire.FromY, to = wire.To.Top + wire.ToY;
                return (wire.Inside ? (from + to) / 2 : wire.To.Block == node.Block ? to : from) - node.Height / 2;
            }
            double sum = 0;
            var count = 0;
            foreach (var link in node.In.Where(l => l.Inside))
            {
                sum += link.From.Top + link.FromY - link.ToY;
                count++;
            }
            foreach (var link in node.Out.Where(l => l.Inside))
            {
                sum += link.To.Top + link.ToY - link.FromY;
                count++;
            }
            return count == 0 ? node.Top : sum / count;
        }
    }
}
