using System;
using Caterpillar.Basics;
using Caterpillar.GH.Base;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Tests.Base;

/// <summary>A component that finds something before it reads a number, which must be positive.</summary>
internal sealed class NotingComponent() : CaterpillarComponent("Noting", "Noting", "Notes and reads.", "Test")
{
    public override Guid ComponentGuid => new("5f0c3d0e-7c0e-4a3e-9a51-6f7f2c7c0f12");

    private protected override void Inputs(InputPorts ports) => ports.Number("Value", "V", "A number.", 1);

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Text("Result", "R", "A text.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        run.Report([new Diagnostic(Severity.Note, "test.found", "Something was found.")]);
        run.Set(0, NumberFormatter.Format(run.Positive(0), 3));
    }
}
