using Caterpillar.Display;
using Caterpillar.GH.Conversion;
using Caterpillar.Toolpaths;
using Layer = Caterpillar.Toolpaths.Layer;
using Rhino;
using Rhino.DocObjects;

namespace Caterpillar.GH.Bake;

/// <summary>
/// Bakes extrusions on layers by object and role, with their color, with the bead width as plot weight, and with facts as user text. Objects of one name
/// form a group.
/// </summary>
internal sealed class Baker(RhinoDoc document, ObjectAttributes attributes, List<Guid> ids)
{
    /// <summary>User text under which the name of a bake is found again.</summary>
    public const string NameKey = "caterpillar.bake";

    private readonly DocumentUnits _units = DocumentUnits.Of(document);

    /// <summary>The group of the following objects.</summary>
    public int? Group { get; init; }

    /// <summary>The name of the following objects. Empty = name of the attributes.</summary>
    public string Name { get; init; } = "";

    public void Add(PrintPath path)
    {
        var facts = new Facts(path.Role, path.Layer, path.Name)
        {
            Bead = path.BeadOf(0), Length = path.Length, Volume = path.Volume,
        };
        Add(RhinoGeometry.ToCurve(path, _units), facts);
    }

    /// <summary>One object for each extrusion of a toolpath: until the head travels, or role or layer change.</summary>
    public void Add(Toolpath toolpath, bool beads, System.Threading.CancellationToken cancel = default)
    {
        foreach (var extrusion in ToolpathExtrusions.Of(toolpath))
        {
            cancel.ThrowIfCancellationRequested();
            var first = toolpath[extrusion.First];
            var layer = first.Layer >= 0 && first.Layer < toolpath.Layers.Count ? toolpath.Layers[first.Layer] : null;
            var facts = new Facts(first.Role, layer, "")
            {
                Bead = toolpath.BeadOf(first), Speed = first.Speed, Source = first.Source,
                SourceName = toolpath.Source == MoveSource.Lines ? "line" : "step",
            };
            for (var i = extrusion.First; i < extrusion.End; i++)
            {
                var move = toolpath[i];
                if (move.Kind != MoveKind.Print) continue;
                facts.Length += move.Length;
                facts.E += move.Deposited;
            }
            if (beads) Add(ExtrusionMeshes.ToMesh(ExtrusionMesh.Of(toolpath, extrusion.First, extrusion.End), _units, null), facts);
            else Add(ToolpathExtrusions.ToCurve(toolpath, extrusion, _units), facts);
        }
    }

    private void Add(Rg.GeometryBase? geometry, Facts facts)
    {
        if (geometry is null) return;
        var role = facts.Role == Role.Unspecified ? "Extrusion" : facts.Role.ToString();
        var color = RhinoGeometry.ToColor(Palette.Of(facts.Role));
        var item = attributes.Duplicate();
        item.LayerIndex = BakeLayers.Find(document, facts.Layer?.Object is { Length: > 0 } name ? name : "Print", role, color);
        if (Name.Length > 0) item.Name = Name;
        else if (facts.Name.Length > 0) item.Name = facts.Name;
        item.ObjectColor = color;
        item.ColorSource = ObjectColorSource.ColorFromObject;
        if (facts.Bead?.Width(BeadShape.Stadium) is > 0 and var width)
        {
            item.PlotWeight = width;
            item.PlotWeightSource = ObjectPlotWeightSource.PlotWeightFromObject;
        }
        facts.Write(item);
        if (Name.Length > 0) item.SetUserString(NameKey, Name);
        if (Group is { } group) item.AddToGroup(group);
        var id = geometry is Rg.Mesh mesh ? document.Objects.AddMesh(mesh, item) : document.Objects.AddCurve((Rg.Curve)geometry, item);
        if (id != Guid.Empty) ids.Add(id);
    }

    /// <summary>Facts about a baked object.</summary>
    private sealed record Facts(Role Role, Layer? Layer, string Name)
    {
        public Bead? Bead { get; init; }

        public double Length { get; set; }

        public double E { get; set; }

        public double? Volume { get; init; }

        public double Speed { get; init; }

        public int Source { get; init; } = -1;

        public string SourceName { get; init; } = "";

        public void Write(ObjectAttributes item)
        {
            void Text(string key, double value, int decimals) => item.SetUserString("caterpillar." + key, NumberFormatter.Format(value, decimals));
            item.SetUserString("caterpillar.role", Role.ToString());
            Text("length_mm", Length, 3);
            if (E != 0) Text("e", E, 5);
            if (Volume is { } volume) Text("volume_mm3", volume, 4);
            if ((Speed > 0 ? Speed : Bead?.Speed ?? 0) is > 0 and var speed) Text("speed_mm_s", speed, 3);
            if (Bead is { Area: > 0 } bead) Text("area_mm2", bead.Area, 5);
            if (Layer is { } layer)
            {
                Text("layer", layer.Index, 0);
                Text("z_mm", layer.Z, 4);
            }
            if (Source >= 0) Text(SourceName, Source, 0);
        }
    }
}
