using System;
using System.Collections.Generic;
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
        var place = box;
        // A hole never stays without its outline, whose box is larger.
        return Only(part => GridBox.Overlap(part, place));
    }

    /// <summary>The same for several boxes, each with what is around it up to a distance, mm.</summary>
    internal Region Near(IReadOnlyList<GridBox> boxes, double distance)
    {
        var places = new GridBox[boxes.Count];
        for (var i = 0; i < places.Length; i++) places[i] = boxes[i].Grown(distance);
        return Only(part => Array.Exists(places, p => GridBox.Overlap(part, p)));
    }

    private Region Only(Predicate<GridBox> isNear)
    {
        var near = Array.ConvertAll(Boxes, b => isNear(b));
        if (Array.TrueForAll(near, n => n)) return this;
        var paths = new List<GridPoint[]>();
        for (var i = 0; i < near.Length; i++)
        {
            if (near[i]) paths.Add(_paths[i]);
        }
        return Own([.. paths]);
    }

    /// <summary>
    /// The contours that reach into a box, each without the corners that do not matter inside of it. Inside the box the result covers what this region
    /// covers; outside of it contours may cross, so it is only good for clipping what lies in the box.
    /// </summary>
    internal Region Cropped(in GridBox box)
    {
        var paths = new List<GridPoint[]>();
        var boxes = Boxes;
        for (var i = 0; i < boxes.Length; i++)
        {
            if (!GridBox.Overlap(boxes[i], box)) continue;
            var path = Cropped(_paths[i], box);
            if (path.Length > 2) paths.Add(path);
        }
        return Own([.. paths]);
    }

    // A run of corners that are all on the same side of the box, such as left of it, is replaced by its first and its last one.
    private static GridPoint[] Cropped(GridPoint[] path, in GridBox box)
    {
        var kept = new GridPoint[path.Length];
        int count = 0, run = 0, sides = 0;
        foreach (var p in path)
        {
            var side = (p.X < box.MinX ? 1 : p.X > box.MaxX ? 2 : 0) | (p.Y < box.MinY ? 4 : p.Y > box.MaxY ? 8 : 0);
            var same = (sides & side) != 0;
            run = same ? run + 1 : 1;
            sides = same ? sides & side : side;
            if (run > 2) count--;
            kept[count++] = p;
        }
        if (count < path.Length) Array.Resize(ref kept, count);
        return kept;
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

    /// <summary>Whether the region has no point within a distance, mm, of a place, in mm.</summary>
    internal bool IsFartherThan(double distance, Vec3 place)
        => !Index.Contains(place.X * Grid.PerMm, place.Y * Grid.PerMm) && !Index.Reaches(place.X * Grid.PerMm, place.Y * Grid.PerMm, distance * Grid.PerMm);

    /// <summary>Regions that are apart from each other as one.</summary>
    internal static Region Beside(IEnumerable<Region> regions)
    {
        var paths = new List<GridPoint[]>();
        foreach (var region in regions) paths.AddRange(region._paths);
        return Own([.. paths]);
    }
}
