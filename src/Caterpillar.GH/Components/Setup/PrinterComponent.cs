namespace Caterpillar.GH.Components.Setup;

/// <summary>A printer from a profile, with its own bed, head and values.</summary>
public sealed class PrinterComponent() : KeyPortsComponent<Printer>(
    "Printer", "Printer", "Loads a printer from a profile or a file, and changes its bed, print head or other values. Zoom in and press + for more of them.",
    "generic")
{
    // mm; a bed that begins this close to the origin begins there.
    private const double OriginTolerance = 0.001;

    public override Guid ComponentGuid => new("7974af61-1fa1-4de7-9ff5-cbf83ddab480");

    private protected override IReadOnlyList<UsualKey> Usual =>
    [
        new("Nozzle Diameter", "N", "nozzle_diameter_mm"),
        new("Retraction Length", "R", "retraction_length_mm"),
        new("Retraction Speed", "Rs", "retraction_speed_mm_s"),
    ];

    private protected override void Inputs(InputPorts ports)
    {
        ports.Profile(new PrinterChoiceParam(), "Profile", "P", "Default: generic.");
        ports.Geometry("Bed", "B",
            "Box of the build volume, or rectangle of the bed. The origin must be its front left corner or its center. Default: as in the profile.",
            optional: true);
        ports.Geometry("Head Parts", "H", "Parts of the print head, with the nozzle tip at the origin. Their bounding boxes must not touch the print. Default: "
            + "as in the profile.", GH_ParamAccess.list, optional: true);
        UsualPorts(ports);
        ports.Text("Name", "Na", "Name of the printer. Default: the name of the profile.", optional: true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrinterParam(), "Printer", "P", "Printer, for Print Setup.");
        ports.Curve("Bed", "B", "Outline of the bed.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var units = run.Units;
        var printer = Profile(run);
        if (run.Maybe<string>(6) is { Length: > 0 } name) printer = printer with { Name = name, Title = name };
        if (run.Maybe<IGH_GeometricGoo>(1) is { } bed) printer = WithBed(printer, BoundsOf(bed, units));
        var head = run.List<IGH_GeometricGoo>(2);
        if (head.Count > 0) printer = printer with { HeadBoxes = new ValueList<Bounds>(head.Select(h => BoundsOf(h, units))) };
        var made = With(run, new PrintSetup() with { Printer = printer }).Printer;
        run.SetAll(new PrinterGoo { Value = made }, RhinoGeometry.ToBed(made, units));
    }

    private static Printer WithBed(Printer printer, Bounds bed)
    {
        var volume = bed.Size.Z > 0 ? bed.Size : bed.Size.WithZ(printer.BuildVolume.Z);
        var corner = Math.Abs(bed.Min.X) <= OriginTolerance && Math.Abs(bed.Min.Y) <= OriginTolerance;
        var centered = Math.Abs(bed.Center.X) <= OriginTolerance && Math.Abs(bed.Center.Y) <= OriginTolerance;
        if (!corner && !centered) throw new InputProblem("The origin must be the front left corner of the bed or its center. Move the bed.");
        return printer with { BuildVolume = volume, Origin = corner ? BedOrigin.Corner : BedOrigin.Center, BedShape = BedShape.Rectangle };
    }

    private static Bounds BoundsOf(IGH_GeometricGoo goo, DocumentUnits units)
    {
        var box = goo.Boundingbox;
        if (!box.IsValid) throw new InputProblem("Bed or Head Parts is empty: connect geometry with a valid bounding box.");
        return RhinoGeometry.ToBounds(box, units);
    }
}
