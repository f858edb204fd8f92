using System;
using System.Threading;

namespace Caterpillar.Geometry;

// Quick answers about two regions, so that the regions of neighboring layers need to be combined only where they differ.
public sealed partial class Region
{
    private GridBox[]? _boxes;

    /// <summary>The boxes of the contours.</summary>
    internal GridBox[] Boxes => _boxes ?? Interlocked.CompareExchange(ref _boxes, Array.ConvertAll(_paths, GridBox.Of), null) ?? _boxes!;

    /// <summary>The box of the whole region, on the grid.</summary>
    internal GridBox Box
    {
        get
        {
            var box = GridBox.Nothing;
            foreach (var part in Boxes) box.Include(part);
            return box;
        }
    }

    /// <summary>
    /// The contours whose boxes reach into a box. Inside the box the result covers what this region covers; outside of it holes may be filled.
    /// </summary>
    internal Region Near(in GridBox box)
    {
        var boxes = Boxes;
        var count = 0;
        foreach (var part in boxes)
        {
            if (GridBox.Overlap(part, box)) count++;
        }
        if (count == boxes.Length) return this;
        if (count == 0) return Empty;
        var paths = new GridPoint[count][];
        for (int i = 0, n = 0; i < boxes.Length; i++)
        {
            // A hole never stays without its outline, whose box is larger.
            if (GridBox.Overlap(boxes[i], box)) paths[n++] = _paths[i];
        }
        return new Region(paths);
    }

    /// <summary>True if both have the same contours, vertex by vertex.</summary>
    internal bool SameAs(Region other)
    {
        if (ReferenceEquals(this, other)) return true;
        if (_paths.Length != other._paths.Length) return false;
        for (var i = 0; i < _paths.Length; i++)
        {
            GridPoint[] a = _paths[i], b = other._paths[i];
            if (a.Length != b.Length) return false;
            for (var k = 0; k < a.Length; k++)
            {
                if (a[k] != b[k]) return false;
            }
        }
        return true;
    }

    /// <summary>
    /// True if the other region lies inside this one and their boundaries do not meet. Where they do it is false, even if nothing of the other sticks out.
    /// </summary>
    internal bool Surrounds(Region other)
    {
        if (other.IsEmpty) return true;
        if (IsEmpty) return false;
        GridBox box = Box, inner = other.Box;
        if (inner.MinX <= box.MinX || inner.MinY <= box.MinY || inner.MaxX >= box.MaxX || inner.MaxY >= box.MaxY) return false;
        if (RegionMeeting.Meet(Index, other.Index)) return false;
        foreach (var path in other._paths)
        {
            if (!Index.Contains(path[0].X, path[0].Y)) return false;
        }
        // A hole of this region within the other one.
        for (var i = 0; i < _paths.Length; i++)
        {
            if (GridBox.Overlap(Boxes[i], inner) && other.Index.Contains(_paths[i][0].X, _paths[i][0].Y)) return false;
        }
        return true;
    }

    /// <summary>Whether a small region neither touches this one nor lies in it or around a piece of it.</summary>
    internal bool IsApartFrom(Region small)
    {
        var box = small.Box;
        var near = Near(box);
        if (near.IsEmpty || small.IsEmpty) return true;
        if (RegionMeeting.Meet(Index, small.Index)) return false;
        foreach (var path in small._paths)
        {
            if (Index.Contains(path[0].X, path[0].Y)) return false;
        }
        foreach (var path in near._paths)
        {
            if (small.Index.Contains(path[0].X, path[0].Y)) return false;
        }
        return true;
    }

    /// <summary>Regions that are apart from each other as one.</summary>
    internal Region Beside(Region other) => IsEmpty ? other : other.IsEmpty ? this : new Region([.. _paths, .. other._paths]);
}
