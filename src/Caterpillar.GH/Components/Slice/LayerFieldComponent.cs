namespace Caterpillar.GH.Components.Slice;

/// <summary>How the layers of a curved print are given.</summary>
public enum FieldKind
{
    Vertical,
    Normal,
    Between,
    Formula,
    Cone,
    Overhangs,
    Deformed,
    Harmonic,
    Geodesic,
    Smooth,
}

/// <summary>Where the surfaces of layers come from.</summary>
public enum SurfaceSource
{
    Geometry,
    Formula,
    HeightMap,
}

/// <summary>Makes the field whose level sets are the layers of a print.</summary>
public sealed class LayerFieldComponent() : ChosenPortsComponent(
    "Layer Field", "Field", "Creates curved layers from surfaces, formulas or an image.", Panel.Slice, GH_Exposure.secondary)
{
    public override Guid ComponentGuid => new("e1a5c8d7-3f42-4b6e-9a10-6b8d2f7c0e39");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Choice("Kind", "K", "Kind of layers. Vertical: copies of a surface, moved up. Normal: offsets of a surface. Between: division of the space below "
            + "a surface, or between several. Formula: level sets of a formula. Cone: cones about a vertical axis. Overhangs: layers that descend from the "
            + "footprint of the solids. Deformed: flat layers of the bent solids. Harmonic: even change from the lower to the upper boundaries of the solids, "
            + "also across branches. Geodesic: the same by distance. Smooth: level layers, bent so that gently sloped tops have no steps.", FieldKind.Vertical);
        ports.For("Kind", [FieldKind.Vertical, FieldKind.Between], () => ports.Choices("Sources", "So",
            "Where the surfaces come from: geometry, formulas of their height, or a height map. Several are possible.", SurfaceSource.Geometry));
        FieldKind[] surfaces = [FieldKind.Vertical, FieldKind.Normal, FieldKind.Between, FieldKind.Harmonic, FieldKind.Geodesic];
        ports.For("Kind", surfaces, () => ports.For("Sources", [SurfaceSource.Geometry], () => ports.Geometry("Surfaces", "S", "Surfaces from bottom to top: "
            + "the uppermost faces of meshes, Breps, SubDs, extrusions or surfaces. Harmonic and Geodesic: surfaces or curves on the solids at which layers "
            + "end. Default: found automatically.", GH_ParamAccess.list, optional: true)));
        ports.For("Kind", [FieldKind.Harmonic, FieldKind.Geodesic], () => ports.Geometry("Lower Boundaries", "LB",
            "Surfaces or curves on the solids at which layers begin. Default: the bottom.", GH_ParamAccess.list, optional: true));
        ports.For("Sources", [SurfaceSource.Formula],
            () => ports.Text("Heights", "Hs", "Formulas of the height of surfaces in x and y, in mm.", access: GH_ParamAccess.list, optional: true));
        ports.For("Kind", [FieldKind.Formula, FieldKind.Deformed], () => ports.Text("Expressions", "E", "Formula: field in x, y, z, r (mm) and theta "
            + "(degrees), such as z - 2 * sin(9 * x). Deformed: bent x, y and z.", access: GH_ParamAccess.list, optional: true));
        ports.For("Sources", [SurfaceSource.HeightMap], () =>
        {
            ports.File("Image", "I",
                "Height map over the solids (PNG). Black = Low, white = High.", "Images (*.png)|*.png|All files|*.*", optional: true);
            ports.Number("Low", "L", "Height of black, in mm.", 0);
            ports.Number("High", "H", "Height of white, in mm.", 2);
        });
        ports.For("Kind", [FieldKind.Vertical], () =>
        {
            ports.Number("Blend From", "F", "Layers are level up to this height, in mm. Default: the first layer.", optional: true);
            ports.Number("Blend To", "To", "Layers follow the surface from this height on, in mm. Default: all layers follow it.", optional: true);
        });
        ports.For("Kind", [FieldKind.Cone, FieldKind.Overhangs], () => ports.Angle("Angle", "A", "Slope of the layers, in degrees. Positive = "
            + "falling outward. Default of Overhangs: the minimum that makes all overhangs at least 45 degrees steep.", optional: true));
        FieldKind[] placed = [FieldKind.Vertical, FieldKind.Between, FieldKind.Formula, FieldKind.Deformed, FieldKind.Cone];
        ports.For("Kind", placed, () => ports.Add(new Param_Point(), "Origin", "O",
            "Origin of the formulas (default: world origin) or axis of the cone (default: center of the solids).", optional: true));
        ports.For("Kind", surfaces, () => ports.MeshTolerance());
        ports.For("Kind", [FieldKind.Harmonic, FieldKind.Geodesic], () =>
        {
            const string Instead = " of the solid, counted from 0 in its mesh, instead of surfaces and curves. It must be the only solid.";
            ports.Integer("Upper Vertices", "UV", "Vertices at which layers end, by their numbers" + Instead, access: GH_ParamAccess.list, optional: true);
            ports.Integer("Lower Vertices", "LV", "Vertices at which layers begin, by their numbers" + Instead, access: GH_ParamAccess.list, optional: true);
        });
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new LayerFieldParam(), "Field", "F", "Field for Curved Slicer.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var problems = new List<Diagnostic>();
        var field = new FieldPorts(run, problems).Read();
        run.Report(problems);
        run.Set(0, field is null ? null : new LayerFieldGoo { Value = field });
        if (field is not null) run.Summarize(run.Choice<FieldKind>(0).ToString());
    }
}
