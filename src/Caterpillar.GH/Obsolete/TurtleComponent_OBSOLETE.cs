using System;
using Caterpillar.GH.Base;
using Caterpillar.GH.Components.Design;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Obsolete;

/// <summary>Turtle as it was when Bead came after Every Pose: definitions that have it still solve, and can be upgraded.</summary>
public sealed class TurtleComponent_OBSOLETE() : TurtleBase(beadInput: 4, lengthInput: 2)
{
    public override Guid ComponentGuid => new("b7f06a52-91de-4f7b-8a2a-40d9c55f3c12");

    public override GH_Exposure Exposure => GH_Exposure.hidden;

    public override bool Obsolete => true;

    private protected override void Inputs(InputPorts ports)
    {
        ProgramPorts(ports);
        LengthPorts(ports);
        BeadPort(ports);
        SetupInputs(ports);
    }
}

/// <summary>Replaces the old Turtle by the one of today.</summary>
public sealed class TurtleUpgrade : PortUpgrade
{
    public override DateTime Version => new(2026, 11, 22);

    public override Guid UpgradeFrom => new("b7f06a52-91de-4f7b-8a2a-40d9c55f3c12");

    public override Guid UpgradeTo => new TurtleComponent().ComponentGuid;

    // Program, Start Plane, Filament Diameter, Every Pose, Bead, Printer, Material, Settings.
    private protected override int[] InputsNow => [0, 1, 3, 4, 2, 5, 6, 7];

    private protected override IGH_Component Make() => new TurtleComponent();
}
