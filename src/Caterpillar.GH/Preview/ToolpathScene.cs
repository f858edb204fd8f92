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

    // Lines of one color that are drawn where they are kept.
    private const int LeastShared = 4096;
    private static readonly Color TravelColor = RhinoGeometry.ToColor(Palette.Travel);
    private static readonly Color SeamColor = Color.FromArgb(220, 40, 120);
    private static readonly Color VolumeColor = Color.FromArgb(150, 155, 160);
    private readonly List<(Rg.Line[] Lines, Color Color)> _bands = [];
    private readonly List<Rg.Mesh> _meshes = [];
    private readonly Rg.Line[] _travels;
    private readonly Rg.Point3d[] _retractions;
    private readonly Rg.Point3d[] _seams;
    private readonly Rg.Line[] _volume;

    public ToolpathScene(Toolpath toolpath, SceneParts parts, ShownLayers layers, PreviewColors colors, SceneContent content, DocumentUnits units)
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
        var thinning = Thinning.Of(CountsOf(parts.Blocks, parts, colors, default).Sum(c => (long)c), parts.LayerCount);
        Note = thinning.Note;
        var rest = new List<SceneBlock>();
        foreach (var block in parts.Blocks)
        {
            var band = colors.BandOf(block.Moves[0]);
            if (Note is not null || block.Lines.Length < LeastShared || !Array.TrueForAll(block.Moves, m => colors.BandOf(m) == band)) rest.Add(block);
            else if (band != PreviewColors.Hidden) _bands.Add((block.Lines, colors.Colors[band]));
        }
        var bands = Array.ConvertAll(CountsOf(rest, parts, colors, thinning), count => new Rg.Line[count]);
        var ends = new int[bands.Length];
        foreach (var block in rest)
        {
            for (var i = 0; i < block.Moves.Length; i++)
            {
                var band = BandOf(block.Moves[i], parts, colors, thinning);
                if (band != PreviewColors.Hidden) bands[band][ends[band]++] = block.Lines[i];
            }
        }
        for (var b = 0; b < bands.Length; b++)
        {
            if (bands[b].Length > 0) _bands.Add((bands[b], colors.Colors[b]));
        }
    }

    private static int BandOf(int move, SceneParts parts, PreviewColors colors, Thinning thinning)
        => thinning.Has(parts.Layers[move], move) ? colors.BandOf(move) : PreviewColors.Hidden;

    // The number of lines of each band.
    private static int[] CountsOf(IReadOnlyList<SceneBlock> blocks, SceneParts parts, PreviewColors colors, Thinning thinning)
    {
        var counts = new int[colors.Colors.Count];
        foreach (var block in blocks)
        {
            foreach (var move in block.Moves)
            {
                var band = BandOf(move, parts, colors, thinning);
                if (band != PreviewColors.Hidden) counts[band]++;
            }
        }
        return counts;
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
