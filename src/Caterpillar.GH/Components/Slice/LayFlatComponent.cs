namespace Caterpillar.GH.Components.Slice;

/// <summary>Turns solids onto their largest flat face.</summary>
public sealed class LayFlatComponent() : ModelMovingComponent(
    "Lay Flat", "Flat", "Turns each solid onto its largest flat face and puts it on the bed (Z = 0), without moving it sideways.")
{
    public override Guid ComponentGuid => new("b24f8d6a-7e19-4c53-a0d8-5e3b1c6f9720");

    private protected override void Inputs(InputPorts ports)
    {
        GeometryPort(ports);
        ports.MeshTolerance();
    }

    private protected override void Solve(Run run)
    {
        var geometry = GeometryOf(run);
        var models = Models(run, geometry, run.Positive(1));
        object[] meshes = Array.ConvertAll(models, m => (object)m.Mesh);
        SetMoved(run, geometry, models, run.Work("Laying flat", meshes, (_, _) => models.LaidFlat()));
    }
}
