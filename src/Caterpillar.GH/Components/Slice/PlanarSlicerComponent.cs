using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.GH.Base;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Components.Slice;

/// <summary>Cuts solids into planar layers and fills them.</summary>
public sealed class PlanarSlicerComponent() : CaterpillarComponent(
    "Planar Slicer", "Slice", "Cuts solids that stand on the bed (Z = 0) into planar layers and fills them with walls and infill.", Panel.Slice)
{
    public override Guid ComponentGuid => new("378f4dfe-ec2e-4716-a6dd-c0709743ec9b");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Geometry("Geometry", "G", "Solids to slice, in document units, at the position where they are printed: meshes, Breps, SubDs or extrusions.",
            GH_ParamAccess.list);
        ports.Add(new SettingsParam(), "Settings", "S", "Print settings; the standard ones by default.", optional: true);
        ports.Number("Tolerance", "T", "Maximum deviation of facets from a curved solid, in mm.", 0.05);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Paths", "P", "All paths, one branch per layer, in mm on the wire.", GH_ParamAccess.tree);
        ports.Add(new PrintPathParam(), "Walls", "W", "The walls alone, one branch per layer.", GH_ParamAccess.tree);
        ports.Add(new PrintPathParam(), "Infill", "I", "The infill alone, one branch per layer.", GH_ParamAccess.tree);
        ports.Curve("Regions", "R", "Outlines of what each layer covers, one branch per layer, in document units.", GH_ParamAccess.tree);
        ports.Curve("Open Edges", "E", "Edges where the surface of a solid is open, in document units.", GH_ParamAccess.list);
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var tolerance = run.Positive(2);
        var settings = run.Maybe<PrintSettings>(1) ?? new PrintSettings();
        var units = run.Units;
        var geometry = run.List<IGH_GeometricGoo>(0);
        if (geometry.Count == 0) throw new InputProblem("Geometry is missing.") { IsMissing = true };
        var meshes = geometry.Select(g => RhinoMesh.ToMesh(g.ScriptVariable(), tolerance, units)).ToList();
        var key = meshes.Select(m => (object)m.DataCRC(0)).Concat([settings, units.ToMillimeters]).ToArray();
        var (models, result) = run.Cached(key, () =>
        {
            var solids = meshes.Select((m, i) => new NamedMesh($"Solid {NumberFormatter.Format(i)}", RhinoMesh.ToTriangles(m, units))).ToList();
            return Tuple.Create(solids, run.Work("Slicing", (progress, cancel) => PlanarSlicer.Slice(solids, settings, 0, progress, cancel)));
        });
        run.SetList(4, OpenEdges(meshes, models));
        run.SetList(5, run.Report(models.Where(m => m.Mesh.OpenEdgeCount > 0).Select(Open).Concat(result.Diagnostics)));
        if (result.Value is { } slices) SetLayers(run, slices, units);
    }

    private static Diagnostic Open(NamedMesh model) => new(Severity.Warning, "mesh.open_edges",
        $"The surface has {NumberFormatter.Format(model.Mesh.OpenEdgeCount)} open edges, which the output Open Edges shows.", new SourceLocation(model.Name));

    private static IEnumerable<Rg.PolylineCurve> OpenEdges(List<Rg.Mesh> meshes, List<NamedMesh> models) => meshes
        .Where((_, i) => models[i].Mesh.OpenEdgeCount > 0)
        .SelectMany(m => m.GetNakedEdges() ?? [])
        .Select(p => p.ToPolylineCurve());

    private static void SetLayers(Run run, SliceResult slices, DocumentUnits units)
    {
        GH_Structure<PrintPathGoo> all = new(), walls = new(), infill = new();
        var regions = new GH_Structure<GH_Curve>();
        for (var i = 0; i < slices.Layers.Count; i++)
        {
            var layer = slices.Layers[i];
            var path = run.PathOf(0).AppendElement(i);
            all.AppendRange(layer.Steps.Select(s => new PrintPathGoo(s)), path);
            walls.AppendRange(layer.Steps.Where(s => IsWall(s.Path.Role)).Select(s => new PrintPathGoo(s)), path);
            infill.AppendRange(layer.Steps.Where(s => !IsWall(s.Path.Role)).Select(s => new PrintPathGoo(s)), path);
            regions.AppendRange(layer.Region.Contours.Select(c => new GH_Curve(RhinoGeometry.ToCurve(c, layer.Layer.Z, units))), path);
        }
        run.SetTree(0, all);
        run.SetTree(1, walls);
        run.SetTree(2, infill);
        run.SetTree(3, regions);
        run.Summarize($"{NumberFormatter.Format(slices.Layers.Count)} layers");
    }

    private static bool IsWall(Role role) => role is Role.OuterWall or Role.InnerWall or Role.OverhangWall;
}
