using System;
using System.Collections.Generic;
using System.Linq;

namespace Caterpillar.CanvasPictures;

/// <summary>A connection, as the curve that Grasshopper draws.</summary>
internal sealed record Wire(Placed From, int Output, Placed To, int Input)
{
    public Spot Start { get; } = From.OutputAt(Output);

    public Spot End { get; } = To.InputAt(Input);

    /// <summary>How far the handles of the Bézier curve reach out.</summary>
    public double Reach => Math.Max(Math.Abs(End.X - Start.X) / 2, 20);

    /// <summary>A point of the curve, at 0 to 1.</summary>
    public Spot At(double t)
    {
        double u = 1 - t, a = u * u * u, b = 3 * u * u * t, c = 3 * u * t * t, d = t * t * t;
        return new Spot(a * Start.X + b * (Start.X + Reach) + c * (End.X - Reach) + d * End.X, (a + b) * Start.Y + (c + d) * End.Y);
    }
}

/// <summary>A frame around objects, with the room for its name above them.</summary>
internal sealed record Frame(Group Group, Box Box)
{
    public const double Margin = 12;
    public const double Caption = 24;

    /// <summary>Where its name stands, above it.</summary>
    public Box Name => new(Box.X, Box.Y - Caption, Letters.Width(Group.NickName) * 1.5, Caption);

    /// <summary>Frame and name together.</summary>
    public Box Whole => Box.With(Name);
}

/// <summary>Where everything of a definition stands on the canvas.</summary>
internal sealed record Layout(IReadOnlyList<Placed> Objects, IReadOnlyList<Wire> Wires, IReadOnlyList<Frame> Frames)
{
    public static Layout Of(Definition definition)
    {
        var objects = definition.Items.Select(Placed.Of).ToArray();
        var ports = new Dictionary<Guid, (Placed Object, int Port)>();
        foreach (var placed in objects)
        {
            for (var i = 0; i < placed.Item.Outputs.Count; i++) ports[placed.Item.Outputs[i].Id] = (placed, i);
        }
        var wires = new List<Wire>();
        foreach (var placed in objects)
        {
            for (var i = 0; i < placed.Item.Inputs.Count; i++)
            {
                foreach (var source in placed.Item.Inputs[i].Sources.Where(ports.ContainsKey))
                    wires.Add(new Wire(ports[source].Object, ports[source].Port, placed, i));
            }
        }
        var byId = objects.ToDictionary(o => o.Item.Id);
        var frames = definition.Groups.Where(g => g.Members.Any(byId.ContainsKey)).Select(g => new Frame(g, Around(g, byId))).ToArray();
        return new Layout(objects, wires, frames);
    }

    /// <summary>What the drawing covers.</summary>
    public Box Extent => Objects.Select(o => o.Box).Concat(Frames.Select(f => f.Whole)).DefaultIfEmpty().Aggregate((a, b) => a.With(b));

    private static Box Around(Group group, IReadOnlyDictionary<Guid, Placed> byId)
        => group.Members.Where(byId.ContainsKey).Select(m => byId[m].Box).Aggregate((a, b) => a.With(b)).Grown(Frame.Margin);
}
