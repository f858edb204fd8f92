namespace Caterpillar.GH.Components.Slice;

/// <summary>Base of the slicers: geometry in, layers as trees out.</summary>
public abstract class SlicerComponent(string name, string nickname, string description, GH_Exposure exposure)
    : CaterpillarComponent(name, nickname, description, Panel.Slice, exposure)
{
    private protected static void GeometryPort(InputPorts ports) => ports.Geometry("Geometry", "G",
        "Solids to slice, in their print position: meshes, boxes, Breps, SubDs, extrusions or surfaces.", GH_ParamAccess.list);

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Paths", "P", "All print paths, one branch per layer.", GH_ParamAccess.tree);
        ports.Add(new PrintPathParam { Hidden = true }, "Walls", "W", "Walls, one branch per layer.", GH_ParamAccess.tree);
        ports.Add(new PrintPathParam { Hidden = true }, "Infill", "I", "Infill, one branch per layer.", GH_ParamAccess.tree);
        ports.Add(new Param_Curve { Hidden = true }, "Regions", "R",
            "Outlines of the layers, one branch per layer. Curved layers are seen from above.", GH_ParamAccess.tree);
        ports.Curve("Naked Edges", "E", "Naked edges of the solids.", GH_ParamAccess.list);
        ports.Diagnostics();
    }

    private protected static ModelMesh[] Solids(Run run, int input, double tolerance)
        => run.Models(input, tolerance) is { Length: > 0 } models ? models : throw run.Missing(input);

    private protected static NamedMesh[] Named(IReadOnlyList<ModelMesh> models)
        => models.Select((m, i) => new NamedMesh($"Solid {NumberFormatter.Format(i)}", m.Triangles)).ToArray();

    /// <summary>Gives the layers and the problems.</summary>
    private protected static void SetResult(Run run, IReadOnlyList<ModelMesh> models, IReadOnlyList<NamedMesh> solids, Result<SliceResult> result,
        PrintSetup setup)
    {
        var units = run.Units;
        run.SetList(4, models.Where(m => m.Triangles.NakedEdgeCount > 0).SelectMany(m => m.Mesh.GetNakedEdges() ?? []).Select(p => p.ToPolylineCurve()));
        run.Report(solids.Where(m => m.Mesh.NakedEdgeCount > 0).Select(Open));
        var slices = run.Require(result);
        var root = run.PathOf(0);
        var trees = run.Cached([slices, setup, root.ToString(), units.ToMillimeters], () => new LayerTrees(slices, setup, root, units));
        run.SetTree(0, trees.All);
        run.SetTree(1, trees.Walls);
        run.SetTree(2, trees.Infill);
        run.SetTree(3, trees.Regions);
        run.Summarize($"{NumberFormatter.Format(slices.Layers.Count)} layers");
    }

    private static Diagnostic Open(NamedMesh model) => new(Severity.Warning, "mesh.naked_edges",
        $"The mesh has {NumberFormatter.Format(model.Mesh.NakedEdgeCount)} naked edges. See the output Naked Edges.", new SourceLocation(model.Name));

    private static bool IsWall(Role role) => role is Role.OuterWall or Role.InnerWall or Role.OverhangWall;

    /// <summary>The layers as trees for the wires, one branch per layer.</summary>
    private sealed class LayerTrees
    {
        public LayerTrees(SliceResult slices, PrintSetup setup, GH_Path root, DocumentUnits units)
        {
            for (var i = 0; i < slices.Layers.Count; i++)
            {
                var layer = slices.Layers[i];
                var path = root.AppendElement(i);
                var goos = layer.Steps.Select(s => new PrintPathGoo(s, setup)).ToArray();
                All.AppendRange(goos, path);
                Walls.AppendRange(goos.Where(g => IsWall(g.Value.Role)), path);
                Infill.AppendRange(goos.Where(g => !IsWall(g.Value.Role)), path);
                Regions.AppendRange(layer.Region.Contours.Select(c => new GH_Curve(RhinoGeometry.ToCurve(c, layer.Layer.Z, units))), path);
            }
        }

        public GH_Structure<PrintPathGoo> All { get; } = new();

        public GH_Structure<PrintPathGoo> Walls { get; } = new();

        public GH_Structure<PrintPathGoo> Infill { get; } = new();

        public GH_Structure<GH_Curve> Regions { get; } = new();
    }
}
