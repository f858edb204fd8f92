using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;

namespace Caterpillar.Jobs;

/// <summary>
/// Changes to what a file prints, made in the order of these properties. They act on chosen moves of its layers; start and end code belong to none and stay.
/// </summary>
public sealed record FileEdits
{
    /// <summary>What is changed; all layers by default.</summary>
    public MoveFilter Filter { get; init; } = new();

    /// <summary>Factor of the speed of extrusions; null where it stays.</summary>
    public double? Speed { get; init; }

    /// <summary>Factor of the material of extrusions; null where it stays.</summary>
    public double? Flow { get; init; }

    /// <summary>Factors that scale the selection about the middle of its base, amounts of E included; null where it keeps its size.</summary>
    public Vec3? Scale { get; init; }

    /// <summary>Degrees by which the selection is turned about its middle, counterclockwise seen from above; null where it is not.</summary>
    public double? Turn { get; init; }

    /// <summary>How far the selection is moved, mm; null where it is not.</summary>
    public Vec3? Move { get; init; }

    /// <summary>The deformation of the selection, given the middle of its base; null where it keeps its shape.</summary>
    public Func<Vec3, Deformation>? Deform { get; init; }

    /// <summary>Numbers of the layers before which the print pauses.</summary>
    public IReadOnlyList<int> PauseAtLayers { get; init; } = [];

    /// <summary>How it pauses.</summary>
    public Pause Pause { get; init; } = Pause.Plain;

    /// <summary>Events (a tool, a temperature, a line of G-code) with the numbers of the layers before which they happen.</summary>
    public IReadOnlyList<(int Layer, PrinterEvent What)> AtLayers { get; init; } = [];

    /// <summary>The selection is removed: its extrusions where roles or a box are chosen, else layers and objects with their travel.</summary>
    public bool Remove { get; init; }

    /// <summary>Arcs are fitted to extrusions; null where they are not.</summary>
    public ArcFitOptions? FitArcs { get; init; }

    /// <summary>Maximum deviation of extrusions that are mapped or deformed, mm.</summary>
    public double Tolerance { get; init; } = 0.01;

    /// <summary>The changed toolpath; the same one if no change is asked for.</summary>
    /// <returns>The toolpath, or none where a layer is missing (<c>toolpath.no_layer</c>) or a deformation gives no point; the warnings
    /// <c>edit.nothing_selected</c> and <c>edit.no_e_values</c>, and the note <c>edit.nonuniform_scale</c>.</returns>
    public Result<Toolpath> Apply(Toolpath toolpath)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        var found = new List<Diagnostic>();
        var filter = Filter.InLayersOf(toolpath);
        var extrusions = filter with { Kinds = [MoveKind.Print] };
        if (Filter != new MoveFilter() && !toolpath.Moves().Any(extrusions.MatchesIn(toolpath)))
            found.Add(new Diagnostic(Severity.Warning, "edit.nothing_selected", "The selection prints nothing in this file, so nothing is edited."));
        if (Speed is { } speed) toolpath = toolpath.ScaleSpeed(extrusions, speed);
        if (Flow is { } flow) toolpath = toolpath.ScaleFlow(extrusions, flow);
        if (Scale is { } scale) found.AddRange(ScaleNotes(toolpath, extrusions, scale));
        if (Map(toolpath, extrusions) is { } map) toolpath = toolpath.Transform(filter, map, Tolerance);
        foreach (var change in Changes(filter, extrusions))
        {
            var changed = change(toolpath);
            found.AddRange(changed.Diagnostics);
            if (changed.Value is null) return new Result<Toolpath>(null, found);
            toolpath = changed.Value;
        }
        if (Remove) toolpath = toolpath.Remove(Filter.Roles is null && Filter.Box is null ? filter : extrusions);
        if (FitArcs is not null) toolpath = toolpath.FitArcs(FitArcs);
        return new Result<Toolpath>(toolpath, found);
    }

    // Those that may fail.
    private IEnumerable<Func<Toolpath, Result<Toolpath>>> Changes(MoveFilter filter, MoveFilter extrusions)
    {
        if (Deform is not null) yield return toolpath => toolpath.Deform(filter, Deform(Foot(toolpath, extrusions)), Tolerance);
        foreach (var layer in PauseAtLayers) yield return toolpath => toolpath.PauseAtLayer(layer, Pause);
        foreach (var (layer, what) in AtLayers) yield return toolpath => toolpath.InsertAtLayer(layer, what);
    }

    // Null if nothing is moved.
    private Affine? Map(Toolpath toolpath, MoveFilter extrusions)
    {
        if (Scale is null && Turn is null) return Move is { } shift ? Affine.Move(shift) : null;
        var foot = Foot(toolpath, extrusions);
        var map = Affine.Move(-foot);
        if (Scale is { } scale) map = map.Then(Affine.Scale(scale.X, scale.Y, scale.Z));
        if (Turn is { } degrees) map = map.Then(Affine.Rotate(Vec3.UnitZ, degrees));
        return map.Then(Affine.Move(foot + (Move ?? Vec3.Zero)));
    }

    // The middle of what the extrusions cover, on the bed.
    private static Vec3 Foot(Toolpath toolpath, MoveFilter extrusions)
    {
        var box = extrusions.BoundsIn(toolpath);
        return box.IsEmpty ? Vec3.Zero : box.Center.WithZ(0);
    }

    // What scaling cannot know.
    private static IEnumerable<Diagnostic> ScaleNotes(Toolpath toolpath, MoveFilter extrusions, Vec3 scale)
    {
        if (toolpath.Moves().Where(extrusions.MatchesIn(toolpath)).All(m => m.Deposited == 0))
            yield return new Diagnostic(Severity.Warning, "edit.no_e_values", "The extrusions have no amounts of E: only their paths are scaled.");
        else if (scale.X != scale.Y || scale.Y != scale.Z)
            yield return new Diagnostic(Severity.Note, "edit.nonuniform_scale",
                "Axes are scaled apart: each extrusion gets the area that its direction gives it; a width in a comment is that of the first extrusion after "
                + "it.");
    }
}
