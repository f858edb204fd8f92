using Rhino.DocObjects;
using Layer = Caterpillar.Toolpaths.Layer;

namespace Caterpillar.GH.Bake;

/// <summary>One object to bake: a curve or a mesh, with facts that become its user text.</summary>
internal sealed record BakedPart(Rg.GeometryBase Geometry, Role Role, Layer? Layer)
{
    public string Name { get; init; } = "";

    public Bead? Bead { get; init; }

    private double Length { get; init; }

    private double E { get; init; }

    private double? Volume { get; init; }

    private double Speed { get; init; }

    // Key and value.
    private (string Key, int Value)? Source { get; init; }

    /// <summary>Name of the object that it belongs to, and of its role.</summary>
    public (string Object, string Role) Place
        => (Layer?.Object is { Length: > 0 } name ? name : "Print", Role == Role.Unspecified ? "Extrusion" : Role.ToString());

    /// <summary>A print path as a curve. Null without a length.</summary>
    public static BakedPart? Of(PrintPath path, DocumentUnits units)
        => RhinoGeometry.ToCurve(path, units) is not { } curve ? null
            : new(curve, path.Role, path.Layer) { Name = path.Name, Bead = path.BeadOf(0), Length = path.Length, Volume = path.Volume };

    /// <summary>The extrusions of a toolpath, as curves or as meshes. One ends where the head travels, or where role or layer change.</summary>
    public static List<BakedPart> Of(Toolpath toolpath, bool beads, DocumentUnits units, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        var parts = new List<BakedPart>();
        foreach (var extrusion in ToolpathExtrusions.Of(toolpath))
        {
            cancel.ThrowIfCancellationRequested();
            progress?.Report((double)extrusion.First / toolpath.Count);
            var geometry = beads ? ExtrusionMeshes.ToMesh(ExtrusionMesh.Of(toolpath, extrusion.First, extrusion.End), units, null)
                : (Rg.GeometryBase?)ToolpathExtrusions.ToCurve(toolpath, extrusion, units);
            if (geometry is null) continue;
            var (length, e) = (0.0, 0.0);
            for (var i = extrusion.First; i < extrusion.End; i++)
            {
                var move = toolpath[i];
                if (move.Kind != MoveKind.Print) continue;
                length += move.Length;
                e += move.Deposited;
            }
            var first = toolpath[extrusion.First];
            var layer = first.Layer >= 0 && first.Layer < toolpath.Layers.Count ? toolpath.Layers[first.Layer] : null;
            parts.Add(new(geometry, first.Role, layer)
            {
                Bead = toolpath.BeadOf(first), Speed = first.Speed, Length = length, E = e,
                Source = first.Source < 0 ? null : (toolpath.Source == MoveSource.Lines ? "line" : "step", first.Source),
            });
        }
        return parts;
    }

    /// <summary>Writes the facts as user text.</summary>
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
        if (Source is { } source) Text(source.Key, source.Value, 0);
    }
}
