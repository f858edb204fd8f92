using Caterpillar.Curved;
using Caterpillar.GH.Base;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Components.Slice;

/// <summary>Cuts solids along the level sets of a field and fills the layers.</summary>
public sealed class CurvedSlicerComponent() : SlicerComponent(
    "Curved Slicer", "CSlice", "Slices solids into the curved layers of a field and fills them. Each bead has the volume of the gap below its layer.")
{
    public override Guid ComponentGuid => new("5be0b3c2-1d3a-4cf2-9b57-0f2a7c6d41e8");

    private protected override void Inputs(InputPorts ports)
    {
        GeometryPort(ports);
        ports.Add(new LayerFieldParam(), "Field", "F",
            "Layers to follow: a field from Layer Field, a surface to copy upward, or a formula in x, y, z, r (mm) and theta (degrees).");
        ports.Settings("S", "Default: standard.");
        ports.Printer("P", "Its print head limits the slope of the layers. Default: generic.");
        ports.Geometry("Objects", "O", "Objects on the bed to print on. Nothing is printed below their surface, and the first extrusions fill "
            + "the gap to it.", GH_ParamAccess.list, optional: true);
        ports.Boolean("Partial", "Pa", "Print only parts that are inside the surfaces of the field and not too steep, instead of refusing the solids.", false);
        ports.MeshTolerance();
    }

    private protected override void Solve(Run run)
    {
        var tolerance = run.Positive(6);
        var recipe = run.Get<FieldRecipe>(1);
        var setup = new PrintSetup(run.Maybe<Printer>(3) ?? new Printer(), new Material(), run.Maybe<PrintSettings>(2) ?? new PrintSettings());
        var models = Solids(run, 0, tolerance);
        var solids = Named(models);
        var onto = run.Models(4, tolerance);
        var partial = run.Get<bool>(5);
        var result = run.Work("Slicing", [recipe, setup, partial, models, onto], (progress, cancel) =>
        {
            var field = recipe.For(solids, setup);
            if (field.Value is null || field.HasErrors) return new Result<SliceResult>(null, field.Diagnostics);
            var floor = ModelMesh.Joined(onto);
            var options = new CurvedOptions { Onto = floor is null ? null : PlanSurface.OnBed(floor), Partial = partial };
            var sliced = CurvedSlicer.Slice(solids, field.Value, setup, options, progress, cancel);
            return new Result<SliceResult>(sliced.Value, field.Diagnostics.Concat(sliced.Diagnostics).ToArray());
        });
        SetResult(run, models, solids, result);
    }
}
