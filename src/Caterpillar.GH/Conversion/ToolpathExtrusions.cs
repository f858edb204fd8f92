namespace Caterpillar.GH.Conversion;

/// <summary>A run of printing moves without a gap, in one layer and with one role: moves from First to before End.</summary>
internal readonly record struct ToolpathExtrusion(int First, int End);

/// <summary>The extrusions of a toolpath.</summary>
internal static class ToolpathExtrusions
{
    public static IEnumerable<ToolpathExtrusion> Of(Toolpath toolpath)
    {
        var first = -1;
        var (role, layer) = (default(Role), 0);
        foreach (var move in toolpath.Moves())
        {
            var prints = move.Kind == MoveKind.Print && move.Length > 0;
            // A pause of the extruder between two extrusions does not part them, a travel does.
            if (!prints && (first < 0 || move.Length == 0)) continue;
            if (first >= 0 && (!prints || move.Role != role || move.Layer != layer))
            {
                yield return new ToolpathExtrusion(first, move.Index);
                first = -1;
            }
            if (prints && first < 0) (first, role, layer) = (move.Index, move.Role, move.Layer);
        }
        if (first >= 0) yield return new ToolpathExtrusion(first, toolpath.Count);
    }

    /// <summary>An extrusion as a polyline, or with its arcs as arcs. Null if it has no length.</summary>
    public static Rg.Curve? ToCurve(Toolpath toolpath, ToolpathExtrusion extrusion, DocumentUnits units)
    {
        var joiner = new CurveJoiner(units);
        for (var i = extrusion.First; i < extrusion.End; i++)
        {
            var move = toolpath[i];
            if (move.Kind == MoveKind.Print) joiner.Add(move.Start, move.End, move.Arc);
        }
        return joiner.Finish();
    }
}
