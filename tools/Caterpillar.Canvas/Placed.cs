using System;
using System.Collections.Generic;
using System.Linq;

namespace Caterpillar.CanvasPictures;

/// <summary>An object where Grasshopper lays it out: its outline, and where wires leave and arrive.</summary>
internal sealed record Placed(Item Item, Box Box, Box Core, IReadOnlyList<Box> Inputs, IReadOnlyList<Box> Outputs)
{
    private const double Around = 2;
    private const double Icon = 24;
    private const double Gap = 3;
    private const double Row = 20;

    /// <summary>Lays an object out from its pivot, as Grasshopper does when a file is opened. Only what users can resize keeps its stored bounds.</summary>
    public static Placed Of(Item item) => item.Look switch
    {
        Look.Component => Component(item),
        Look.Parameter => Whole(item, Parameter(item)),
        _ => Whole(item, item.Bounds),
    };

    public Spot InputAt(int port) => new(Box.X, Inputs[port].MiddleY);

    public Spot OutputAt(int port) => new(Box.Right, Outputs[port].MiddleY);

    /// <summary>Width and height of an object with the size that its texts need.</summary>
    public static Box SizeOf(Item item)
    {
        var placed = Of(item with { Bounds = item.Bounds with { X = 0, Y = 0 }, Pivot = default });
        return placed.Box;
    }

    // Content is 24 high at least, 20 for each port; columns of ports stand beside a box for the icon, with 2 pixels around all.
    private static Placed Component(Item item)
    {
        double left = Column(item.Inputs, 0), right = Column(item.Outputs, Gap);
        var height = Math.Max(Icon, Row * Math.Max(item.Inputs.Count, item.Outputs.Count));
        double x = item.Pivot.X - Icon / 2, y = item.Pivot.Y - height / 2;
        var core = new Box(x, y, Icon, height);
        double start = item.Inputs.Count == 0 ? x : x - Gap - left, end = item.Outputs.Count == 0 ? x + Icon : x + Icon + Gap + right;
        var box = new Box(start, y, end - start, height).Grown(Around);
        return new Placed(item, box, core, Rows(item.Inputs, start, left, y, height), Rows(item.Outputs, end - right, right, y, height));
    }

    private static Box Parameter(Item item)
    {
        double width = Math.Max(50, Letters.Width(item.NickName) + 20), height = Row;
        return new Box(item.Pivot.X - width / 2, item.Pivot.Y - height / 2, width, height);
    }

    private static Placed Whole(Item item, Box box) => new(item, box, box, [box], [box]);

    private static double Column(IReadOnlyList<Port> ports, double more)
        => ports.Count == 0 ? 0 : ports.Max(p => 6.7 + more + Letters.Width(p.NickName) + (p.Tags == 0 ? 0 : 20 * p.Tags - 4));

    private static Box[] Rows(IReadOnlyList<Port> ports, double x, double width, double y, double height)
        => ports.Select((_, i) => new Box(x, y + height * i / ports.Count, width, height / ports.Count)).ToArray();
}
