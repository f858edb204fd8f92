namespace Caterpillar.GH.Components.Setup;

/// <summary>Makes an extrusion from its width and height.</summary>
public sealed class ConstructBeadComponent() : CaterpillarComponent(
    "Construct Bead", "Bead", "Creates the bead of an extrusion from its width and height.", Panel.Setup,
    GH_Exposure.secondary)
{
    public override Guid ComponentGuid => new("d77db240-b5d3-44bc-b5b0-a60a00a49bb9");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Number("Width", "W", "Bead width, in mm. 0 = no extrusion.", 0.45);
        ports.Number("Height", "H", "Bead height, in mm.", 0.2);
        ports.Number("Flow", "F", "Flow ratio of the extrusion.", 1);
        ports.Number("Speed", "V", "Print speed, in mm/s. 0 = speed of the print settings.", 0);
        ports.Choice("Cross Section", "S", "Shape of the cross-section: rectangle (as in the Caterpillar paper), stadium (as in slicers), or circle with the "
            + "width as its diameter.", BeadShape.Stadium);
        ports.Number("Filament Diameter", "D", "Filament diameter, in mm.", 1.75);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new BeadParam(), "Bead", "B", "Size and speed of an extrusion, for Construct Print Path, Turtle and traces.");
        ports.Number("Area", "A", "Area of the cross-section, in mm².");
        ports.Number("E Factor", "E", "Filament length per mm of path, in mm.");
    }

    private protected override void Solve(Run run)
    {
        var bead = Bead.FromWidth(run.Finite(0), run.Finite(1), run.Finite(2), run.Finite(3), run.Choice<BeadShape>(4));
        run.SetAll(new BeadGoo(bead), bead.Area, new ExtrusionModel(ExtrusionUnit.Mm, run.Positive(5)).E(1, bead.Area));
    }
}
