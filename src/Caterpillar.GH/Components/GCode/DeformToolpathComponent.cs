namespace Caterpillar.GH.Components.GCode;

/// <summary>Deforms a toolpath by formulas.</summary>
public sealed class DeformToolpathComponent() : ChosenPortsComponent(
    "Deform Toolpath", "DeformT",
        "Deforms the extrusions of a toolpath by formulas for position, area and speed. The material follows their new length.", Panel.GCode,
    GH_Exposure.tertiary)
{
    public override Guid ComponentGuid => new("0f6d3c8e-91b7-4a25-b2d4-5ce81f7a0936");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Toolpath();
        ports.Filter();
        DeformationPorts.Declare(ports);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new ToolpathParam(), "Toolpath", "T", "Toolpath with the selected extrusions deformed.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var goo = run.Get<ToolpathGoo>(0);
        // Start and end code, which belong to no layer, stay.
        var filter = run.Filter().InLayersOf(goo.Value);
        var request = DeformationPorts.Read(run);
        if (request.Tolerance == 0) throw new InputProblem("Tolerance must be greater than zero.");
        var frame = request.Frame;
        var deformation = run.Require(request.Compile());
        if (frame != Frame.World)
            deformation = Deformation.Cartesian(p => frame.ToLocal(p)).Then(deformation).Then(Deformation.Cartesian(p => frame.ToWorld(p)));
        var result = run.Work("Deforming", [goo.Value, filter, .. request.Key],
            (_, cancel) => goo.Value.Deform(filter, deformation, request.Tolerance, cancel));
        run.Set(0, goo.With(run.Require(result)));
    }
}
