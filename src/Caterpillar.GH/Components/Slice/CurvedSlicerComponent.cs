namespace Caterpillar.GH.Components.Slice;

/// <summary>Cuts solids along the level sets of a field and fills the layers.</summary>
public sealed class CurvedSlicerComponent() : SlicerComponent(
    "Curved Slicer", "CSlice", "Slices solids into the curved layers of a field and fills them. Each bead has the volume of the gap below its layer.",
    GH_Exposure.secondary)
{
    public override Guid ComponentGuid => new("5be0b3c2-1d3a-4cf2-9b57-0f2a7c6d41e8");

    private protected override void Inputs(InputPorts ports)
    {
        GeometryPort(ports);
        ports.Setup("Its print head limits the slope of the layers. Nothing is printed below the surface of what it prints on. Default: generic.");
        ports.Add(new LayerFieldParam(), "Field", "F",
            "Layers to follow: a field from Layer Field, a surface to copy upward, or a formula in x, y, z, r (mm) and theta (degrees).");
        ports.Boolean("Partial", "Pa", "Print only parts that are inside the surfaces of the field and not too steep, instead of refusing the solids.", false);
        ports.MeshTolerance();
        ports.Angle("Max Tilt", "MT", "Layers may be steeper by this angle than an upright print head allows, in degrees. Then use Tilt Tool.", 0);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        base.Outputs(ports);
        ports.Add(new LayerFieldParam(), "Field", "F", "Field that the layers follow, for Tilt Tool.");
    }

    private protected override void Solve(Run run)
    {
        var setup = SetupPort.Of(run, 1);
        var recipe = run.Get<FieldRecipe>(2);
        var partial = run.Get<bool>(3);
        var models = Solids(run, 0, run.Positive(4));
        var tilt = run.Within(5, 0, 90, "an angle from 0 to 90 degrees");
        var (solids, units) = (Named(models), run.Units);
        var result = run.Work("Slicing", [recipe, setup, partial, tilt, models], (progress, cancel) =>
        {
            var field = recipe.For(solids, setup, n => n >= 0 && n < models[0].Mesh.Vertices.Count
                ? RhinoGeometry.ToVec(models[0].Mesh.Vertices.Point3dAt(n), units) : null);
            if (field.Value is null || field.HasErrors) return new Result<CurvedResult>(null, field.Diagnostics);
            var options = new CurvedOptions { Onto = setup.PrintedOn is { } floor ? PlanSurface.OnBed(floor) : null, Partial = partial, MaxTilt = tilt };
            var sliced = CurvedSlicer.Slice(solids, field.Value, setup, options, progress, cancel);
            return new Result<CurvedResult>(sliced.Value, field.Diagnostics.Concat(sliced.Diagnostics).ToArray());
        });
        SetResult(run, models, solids, new Result<SliceResult>(result.Value, result.Diagnostics), setup);
        if (result.Value is { } layers) run.Set(6, new LayerFieldGoo { Value = new FieldRecipe(recipe.ToString(), [layers.Field], layers.Field) });
    }
}
