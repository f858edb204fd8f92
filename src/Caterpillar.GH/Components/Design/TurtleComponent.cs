using System;
using Caterpillar.GH.Base;

namespace Caterpillar.GH.Components.Design;

/// <summary>Runs turtle programs.</summary>
public sealed class TurtleComponent() : TurtleBase(beadInput: 2, lengthInput: 3)
{
    public override Guid ComponentGuid => new("4d9e2c17-86ab-4f50-b3e1-7c05d8a9f264");

    private protected override void Inputs(InputPorts ports)
    {
        ProgramPorts(ports);
        BeadPort(ports);
        LengthPorts(ports);
        SetupInputs(ports);
    }
}
