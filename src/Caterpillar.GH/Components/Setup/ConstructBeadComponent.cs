using Caterpillar.GH.Base;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.GH.Components.Setup;

/// <summary>Makes an extrusion from its width and height.</summary>
public sealed class ConstructBeadComponent() : CaterpillarComponent(
    "Construct Bead", "Bead", "Makes the extrusion of a path from its width and height in mm; a width of 0 makes a stroke without extrusion.", Panel.Setup)
{
    public override Guid ComponentGuid => new("d77db240-b5d3-44bc-b5b0-a60a00a49bb9");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Number("Width", "W", "Width of the extrusion, in mm.", 0.45);
        ports.Number("Height", "H", "Height of the extrusion, in mm.", 0.2);
        ports.Number("Flow", "F", "Factor for the cross-section; 1 is the plain extrusion.", 1);
        ports.Number("Speed", "V", "Speed of the head, in mm/s; 0 is the speed of the print settings.", 0);
        ports.Choice("Cross Section", "S", "Shape of the cross-section: a rectangle (as in the Caterpillar paper), a stadium (as in slicers) "
            + "or a circle with the width as diameter.", BeadShape.Stadium);
        ports.Number("Filament Diameter", "D", "Diameter of the filament for the output E Factor, in mm.", 1.75);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new BeadParam(), "Bead", "B", "The extrusion.");
        ports.Number("Area", "A", "Cross-section of the extrusion, in mm².");
        ports.Number("E Factor", "E", "Filament per mm of path, in mm.");
    }

    private protected override void Solve(Run run)
    {
        var bead = Bead.FromWidth(run.Finite(0), run.Finite(1), run.Finite(2), run.Finite(3), run.Choice<BeadShape>(4));
        run.SetAll(new BeadGoo(bead), bead.Area, new ExtrusionModel(ExtrusionUnit.Mm, run.Positive(5)).E(1, bead.Area));
    }
}
