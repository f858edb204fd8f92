namespace Caterpillar.GH.Components.Path;

/// <summary>Takes a print path apart.</summary>
public sealed class DeconstructPrintPathComponent() : CaterpillarComponent(
    "Deconstruct Print Path", "DePPath", "Deconstructs a print path into points, areas, widths, heights and speeds, as Construct Print Path takes them.",
    Panel.Path)
{
    public override Guid ComponentGuid => new("e6ce3d42-9733-467d-adc0-7f8b0c87d00c");

    private protected override void Inputs(InputPorts ports)
        => ports.Add(new PrintPathParam(), "Print Path", "P", "Print path to deconstruct.");

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Point("Points", "Pt", "Points of the path. A closed path does not repeat its first point.", GH_ParamAccess.list);
        ports.Number("Areas", "A", "Area of the cross-section of each segment, in mm².", GH_ParamAccess.list);
        ports.Number("Speeds", "V", "Speed of each segment, in mm/s. 0 = speed of the print settings.", GH_ParamAccess.list);
        ports.Text("Role", "R", "Role of the path, such as OuterWall or Infill.");
        ports.Integer("Layer", "L", "Layer number, from 0. -1 = no layer.");
        ports.Number("Widths", "W", "Width of each segment, in mm, for the bead shape of the setup.", GH_ParamAccess.list);
        ports.Number("Heights", "H", "Height of each segment, in mm. 0 = unknown.", GH_ParamAccess.list);
    }

    private protected override void Solve(Run run)
    {
        var goo = run.Get<PrintPathGoo>(0);
        var path = goo.Value;
        var units = run.Units;
        var shape = (goo.Setup?.Settings ?? new PrintSettings()).BeadShape;
        var segments = Enumerable.Range(0, path.SegmentCount);
        run.SetList(0, path.Points.Select(p => RhinoGeometry.ToPoint(p, units)));
        run.SetList(1, segments.Select(i => path.BeadOf(i).Area));
        run.SetList(2, segments.Select(i => path.BeadOf(i).Speed));
        run.Set(3, path.Role.ToString());
        run.Set(4, path.Layer?.Index ?? -1);
        run.SetList(5, segments.Select(i => path.BeadOf(i).Width(shape)));
        run.SetList(6, segments.Select(i => path.BeadOf(i).Height));
    }
}
