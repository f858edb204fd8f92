using Caterpillar.Basics;
using Caterpillar.GH.Base;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;

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
}

/// <summary>Makes the field whose level sets are the layers of a print.</summary>
public sealed class LayerFieldComponent() : CaterpillarComponent(
    "Layer Field", "Field", "Makes the layers of a curved print from surfaces, formulas or an image.", Panel.Slice)
{
    public override Guid ComponentGuid => new("e1a5c8d7-3f42-4b6e-9a10-6b8d2f7c0e39");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Choice("Kind", "K",
            "What the layers are: copies of a surface moved upward (Vertical) or offset (Normal); a division of the space from the bed to a surface or between "
                + "several (Between); level sets of a formula (Formula); cones about a vertical axis (Cone); layers that descend from where the solids stand "
                + "on the bed (Overhangs); the flat layers of bent solids (Deformed); or an even change along the solids themselves from their lower to "
                + "their upper ends, also where they branch (Harmonic, or Geodesic by distances).",
            FieldKind.Vertical);
        ports.Geometry("Surfaces", "S",
            "Surfaces in document units, from below: the uppermost faces of meshes, Breps, SubDs, extrusions or surfaces. For Harmonic and Geodesic: "
                + "surfaces or curves on the solids, where layers end; without them ends are found.",
            GH_ParamAccess.list, optional: true);
        ports.Text("Expressions", "E",
            "Formulas: the height of a surface in x and y; for Formula the field in x, y, z, r and theta, such as z - 2 * sin(9 * x); for Deformed the bent x, "
                + "y and z. Lengths in mm, angles in degrees.",
            access: GH_ParamAccess.list, optional: true);
        ports.File("Image", "I", "Image as a height map over the solids (PNG, PGM): black is Low, white is High.",
            "Images (*.png;*.pgm)|*.png;*.pgm|All files|*.*", optional: true);
        ports.Number("Low", "L", "Height of black in mm.", 0);
        ports.Number("High", "H", "Height of white in mm.", 2);
        ports.OptionalNumber("Blend From", "F", "For Vertical: layers are level up to this height in mm; the first layer by default.");
        ports.OptionalNumber("Blend To", "To", "For Vertical: layers follow the surface from this height on, in mm; without it all of them do.");
        ports.OptionalAngle("Angle", "A",
            "For Cone: how much layers descend outward, in degrees; they rise where it is negative. For Overhangs: the same; by default the least angle that "
                + "makes all overhangs at least 45 degrees steep.");
        ports.Add(new Param_Point(), "Origin", "O",
            "Origin of the formulas, in document units, the world's by default; axis of the cone, by default through the middle of the solids.",
                optional: true);
        ports.Number("Tolerance", "T", "Maximum deviation of facets from a curved surface, in mm.", 0.05);
        ports.Geometry("Lower Ends", "LE", "For Harmonic and Geodesic: surfaces or curves on the solids, where layers begin; the bottom by default.",
            GH_ParamAccess.list, optional: true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new LayerFieldParam(), "Field", "F", "The layers, for Curved Slicer.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var problems = new List<Diagnostic>();
        var field = new FieldPorts(run, problems).Read();
        run.Report(problems);
        run.Set(0, field is null ? null : new LayerFieldGoo(field));
        if (field is not null) run.Summarize(run.Choice<FieldKind>(0).ToString());
    }
}
