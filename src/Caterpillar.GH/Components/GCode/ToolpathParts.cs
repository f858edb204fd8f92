namespace Caterpillar.GH.Components.GCode;

/// <summary>
/// The moves of a toolpath as trees with a branch per layer. Equal values share one goo, as most moves repeat the speed, the kind, the role and the
/// cross-section of others.
/// </summary>
internal sealed class ToolpathParts
{
    private readonly Dictionary<double, GH_Number> _numbers = [];
    private readonly Dictionary<string, GH_String> _texts = new(StringComparer.Ordinal);

    public ToolpathParts(Toolpath toolpath, DocumentUnits units, GH_Path root)
    {
        var layers = new LayerBranches(toolpath, root);
        Branch? branch = null;
        foreach (var (move, path) in layers.Moves())
        {
            if (!ReferenceEquals(path, branch?.Path)) branch = new Branch(this, path);
            branch!.Add(move, units, toolpath.BeadOf(move));
        }
        foreach (var extrusion in ToolpathExtrusions.Of(toolpath))
        {
            Extrusions.Append(new GH_Curve(ToolpathExtrusions.ToCurve(toolpath, extrusion, units)), layers.PathOf(toolpath[extrusion.First]));
        }
    }

    public GH_Structure<GH_Point> Points { get; } = new();

    public GH_Structure<GH_Number> Amounts { get; } = new();

    public GH_Structure<GH_Number> Speeds { get; } = new();

    public GH_Structure<GH_String> Kinds { get; } = new();

    public GH_Structure<GH_String> Roles { get; } = new();

    public GH_Structure<GH_Integer> Sources { get; } = new();

    public GH_Structure<GH_Number> Areas { get; } = new();

    public GH_Structure<GH_Number> Widths { get; } = new();

    public GH_Structure<GH_Curve> Extrusions { get; } = new();

    private GH_Number Number(double value)
    {
        // Amounts and coordinates hardly repeat: the table stays small.
        if (_numbers.TryGetValue(value, out var goo)) return goo;
        goo = new GH_Number(value);
        if (_numbers.Count < 4096) _numbers.Add(value, goo);
        return goo;
    }

    private GH_String Text(string value) => _texts.TryGetValue(value, out var goo) ? goo : _texts[value] = new GH_String(value);

    /// <summary>The branches of one layer.</summary>
    private sealed class Branch(ToolpathParts parts, GH_Path path)
    {
        private readonly List<GH_Point> _points = parts.Points.EnsurePath(path);
        private readonly List<GH_Number> _amounts = parts.Amounts.EnsurePath(path);
        private readonly List<GH_Number> _speeds = parts.Speeds.EnsurePath(path);
        private readonly List<GH_String> _kinds = parts.Kinds.EnsurePath(path);
        private readonly List<GH_String> _roles = parts.Roles.EnsurePath(path);
        private readonly List<GH_Integer> _sources = parts.Sources.EnsurePath(path);
        private readonly List<GH_Number> _areas = parts.Areas.EnsurePath(path);
        private readonly List<GH_Number> _widths = parts.Widths.EnsurePath(path);
        private GH_Integer _source = new(-1);

        public GH_Path Path => path;

        public void Add(in Move move, DocumentUnits units, Bead? bead)
        {
            if (move.Source != _source.Value) _source = new GH_Integer(move.Source);
            _points.Add(new GH_Point(RhinoGeometry.ToPoint(move.End, units)));
            _amounts.Add(parts.Number(move.E));
            _speeds.Add(parts.Number(move.Speed));
            _kinds.Add(parts.Text(move.Kind.ToString()));
            _roles.Add(parts.Text(move.Role.ToString()));
            _sources.Add(_source);
            _areas.Add(parts.Number(bead?.Area ?? 0));
            _widths.Add(parts.Number(bead?.Width(BeadShape.Stadium) ?? 0));
        }
    }
}
