using System.Drawing;
using Caterpillar.Display;
using Caterpillar.GH.Conversion;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using Rhino.Display;

namespace Caterpillar.GH.Preview;

/// <summary>The visible parts of a toolpath: beads instead of lines, travel moves with retractions, seams, and the bed and volume of a printer.</summary>
internal sealed record SceneContent(bool Beads, bool Travels, bool Seams, Printer? Printer);

/// <summary>
/// A toolpath ready to be drawn: arrays of lines for each color, for travel moves and for the printer. Retractions and seams are points, beads are meshes.
/// </summary>
internal sealed class ToolpathScene : IDrawn
{
    /// <summary>Beads of more moves than this are drawn as lines.</summary>
    public const int MostBeads = 250_000;

    private const int MovesPerMesh = 50_000;
    private static readonly Color TravelColor = RhinoGeometry.ToColor(Palette.Travel);
    private static readonly Color SeamColor = Color.FromArgb(220, 40, 120);
    private static readonly Color VolumeColor = Color.FromArgb(150, 155, 160);
    private readonly List<(Rg.Line[] Lines, Color Color)> _bands = [];
    private readonly List<Rg.Mesh> _meshes = [];
    private readonly Rg.Line[] _travels;
    private readonly Rg.Point3d[] _retractions;
    private readonly Rg.Point3d[] _seams;
    private readonly Rg.Line[] _volume;

    public ToolpathScene(Toolpath toolpath, Func<int, bool> shown, PreviewColors colors, SceneContent content, DocumentUnits units)
    {
        var travels = content.Travels;
        var bands = new List<Rg.Line>[colors.Colors.Count];
        for (var b = 0; b < bands.Length; b++) bands[b] = [];
        List<Rg.Line> moved = [];
        List<Rg.Point3d> retracted = [];
        var box = Rg.BoundingBox.Empty;
        for (var i = 0; i < toolpath.Count; i++)
        {
            if (!shown(i)) continue;
            var move = toolpath[i];
            if (move.Kind == MoveKind.Print)
            {
                RhinoGeometry.AddLines(bands[colors.BandOf(i)], move.Start, move.End, move.Arc, units);
                box.Union(RhinoGeometry.ToBox(move.Bounds, units));
            }
            else if (travels && move.Kind is MoveKind.Travel or MoveKind.Wipe)
            {
                RhinoGeometry.AddLines(moved, move.Start, move.End, move.Arc, units);
                box.Union(RhinoGeometry.ToBox(move.Bounds, units));
            }
            else if (travels && move.Kind == MoveKind.Retract)
            {
                retracted.Add(RhinoGeometry.ToPoint(move.End, units));
            }
        }
        for (var b = 0; b < bands.Length; b++)
        {
            if (bands[b].Count > 0) _bands.Add((bands[b].ToArray(), colors.Colors[b]));
        }
        _travels = moved.ToArray();
        _retractions = retracted.ToArray();
        _volume = content.Printer is { } printer ? VolumeOutline.Of(printer, units) : [];
        foreach (var line in _volume) box.Union(line.BoundingBox);
        _seams = content.Seams ? Seams(toolpath, shown, units) : [];
        Box = box;
        if (content.Beads) AddBeads(toolpath, shown, colors, units);
    }

    public Rg.BoundingBox Box { get; }

    public bool HasBeads => _meshes.Count > 0;

    public void DrawWires(IGH_PreviewArgs args, bool selected) => DrawWires(args.Display, selected ? args.WireColour_Selected : null);

    public void DrawMeshes(IGH_PreviewArgs args, bool selected) => DrawMeshes(args.Display);

    public void DrawWires(DisplayPipeline display, Color? only)
    {
        if (!HasBeads)
        {
            foreach (var (lines, color) in _bands) display.DrawLines(lines, only ?? color, 2);
        }
        if (_travels.Length > 0) display.DrawLines(_travels, only ?? TravelColor, 1);
        if (_volume.Length > 0) display.DrawLines(_volume, only ?? VolumeColor, 1);
        if (_seams.Length > 0) display.DrawPoints(_seams, PointStyle.Simple, 4, only ?? SeamColor);
        if (_retractions.Length > 0) display.DrawPoints(_retractions, PointStyle.Simple, 2, only ?? TravelColor);
    }

    public void DrawMeshes(DisplayPipeline display)
    {
        foreach (var mesh in _meshes) display.DrawMeshFalseColors(mesh);
    }

    // Where extrusions of walls begin.
    private static Rg.Point3d[] Seams(Toolpath toolpath, Func<int, bool> shown, DocumentUnits units)
    {
        var points = new List<Rg.Point3d>();
        foreach (var extrusion in ToolpathExtrusions.Of(toolpath))
        {
            if (toolpath[extrusion.First].Role is Role.OuterWall or Role.InnerWall && shown(extrusion.First))
                points.Add(RhinoGeometry.ToPoint(toolpath[extrusion.First].Start, units));
        }
        return points.ToArray();
    }

    private void AddBeads(Toolpath toolpath, Func<int, bool> shown, PreviewColors colors, DocumentUnits units)
    {
        // Runs of moves that are shown, a mesh for each so many.
        for (var i = 0; i < toolpath.Count;)
        {
            if (!shown(i))
            {
                i++;
                continue;
            }
            var end = i;
            while (end < toolpath.Count && end - i < MovesPerMesh && shown(end)) end++;
            if (ExtrusionMeshes.ToMesh(ExtrusionMesh.Of(toolpath, i, end), units, m => colors.Colors[colors.BandOf(m)]) is { } mesh) _meshes.Add(mesh);
            i = end;
        }
    }
}
