namespace Caterpillar.GH.Components.Slice;

/// <summary>Cuts solids into planar layers and fills them.</summary>
public sealed class PlanarSlicerComponent() : SlicerComponent(
    "Planar Slicer", "Slice", "Slices solids on the bed (Z = 0) into planar layers and fills them with walls and infill.", GH_Exposure.primary)
{
    public override Guid ComponentGuid => new("378f4dfe-ec2e-4716-a6dd-c0709743ec9b");

    private protected override void Inputs(InputPorts ports)
    {
        GeometryPort(ports);
        ports.Setup();
        ports.Add(new SettingsParam(), "Part Settings", "PS", "Print settings for each solid. They replace those of the setup. The last ones also apply to "
            + "all remaining solids. The setup still controls travel moves, skirt, brim and raft.", GH_ParamAccess.list, optional: true);
        ports.Geometry("Modifiers", "M", "Solids that are not printed. Depending on their model_type, they change the settings inside them, or enforce or "
            + "block supports.", GH_ParamAccess.list, optional: true);
        ports.Add(new SettingsParam(), "Modifier Settings", "MS",
            "Print settings of each modifier. The last one applies to the remaining modifiers.", GH_ParamAccess.list, optional: true);
        ports.Add(new Param_Curve { Optional = true }, "Infill Curves", "C",
            "Curves for the infill of every layer, seen from above, instead of the infill pattern.", GH_ParamAccess.list, optional: true);
        ports.MeshTolerance();
    }

    private protected override void Solve(Run run)
    {
        var tolerance = run.Positive(6);
        var setup = SetupPort.Of(run, 1);
        var settings = setup.Settings;
        var models = Solids(run, 0, tolerance);
        var solids = Named(models);
        if (InfillCurves(run, 5, tolerance) is { } curves) settings = settings with { InfillPattern = InfillPattern.Curves, InfillCurves = curves };
        setup = setup with { Settings = settings };
        var modifiers = Modifiers(run, tolerance, setup);
        var parts = Parts(run, solids, setup);
        SliceModel[] all = [.. parts, .. modifiers];
        object[] helpers = modifiers.SelectMany(m => new object[] { m.Mesh.Mesh, m.Settings }).ToArray();
        // Only a purge tower depends on the bed.
        var printer = settings.PurgeTower ? PrimedArea.Excluded(setup, isForTower: true) : new Printer();
        var result = run.Work("Slicing", [settings, models, parts.Select(p => p.Settings).ToArray(), helpers, printer],
            (progress, cancel) => PlanarSlicer.SliceEach(all, settings, new SliceOptions { Printer = printer }, progress, cancel));
        SetResult(run, models, solids, result, setup);
    }

    // Solids that are null count, so that each keeps its own settings.
    private static SliceModel[] Parts(Run run, NamedMesh[] solids, PrintSetup setup)
    {
        var own = run.List<SettingsGoo>(2);
        if (own.Count == 0) return solids.Select(m => new SliceModel(m, setup.Settings)).ToArray();
        var geometry = run.WithNulls<IGH_GeometricGoo>(0);
        if (own.Count > geometry.Count)
        {
            var (given, solid) = (NumberFormatter.Format(own.Count), NumberFormatter.Format(geometry.Count));
            run.Report(GH_RuntimeMessageLevel.Warning, $"{given} Part Settings for {solid} solids: the last ones are not used.");
        }
        var places = Enumerable.Range(0, geometry.Count).Where(i => geometry[i] is not null).ToArray();
        return solids.Select((m, i) =>
        {
            var settings = own[Math.Min(places[i], own.Count - 1)].Value;
            if (settings.ModelType != ModelType.Part)
                throw new InputProblem($"Part Settings of {m.Name} have a model_type that is not printed. Connect the solid to Modifiers.");
            return new SliceModel(m, Own(settings, setup));
        }).ToArray();
    }

    // Sizes that follow from the nozzle and infill of curves are those of the print.
    private static PrintSettings Own(PrintSettings own, PrintSetup setup)
    {
        own = (setup with { Settings = own }).Settings;
        return own.InfillPattern == InfillPattern.Curves && own.InfillCurves.Count == 0 ? own with { InfillCurves = setup.Settings.InfillCurves } : own;
    }

    // Settings for a part are those of a modifier here: a part would be among the solids.
    private static SliceModel[] Modifiers(Run run, double tolerance, PrintSetup setup)
    {
        var geometry = run.List<IGH_GeometricGoo>(3);
        var settings = run.List<SettingsGoo>(4);
        if (geometry.Count == 0 && settings.Count > 0)
            run.Report(GH_RuntimeMessageLevel.Warning, "Modifier Settings have no effect without Modifiers.");
        if (geometry.Count == 0) return [];
        if (settings.Count == 0) throw run.Missing(4);
        return geometry.Select((g, i) =>
        {
            var own = settings[Math.Min(i, settings.Count - 1)].Value;
            if (own.ModelType == ModelType.Part) own = own with { ModelType = ModelType.Modifier };
            var mesh = new NamedMesh($"Modifier {NumberFormatter.Format(i)}", run.ModelOf(g, tolerance).Triangles);
            return new SliceModel(mesh, Own(own, setup));
        }).ToArray();
    }

    private static ValueList<InfillPoint>? InfillCurves(Run run, int input, double tolerance)
    {
        var curves = run.List<GH_Curve>(input);
        if (curves.Count == 0) return null;
        var options = SubdivisionOptions.ByTolerance(tolerance);
        return InfillPoint.Of(curves.Select(c =>
        {
            var divided = CurveSubdivider.Subdivide(RhinoCurves.ToCurve(c.Value, run.Units), options);
            return new Polyline(divided.Points.Select(p => p.WithZ(0)), divided.IsClosed);
        }));
    }
}
