namespace Caterpillar.Jobs;

/// <summary>
/// Edits of a file, applied in the order of these properties. They act on selected moves of its layers. Start and end G-code are outside of layers and stay.
/// </summary>
public sealed record FileEdits
{
    /// <summary>The selection; all layers by default.</summary>
    public MoveFilter Filter { get; init; } = new();

    /// <summary>Speed factor of extrusions; null = unchanged.</summary>
    public double? Speed { get; init; }

    /// <summary>Flow factor of extrusions; null = unchanged.</summary>
    public double? Flow { get; init; }

    /// <summary>Scale factors of the selection about the center of its base, which also scale E; null = unchanged.</summary>
    public Vec3? Scale { get; init; }

    /// <summary>Rotation of the selection about its center in degrees, counterclockwise from above; null = unchanged.</summary>
    public double? Rotate { get; init; }

    /// <summary>Offset of the selection, mm; null = unchanged.</summary>
    public Vec3? Move { get; init; }

    /// <summary>Deformation of the selection, from the center of its base; null = unchanged.</summary>
    public Func<Vec3, Deformation>? Deform { get; init; }

    /// <summary>Layers before which the print pauses, by number.</summary>
    public IReadOnlyList<int> PauseAtLayers { get; init; } = [];

    /// <summary>The setup whose printer says how it pauses: lift, park position, retraction and command. Null = only the pause command of the flavor.</summary>
    public PrintSetup? PauseFor { get; init; }

    /// <summary>Events (tool, temperature, line of G-code) before layers, by number.</summary>
    public IReadOnlyList<(int Layer, PrinterEvent What)> AtLayers { get; init; } = [];

    /// <summary>Remove the selection: only extrusions if roles or a box are selected, else layers and objects with their travel moves.</summary>
    public bool Remove { get; init; }

    /// <summary>Tolerance of arcs fitted to extrusions, mm; 0 = off.</summary>
    public double FitArcs { get; init; }

    /// <summary>Maximum deviation of transformed or deformed extrusions, mm.</summary>
    public double Tolerance { get; init; } = 0.01;

    /// <summary>The center of the base of the selection, mm, where it is known before. Null = found in the moves.</summary>
    internal Vec3? Center { get; init; }

    internal bool Moves => IsCentered || Move is not null || Deform is not null;

    /// <summary>True if the center must be known.</summary>
    internal bool IsCentered => Scale is not null || Rotate is not null;

    /// <summary>
    /// True if they can be made while a file is decoded, of which the beginning is known: they act on each extrusion by itself, given the center, and what
    /// moves has no outlines of objects, no bed that the file knows, and no part below it.
    /// </summary>
    internal bool CanFollow(DecodedGCode head)
    {
        if (head.FirstLayerLine == 0 || head.Axis == ExtrusionAxis.Switched || Filter != new MoveFilter()) return false;
        if (Deform is not null || PauseAtLayers.Count + AtLayers.Count > 0 || Remove || FitArcs > 0) return false;
        if (Move is { } shift && (shift.Z != 0 || Flow is not null || Scale is not null)) return false;
        return !Moves || (!head.Ignored.ContainsKey(OutlineFigures.Command) && !head.Settings.ContainsKey(Continuation.Setting)
            && head.Report.Setup.Count == 0);
    }

    /// <summary>The edited toolpath, or the same one without edits.</summary>
    /// <returns>The toolpath, or none if a layer is missing (<c>toolpath.no_layer</c>) or a deformation gives no point; the warnings
    /// <c>edit.nothing_selected</c> and <c>edit.no_e_values</c>, and the note <c>edit.nonuniform_scale</c>.</returns>
    public Result<Toolpath> Apply(Toolpath toolpath)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        var found = new List<Diagnostic>();
        var (original, filter) = (toolpath, Filter.InLayersOf(toolpath));
        var extrusions = filter with { Kinds = [MoveKind.Print] };
        if (Filter != new MoveFilter() && !toolpath.Moves().Any(m => extrusions.Matches(toolpath, m)))
            found.Add(new Diagnostic(Severity.Warning, "edit.nothing_selected", "The selection has no extrusions in this file, so nothing is edited."));
        toolpath = WithSpeedAndFlow(toolpath, extrusions);
        if (Scale is not null) found.AddRange(ScaleNotes(toolpath.Moves().Any(m => m.Deposited != 0 && extrusions.Matches(toolpath, m))));
        if (Map(toolpath, extrusions) is { } map) toolpath = toolpath.Transform(filter, map, Tolerance);
        foreach (var change in Changes(filter, extrusions))
        {
            var changed = change(toolpath);
            found.AddRange(changed.Diagnostics);
            if (changed.Value is null) return new Result<Toolpath>(null, found);
            toolpath = changed.Value;
        }
        if (Remove) toolpath = toolpath.Remove(Filter.Roles is null && Filter.Box is null ? filter : extrusions);
        if (FitArcs > 0) toolpath = toolpath.FitArcs(FitArcs);
        if ((Remove || Move is not null) && Hanging(original) is null && Hanging(toolpath) is { } layer)
            found.Add(new Diagnostic(Severity.Warning, "edit.in_the_air", $"Layer {NumberFormatter.Format(layer.Index)} begins at Z "
                + $"{NumberFormatter.Format(layer.Z - layer.Thickness, 3)} mm, with nothing below it. To continue on a part that stands there, keep the "
                + "layers above a height (--keep-above). Otherwise move the print down."));
        return new Result<Toolpath>(toolpath, found);
    }

    /// <summary>The next part of a print, whose image begins at a position. Null = the first.</summary>
    internal Toolpath ApplyTo(Toolpath part, Vec3? position)
    {
        var filter = new MoveFilter { FirstLayer = int.MinValue };
        var extrusions = filter with { Kinds = [MoveKind.Print] };
        part = WithSpeedAndFlow(part, extrusions);
        return Map(part, extrusions) is not { } map ? part
            : new ToolpathMapper(part, MappedMoves.Of(part, filter, position is not null), new AffineRunMap(map, Tolerance), Tolerance)
                .Run(position ?? part.Start ?? Vec3.Zero);
    }

    private Toolpath WithSpeedAndFlow(Toolpath toolpath, MoveFilter extrusions)
    {
        if (Speed is { } speed) toolpath = toolpath.ScaleSpeed(extrusions, speed);
        return Flow is { } flow ? toolpath.ScaleFlow(extrusions, flow) : toolpath;
    }

    /// <summary>The height in mm above which all layers, and nothing else, are removed. Null = other edits.</summary>
    internal double? Cut(Toolpath toolpath)
    {
        if (!Remove || Filter.FirstLayer is not { } first || Filter with { FirstLayer = null, LastLayer = null } != new MoveFilter()) return null;
        double below = double.NegativeInfinity, above = double.PositiveInfinity;
        foreach (var layer in toolpath.UsedLayers())
        {
            if (layer.Index > Filter.LastLayer) return null;
            if (layer.Index < first) below = Math.Max(below, layer.Z);
            else above = Math.Min(above, layer.Z);
        }
        return below < above && PrintCut.At(toolpath, below).Value is not null ? below : null;
    }

    // The lowest layer with a gap of more than half of its thickness below it. Null = none.
    private static Layer? Hanging(Toolpath toolpath)
    {
        var top = 0.0;
        foreach (var layer in toolpath.UsedLayers().OrderBy(l => l.Z))
        {
            if (layer.Z - layer.Thickness > top + layer.Thickness / 2) return layer;
            top = layer.Z;
        }
        return null;
    }

    // Edits that may fail.
    private IEnumerable<Func<Toolpath, Result<Toolpath>>> Changes(MoveFilter filter, MoveFilter extrusions)
    {
        if (Deform is not null) yield return toolpath => toolpath.Deform(filter, Deform(Foot(extrusions.BoundsIn(toolpath))), Tolerance);
        foreach (var layer in PauseAtLayers) yield return toolpath => toolpath.PauseAtLayer(layer, PauseFor);
        foreach (var (layer, what) in AtLayers) yield return toolpath => toolpath.InsertAtLayer(layer, what);
    }

    // Null if nothing is moved.
    private Affine? Map(Toolpath toolpath, MoveFilter extrusions)
    {
        if (Scale is null && Rotate is null) return Move is { } shift ? Affine.Move(shift) : null;
        var foot = Center ?? Foot(extrusions.BoundsIn(toolpath));
        var map = Affine.Move(-foot);
        if (Scale is { } scale) map = map.Then(Affine.Scale(scale.X, scale.Y, scale.Z));
        if (Rotate is { } degrees) map = map.Then(Affine.Rotate(Vec3.UnitZ, degrees));
        return map.Then(Affine.Move(foot + (Move ?? Vec3.Zero)));
    }

    /// <summary>The center of the extrusions in a box, on the bed.</summary>
    internal static Vec3 Foot(Bounds box) => box.IsEmpty ? Vec3.Zero : box.Center.WithZ(0);

    /// <summary>Limits of scaling.</summary>
    /// <param name="hasAmounts">True if extrusions deposit material.</param>
    internal IEnumerable<Diagnostic> ScaleNotes(bool hasAmounts)
    {
        if (Scale is not { } scale) yield break;
        if (!hasAmounts)
            yield return new Diagnostic(Severity.Warning, "edit.no_e_values", "The extrusions have no E, so only their paths are scaled.");
        else if (scale.X != scale.Y || scale.Y != scale.Z)
            yield return new Diagnostic(Severity.Note, "edit.nonuniform_scale",
                "The axes have different scale factors, so the flow of each extrusion depends on its direction. A width in a comment is correct only for the "
                + "next extrusion.");
    }
}
