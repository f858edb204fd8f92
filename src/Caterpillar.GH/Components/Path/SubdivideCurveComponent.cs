namespace Caterpillar.GH.Components.Path;

/// <summary>How the curved parts of a curve are divided.</summary>
public enum SubdivisionMode
{
    /// <summary>By distance along the curve.</summary>
    Distance,

    /// <summary>By the distance between curve and chord.</summary>
    Tolerance,

    /// <summary>By the turn along a segment.</summary>
    Angle,
}

/// <summary>Divides a curve as it will be printed.</summary>
public sealed class SubdivideCurveComponent() : CaterpillarComponent(
    "Subdivide Curve", "SubCrv",
        "Separates the linear and the curved parts of a curve. Linear parts keep only their end points, curved parts are divided.", Panel.Path)
{
    public override Guid ComponentGuid => new("a31cc893-fa2f-4120-a76b-5b2d09d19c7c");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new Param_Curve(), "Curve", "C", "Curve to divide.");
        ports.Choice("Mode", "M", "Division of curved parts: by distance, chord tolerance or angle.", SubdivisionMode.Distance);
        ports.Number("Distance", "D", "For Distance: maximum segment length on curved parts, in mm.", 1);
        ports.Number("Tolerance", "T", "For Tolerance: maximum distance between curve and segment, in mm.", 0.05);
        ports.Angle("Angle", "A", "For Angle: maximum turn of the curve along a segment, in degrees.", 5);
        ports.Number("Minimum Length", "Min", "Minimum segment length on curved parts, in mm. 0 = no limit.", 0);
        ports.Number("Maximum Length", "Max", "Maximum segment length on curved parts, in mm. 0 = no limit.", 0);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Point("Points", "Pt", "Points of the divided curve. A closed curve does not repeat its first point.", GH_ParamAccess.list);
        ports.Curve("Lines", "Li", "Linear parts, one line each.", GH_ParamAccess.list);
        ports.Curve("Curved Parts", "Cu", "Divided curved parts, one polyline each.", GH_ParamAccess.list);
    }

    private protected override void Solve(Run run)
    {
        var units = run.Units;
        var curve = RhinoCurves.ToCurve(run.Get<Rg.Curve>(0), units);
        var mode = run.Choice<SubdivisionMode>(1);
        var divided = CurveSubdivider.Subdivide(curve, new SubdivisionOptions
        {
            Distance = mode == SubdivisionMode.Distance ? run.Positive(2) : 0,
            ChordTolerance = mode == SubdivisionMode.Tolerance ? run.Positive(3) : 0,
            Angle = mode == SubdivisionMode.Angle ? run.Positive(4) : 0,
            MinLength = run.Finite(5),
            MaxLength = run.Finite(6),
        });
        run.SetList(0, divided.Points.Select(p => RhinoGeometry.ToPoint(p, units)));
        var (lines, curved) = Parts(divided, units);
        run.SetList(1, lines);
        run.SetList(2, curved);
        run.Summarize($"{NumberFormatter.Format(divided.SegmentCount)} segments");
    }

    private static (List<Rg.LineCurve> Lines, List<Rg.PolylineCurve> Curved) Parts(Subdivision divided, DocumentUnits units)
    {
        var lines = new List<Rg.LineCurve>();
        var curved = new List<Rg.PolylineCurve>();
        var points = new List<Rg.Point3d>();
        for (var i = 0; i < divided.SegmentCount; i++)
        {
            var start = RhinoGeometry.ToPoint(divided.Points[i], units);
            var end = RhinoGeometry.ToPoint(divided.EndOf(i), units);
            if (divided.IsLinear(i))
            {
                lines.Add(new Rg.LineCurve(start, end));
                Close();
                continue;
            }
            if (points.Count == 0) points.Add(start);
            points.Add(end);
        }
        Close();
        return (lines, curved);

        void Close()
        {
            if (points.Count > 1) curved.Add(new Rg.PolylineCurve(points));
            points.Clear();
        }
    }
}
