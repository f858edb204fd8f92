namespace Caterpillar.GH.Components.Slice;

/// <summary>Base of the components that put models into place: any geometry in, the same geometry out, moved and turned.</summary>
public abstract class ModelMovingComponent(string name, string nickname, string description)
    : CaterpillarComponent(name, nickname, description, Panel.Slice, GH_Exposure.tertiary)
{
    private protected static void GeometryPort(InputPorts ports)
        => ports.Geometry("Geometry", "G", "Solids: meshes, boxes, Breps, SubDs, extrusions or surfaces.", GH_ParamAccess.list);

    private protected sealed override void Outputs(OutputPorts ports)
    {
        ports.Add(new Param_Geometry(), "Geometry", "G", "Solids in their new position.", GH_ParamAccess.list);
        ports.Add(new Param_Transform(), "Transforms", "X", "Transformation of each solid.", GH_ParamAccess.list);
        ports.Diagnostics();
    }

    private protected static IReadOnlyList<IGH_GeometricGoo> GeometryOf(Run run) => run.Some<IGH_GeometricGoo>(0);

    private protected static NamedMesh[] Models(Run run, IReadOnlyList<IGH_GeometricGoo> geometry, double tolerance)
        => geometry.Select((g, i) => new NamedMesh($"Solid {NumberFormatter.Format(i)}", run.ModelOf(g, tolerance).Triangles)).ToArray();

    /// <summary>Moves the geometry like its meshes. Copies repeat the list of solids.</summary>
    private protected static void SetMoved(Run run, IReadOnlyList<IGH_GeometricGoo> geometry, IReadOnlyList<NamedMesh> before, IReadOnlyList<NamedMesh> after)
    {
        var maps = after.Select((m, i) => RhinoGeometry.ToTransform(Map(before[i % before.Count].Mesh, m.Mesh), run.Units)).ToArray();
        run.SetList(0, maps.Select((map, i) => geometry[i % geometry.Count].DuplicateGeometry().Transform(map)));
        run.SetList(1, maps);
    }

    // The rigid motion that takes the largest triangle to its place.
    private static Affine Map(TriMesh from, TriMesh to)
    {
        var (best, area) = (-1, 0.0);
        for (var t = 0; t < from.TriangleCount; t++)
        {
            var (a, b, c) = Corners(from, t);
            var size = Vec3.Cross(b - a, c - a).Length;
            if (size > area) (best, area) = (t, size);
        }
        if (best < 0) return Affine.Identity;
        var (old, now) = (FrameOf(from, best), FrameOf(to, best));
        Vec3 At(Vec3 p) => now.ToWorld(old.ToLocal(p));
        var shift = At(Vec3.Zero);
        return new Affine(At(Vec3.UnitX) - shift, At(Vec3.UnitY) - shift, At(Vec3.UnitZ) - shift, shift);
    }

    private static Frame FrameOf(TriMesh mesh, int triangle)
    {
        var (a, b, c) = Corners(mesh, triangle);
        return Frame.FromAxes(a, b - a, c - a);
    }

    private static (Vec3 A, Vec3 B, Vec3 C) Corners(TriMesh mesh, int triangle)
        => (mesh.Vertices[mesh.Indices[3 * triangle]], mesh.Vertices[mesh.Indices[3 * triangle + 1]], mesh.Vertices[mesh.Indices[3 * triangle + 2]]);
}
