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

    public ToolpathScene(Toolpath toolpath, SceneParts parts, LayerRange layers, PreviewColors colors, SceneContent content, DocumentUnits units)
    {
        _travels = content.Travels ? SceneParts.Shown(parts.Travels, layers) : [];
        _retractions = content.Travels ? SceneParts.Shown(parts.Retractions, layers) : [];
        _seams = content.Seams ? SceneParts.Shown(parts.Seams, layers) : [];
        _volume = content.Printer is { } printer ? VolumeOutline.Of(printer, units) : [];
        var box = parts.BoxOf(layers, content.Travels);
        foreach (var line in _volume) box.Union(line.BoundingBox);
        Box = box;
        if (content.Beads) AddBeads(toolpath, colors, units);
        else AddLines(parts, colors);
    }

    /// <summary>What the user must know about what is drawn. Null if that is everything.</summary>
    public string? Note { get; private set; }

    public Rg.BoundingBox Box { get; }

    public bool HasBeads => _meshes.Count > 0;

    public void DrawWires(IGH_PreviewArgs args, bool selected)
    {
        var (display, only) = (args.Display, selected ? args.WireColour_Selected : (Color?)null);
        if (!HasBeads)
        {
            foreach (var (lines, color) in _bands) display.DrawLines(lines, only ?? color, 2);
        }
        if (_travels.Length > 0) display.DrawLines(_travels, only ?? TravelColor, 1);
        if (_volume.Length > 0) display.DrawLines(_volume, only ?? VolumeColor, 1);
        if (_seams.Length > 0) display.DrawPoints(_seams, PointStyle.Simple, 4, only ?? SeamColor);
        if (_retractions.Length > 0) display.DrawPoints(_retractions, PointStyle.Simple, 2, only ?? TravelColor);
    }

    public void DrawMeshes(IGH_PreviewArgs args, bool selected)
    {
        foreach (var mesh in _meshes) args.Display.DrawMeshFalseColors(mesh);
    }

    private void AddLines(SceneParts parts, PreviewColors colors)
    {
        var counts = new int[colors.Colors.Count];
        var pieces = Pieces(parts, colors, default, counts);
        var thinning = Thinning.Of(counts.Sum(c => (long)c), parts.LayerCount);
        Note = thinning.Note;
        if (Note is not null) pieces = Pieces(parts, colors, thinning, counts);
        var bands = Array.ConvertAll(counts, count => new Rg.Line[count]);
        var ends = new int[counts.Length];
        foreach (var (band, from, to) in pieces)
        {
            parts.Lines.CopyTo(bands[band], ends[band], from, to);
            ends[band] += to - from;
        }
        for (var b = 0; b < bands.Length; b++)
        {
            if (counts[b] > 0) _bands.Add((bands[b], colors.Colors[b]));
        }
    }

    // Lines of one band that follow each other, from one number to before another, and the number of lines of each band.
    private static List<(int Band, int From, int To)> Pieces(SceneParts parts, PreviewColors colors, Thinning thinning, int[] counts)
    {
        var pieces = new List<(int Band, int From, int To)>();
        Array.Clear(counts, 0, counts.Length);
        var (last, from, to) = (-1, 0, 0);
        void Close()
        {
            if (to > from) pieces.Add((last, from, to));
        }
        for (var i = 0; i < parts.Layers.Length; i++)
        {
            var band = colors.BandOf(i);
            if (band == PreviewColors.Hidden || !thinning.Has(parts.Layers[i], i)) continue;
            var first = parts.Lines.FirstOf(i);
            var end = parts.Lines.FirstOf(i + 1);
            counts[band] += end - first;
            if (band != last || first != to)
            {
                Close();
                (last, from) = (band, first);
            }
            to = end;
        }
        Close();
        return pieces;
    }

    private void AddBeads(Toolpath toolpath, PreviewColors colors, DocumentUnits units)
    {
        // Runs of moves that are shown, a mesh for each so many.
        for (var i = 0; i < toolpath.Count;)
        {
            var end = i;
            while (end < toolpath.Count && end - i < MovesPerMesh && colors.BandOf(end) != PreviewColors.Hidden) end++;
            if (end > i && ExtrusionMeshes.ToMesh(ExtrusionMesh.Of(toolpath, i, end), units, m => colors.Colors[colors.BandOf(m)]) is { } mesh)
                _meshes.Add(mesh);
            i = Math.Max(end, i + 1);
        }
    }
}
