using System.Collections.Generic;
using System.Linq;
using Caterpillar.CanvasPictures;

namespace Caterpillar.GH.Tests.Examples.Arranging;

/// <summary>A wire from an output to an input.</summary>
internal sealed class Link(Node from, int output, Node to, int input)
{
    public Node From { get; } = from;

    public int Output { get; } = output;

    /// <summary>Height of the output below the top of its object.</summary>
    public double FromY { get; } = from.Shape.OutputAt(output).Y - from.Shape.Box.Y;

    public Node To { get; } = to;

    public int Input { get; } = input;

    public double ToY { get; } = to.Shape.InputAt(input).Y - to.Shape.Box.Y;

    public bool Inside => From.Block == To.Block;

    /// <summary>The wire where its objects are tried.</summary>
    public Wire Now => new(From.Now, Output, To.Now, Input);
}

/// <summary>An object of a stage, or the room of a wire that passes a column of it.</summary>
internal sealed class Node
{
    private const double PassHeight = 8;

    public Node(Item item, Block block, int rank)
    {
        Block = block;
        Rank = rank;
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

    /// <summary>Place among the rows of its column, from the top.</summary>
    public int Order { get; set; }

    /// <summary>How it is read among the objects of its column: components in the order of the definition, inputs as what they feed.</summary>
    public double Rank { get; set; }

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
