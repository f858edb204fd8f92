using System;
using System.Collections.Generic;
using System.Linq;

namespace Caterpillar.CanvasPictures;

/// <summary>What a reader of a definition would stumble over.</summary>
internal static class Faults
{
    // Fonts differ by system: columns of ports may come out a tenth wider.
    private const double Wider = 0.1;
    private const double Apart = 4;
    private const double Least = 12;
    private const int Samples = 40;

    public static IReadOnlyList<string> Of(Layout layout)
        => [.. Overlaps(layout), .. Backward(layout), .. Hidden(layout), .. Struck(layout), .. Frames(layout)];

    private static IEnumerable<string> Overlaps(Layout layout)
    {
        var boxes = layout.Objects.Select(Allowed).ToArray();
        for (var i = 0; i < boxes.Length; i++)
        {
            for (var k = i + 1; k < boxes.Length; k++)
            {
                if (boxes[i].Meets(boxes[k])) yield return $"{NameOf(layout.Objects[i])} overlaps {NameOf(layout.Objects[k])}.";
            }
        }
    }

    private static IEnumerable<string> Backward(Layout layout)
        => layout.Wires.Where(w => w.End.X - w.Start.X < Least).Select(w => $"The wire from {NameOf(w.From)} to {NameOf(w.To)} runs back.");

    private static IEnumerable<string> Hidden(Layout layout)
    {
        foreach (var wire in layout.Wires)
        {
            foreach (var other in layout.Objects.Where(o => Hides(o, wire)))
                yield return $"The wire from {NameOf(wire.From)} to {NameOf(wire.To)} is hidden by {NameOf(other)}.";
        }
    }

    private static IEnumerable<string> Struck(Layout layout)
    {
        foreach (var wire in layout.Wires)
        {
            foreach (var frame in layout.Frames.Where(f => Crosses(wire, f.Name)))
                yield return $"The wire from {NameOf(wire.From)} to {NameOf(wire.To)} runs across the name of {frame.Group.NickName}.";
        }
    }

    /// <summary>Whether a wire comes nearer to an object that is none of its ends than the margin, in pixels.</summary>
    public static bool Hides(Placed other, Wire wire, double margin = 0)
        => !ReferenceEquals(other, wire.From) && !ReferenceEquals(other, wire.To) && Crosses(wire, other.Box.Grown(margin));

    /// <summary>Whether a wire runs through a box.</summary>
    public static bool Crosses(Wire wire, Box box)
    {
        if (box.Right < wire.Start.X || box.X > wire.End.X) return false;
        if (box.Bottom < Math.Min(wire.Start.Y, wire.End.Y) || box.Y > Math.Max(wire.Start.Y, wire.End.Y)) return false;
        for (var i = 1; i < Samples; i++)
        {
            if (box.Holds(wire.At((double)i / Samples))) return true;
        }
        return false;
    }

    private static IEnumerable<string> Frames(Layout layout)
    {
        var framed = new HashSet<Guid>(layout.Frames.SelectMany(f => f.Group.Members));
        foreach (var placed in layout.Objects.Where(o => !framed.Contains(o.Item.Id) && !IsNote(o.Item))) yield return $"{NameOf(placed)} is in no group.";
        for (var i = 0; i < layout.Frames.Count; i++)
        {
            var frame = layout.Frames[i];
            if (frame.Group.NickName.Length == 0) yield return "A group has no name.";
            foreach (var other in layout.Frames.Skip(i + 1).Where(f => f.Whole.Meets(frame.Whole)))
                yield return $"The group {frame.Group.NickName} overlaps the group {other.Group.NickName}.";
            foreach (var other in layout.Objects.Where(o => !frame.Group.Members.Contains(o.Item.Id) && o.Box.Meets(frame.Whole)))
                yield return $"{NameOf(other)} lies in the group {frame.Group.NickName}, which it does not belong to.";
        }
    }

    // A panel without wires explains.
    private static bool IsNote(Item item) => item.Look == Look.Panel && item.Inputs[0].Sources.Count == 0;

    private static Box Allowed(Placed placed)
    {
        var box = placed.Box;
        if (placed.Item.Look is not (Look.Component or Look.Parameter)) return box.Grown(Apart / 2);
        double left = (placed.Core.X - box.X) * Wider, right = (box.Right - placed.Core.Right) * Wider;
        return new Box(box.X - left, box.Y, box.Width + left + right, box.Height).Grown(Apart / 2);
    }

    private static string NameOf(Placed placed) => placed.Item.NickName.Length > 0 ? placed.Item.NickName : placed.Item.Name;
}
