using System;
using System.Collections.Generic;
using Caterpillar.GH.Conversion;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Types;

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
        // Numbers of rafts may begin below 0, branches do not.
        var numbers = toolpath.NumbersOfLayers();
        var lowest = numbers.Count > 0 ? Math.Min(numbers[0], 0) : 0;
        var layer = 0;
        Open(root, layer);
        for (var i = 0; i < toolpath.Count; i++)
        {
            var move = toolpath[i];
            if (toolpath.NumberOfLayer(move) is { } number && number - lowest != layer) Open(root, layer = number - lowest);
            _branch!.Add(move, units, toolpath.BeadOf(move), this);
        }
        foreach (var strand in ToolpathStrands.Of(toolpath))
        {
            var path = root.AppendElement(toolpath.NumberOfLayer(toolpath[strand.First]) is { } number ? number - lowest : 0);
            Strands.Append(new GH_Curve(ToolpathStrands.ToCurve(toolpath, strand, units)), path);
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

    public GH_Structure<GH_Curve> Strands { get; } = new();

    private Branch? _branch;

    private void Open(GH_Path root, int layer)
    {
        var path = root.AppendElement(layer);
        _branch = new Branch(Points.EnsurePath(path), Amounts.EnsurePath(path), Speeds.EnsurePath(path), Kinds.EnsurePath(path), Roles.EnsurePath(path),
            Sources.EnsurePath(path), Areas.EnsurePath(path), Widths.EnsurePath(path));
    }

    private GH_Number Number(double value)
    {
        // Amounts and coordinates hardly repeat: the table stays small.
        if (_numbers.TryGetValue(value, out var goo)) return goo;
        goo = new GH_Number(value);
        if (_numbers.Count < 4096) _numbers.Add(value, goo);
        return goo;
    }

    private GH_String Text(string value) => _texts.TryGetValue(value, out var goo) ? goo : _texts[value] = new GH_String(value);

    private sealed class Branch(List<GH_Point> points, List<GH_Number> amounts, List<GH_Number> speeds, List<GH_String> kinds, List<GH_String> roles,
        List<GH_Integer> sources, List<GH_Number> areas, List<GH_Number> widths)
    {
        private GH_Integer _source = new(-1);

        public void Add(in Move move, DocumentUnits units, Bead? bead, ToolpathParts all)
        {
            if (move.Source != _source.Value) _source = new GH_Integer(move.Source);
            points.Add(new GH_Point(RhinoGeometry.ToPoint(move.End, units)));
            amounts.Add(all.Number(move.E));
            speeds.Add(all.Number(move.Speed));
            kinds.Add(all.Text(move.Kind.ToString()));
            roles.Add(all.Text(move.Role.ToString()));
            sources.Add(_source);
            areas.Add(all.Number(bead?.Area ?? 0));
            widths.Add(all.Number(bead?.Width(BeadShape.Stadium) ?? 0));
        }
    }
}
