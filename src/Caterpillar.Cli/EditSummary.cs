using System;
using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Cli;

/// <summary>What edits have changed, in words.</summary>
internal static class EditSummary
{
    public static string Of(Toolpath before, Toolpath after)
    {
        if (ReferenceEquals(before, after)) return "";
        var parts = new List<string>();
        if (before.Count == after.Count) Compare(before, after, parts);
        else parts.Add($"{Count(before.Count, "move")} became {Count(after.Count)}");
        var events = after.Events.Count - before.Events.Count;
        if (events > 0) parts.Add(Count(events, "command") + " inserted");
        if (events < 0) parts.Add(Count(-events, "command") + " removed");
        return string.Join(", ", parts);
    }

    private static void Compare(Toolpath before, Toolpath after, List<string> parts)
    {
        int moved = 0, faster = 0, material = 0;
        using var others = after.Moves().GetEnumerator();
        foreach (var move in before.Moves())
        {
            others.MoveNext();
            var other = others.Current;
            if (Vec3.Dot(move.End - other.End, move.End - other.End) > 1e-18) moved++;
            if (Math.Abs(move.Speed - other.Speed) > 1e-9) faster++;
            if (Math.Abs(move.Deposited - other.Deposited) > 1e-12) material++;
        }
        if (moved > 0) parts.Add(Count(moved, "move") + " shifted");
        if (faster > 0) parts.Add("speed of " + Count(faster, "move") + " changed");
        if (material > 0) parts.Add("material of " + Count(material, "move") + " changed");
    }

    private static string Count(int count, string thing) => $"{Count(count)} {thing}{(count == 1 ? "" : "s")}";

    private static string Count(int count) => NumberFormatter.Format(count);
}
