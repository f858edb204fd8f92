namespace Caterpillar.GH.Components.Path;

/// <summary>Where a pattern comes from.</summary>
public enum ModulationSource
{
    Formula,
    Image,
}

/// <summary>How an image is mapped onto paths.</summary>
public enum ImageProjection
{
    Cylinder,
    Globe,
    Plan,
    Along,
}

/// <summary>Modulates paths by an image or a formula.</summary>
public sealed class ModulateComponent() : PathShapingComponent(
    "Modulate", "Mod", "Modulates the speed, flow or position of print paths by an image or a formula.")
{
    public override Guid ComponentGuid => new("8a2d7c05-4e9b-4f36-b718-5d1c0e6f9a42");

    private protected override void Inputs(InputPorts ports)
    {
        ports.PrintPaths();
        ports.Choice("Source", "So", "Pattern: a formula, or an image.", ModulationSource.Formula);
        ports.For("Source", [ModulationSource.Formula], () => ports.Text("Expression", "E", "Formula from 0 to 1. Example: 0.5 + 0.5 * sin(6 * theta). "
            + "Variables: x, y, z, r in mm, theta in degrees, s (length along the path in mm), u (the same from 0 to 1)."));
        ports.For("Source", [ModulationSource.Image], () =>
        {
            ports.File("Image", "I", "Image (PNG). Black = 0, white = 1.", "Images (*.png)|*.png|All files|*.*");
            ports.Choice("Mapping", "W", "Projection of the image: around the paths, as on a globe, from above, or one row of pixels for each path. The "
                + "image covers all paths.", ImageProjection.Cylinder);
            ports.For("Mapping", [ImageProjection.Cylinder], () => ports.Integer("Repeat", "N", "Number of times the image is repeated around.", 1));
            ports.Boolean("Smooth", "Sm", "Interpolate between pixels instead of using the nearest one.", false);
        });
        ports.Choice("Mode", "M", "Value to change: speed at constant volumetric flow, flow at constant speed, or position (to the left of the path, or "
            + "upward).", ModulationMode.Speed);
        ports.Number("Low", "L", "Value for black or 0: factor for speed or flow, or displacement in mm.", 1);
        ports.Number("High", "H", "Value for white or 1: factor for speed or flow, or displacement in mm.", 0.65);
        ports.Text("Mask", "Ma",
            "Formula for the strength of the effect, from 0 to 1, with the variables of Expression. Default: full strength.", optional: true);
        ports.Number("Resolution", "R", "Maximum segment length, in mm. Longer segments are divided first. 0 = do not divide.", 0);
        ports.FormulaPlane();
    }

    private protected override void Solve(Run run)
    {
        var before = run.Paths(0);
        var byImage = run.Choice<ModulationSource>(run["Source"]) == ModulationSource.Image;
        var file = byImage ? run.PathTo(run.Get<string>(run["Image"])) : null;
        var expression = byImage ? null : run.Get<string>(run["Expression"]);
        var (mode, low, high) = (run.Choice<ModulationMode>(run["Mode"]), run.Finite(run["Low"]), run.Finite(run["High"]));
        var mask = run.Maybe<string>(run["Mask"]);
        var resolution = run.NotNegative(run["Resolution"]);
        var frame = run.FrameOf(run["Plane"]);
        var (lay, smooth, speed) = (run.Choice<ImageProjection>(run["Mapping"]), run.Get<bool>(run["Smooth"]), SpeedOf(before));
        var repeat = run.Get<int>(run["Repeat"]) is >= 1 and var times ? times : throw new InputProblem("Repeat must be 1 or more.");
        object? written = file is null ? null : File.GetLastWriteTimeUtc(file);
        object?[] key = [file, written, expression, mode, low, high, mask, resolution, frame, lay, repeat, smooth, speed, before];
        SetPaths(run, before, run.Work("Modulating", key, (progress, cancel) =>
        {
            var problems = new List<Diagnostic>();
            var local = ToLocal(before.Paths, frame);
            var masking = mask is null ? null : Accept(FieldText.Compile(mask, source: new SourceLocation(Key: "mask")), problems);
            var field = expression is not null
                ? Accept(FieldText.Compile(expression, source: new SourceLocation(Key: "expression")), problems)
                : ImageField(file!, local, lay, repeat, smooth, problems);
            if (field is null || problems.Count > 0) return new Shaped([], problems);
            return Shaped.Of(new Modulation(mode, field, low, high) { Mask = masking, Resolution = resolution, ReferenceSpeed = speed }.Apply(local, progress,
                cancel), frame);
        }));
    }

    private static Field? ImageField(string file, PrintPath[] paths, ImageProjection lay, int repeat, bool smooth, List<Diagnostic> problems)
    {
        if (Accept(ImageReader.Read(file), problems) is not { } image) return null;
        var box = Bounds.Empty;
        foreach (var path in paths) box = box.Include(path.Bounds);
        var size = box.Size;
        if ((lay == ImageProjection.Cylinder && !(size.Z > 0)) || (lay == ImageProjection.Plan && !(size.X > 0 && size.Y > 0)))
            throw new InputProblem($"The paths are too flat for the mapping {lay}. Choose another one.");
        var mapping = lay switch
        {
            ImageProjection.Cylinder => ImageMappings.Cylinder(box.Min.Z, box.Max.Z, repeats: repeat),
            ImageProjection.Globe => ImageMappings.Globe(new Vec3(0, 0, box.Center.Z)),
            ImageProjection.Plan => ImageMappings.Plan(box.Min, size.X, size.Y),
            _ => ImageMappings.Along(image.Height),
        };
        return Fields.Image(image, mapping, smooth);
    }

    private static T? Accept<T>(Result<T> result, List<Diagnostic> problems)
        where T : class
    {
        problems.AddRange(result.Diagnostics);
        return result.Value;
    }
}
