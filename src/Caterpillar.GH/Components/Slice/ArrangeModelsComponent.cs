namespace Caterpillar.GH.Components.Slice;

/// <summary>Puts solids next to each other on a bed.</summary>
public sealed class ArrangeModelsComponent() : ModelMovingComponent(
    "Arrange Models", "Arrange", "Arranges solids, or several copies of each, on the bed of a printer, from the center outward.")
{
    public override Guid ComponentGuid => new("3c7e9a41-50bd-4d18-8e26-91f4a0b7c5d2");

    private protected override void Inputs(InputPorts ports)
    {
        GeometryPort(ports);
        ports.Setup();
        ports.Integer("Count", "C", "Number of copies of each solid.", 1);
        ports.Number("Spacing", "S", "Minimum distance between solids, seen from above, in mm.", new ArrangeOptions().Spacing);
        ports.Number("Margin", "M", "Minimum distance to the edge of the bed, in mm.", new ArrangeOptions().Margin);
        ports.Boolean("Sequential", "Sq", "Leave room for the print head to print one solid after the other.", false);
        ports.MeshTolerance();
    }

    private protected override void Solve(Run run)
    {
        var geometry = GeometryOf(run);
        var setup = SetupPort.Of(run, 1);
        var printer = PrimedArea.Excluded(setup);
        var pieces = run.Get<int>(2) is >= 1 and <= 10000 and var count ? count : throw new InputProblem("Count must be 1 to 10000.");
        var (spacing, margin) = (run.NotNegative(3), run.NotNegative(4));
        var options = new ArrangeOptions { Spacing = spacing, Margin = margin, OneAfterTheOther = run.Get<bool>(5) };
        var models = Models(run, geometry, run.Positive(6));
        object[] meshes = Array.ConvertAll(models, m => (object)m.Mesh);
        var result = run.Work("Arranging", [meshes, printer, pieces, options],
            (_, cancel) => ModelArranger.Arrange(models.Copies(pieces), printer, options, cancel));
        SetMoved(run, geometry, models, run.Require(result));
    }
}
