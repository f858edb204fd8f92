using Caterpillar.Geometry;
using Caterpillar.GH.Base;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.Machines;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Components.Setup;

/// <summary>Makes a printer from its bed, its head and its limits.</summary>
public sealed class ConstructPrinterComponent() : ProfileComponent(
    "Construct Printer", "CPrinter", "Creates a printer from another one, with its own bed, nozzle, print head, limits and G-code.")
{
    // mm; a bed that begins this close to the origin begins there.
    private const double OriginTolerance = 0.001;

    public override Guid ComponentGuid => new("7e0d3f58-1a6b-4c92-b3e5-2d8c4a9f6b08");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Printer("B", "Default: generic.", "Base");
        ports.Geometry("Bed", "Be",
            "Box of the build volume, or rectangle of the bed. The origin must be its front left corner or its center. Default: as in Base.", optional: true);
        ports.OptionalNumber("Nozzle", "N", "Nozzle diameter, in mm. Default: as in Base.");
        ports.Geometry("Head Parts", "H", "Parts of the print head, with the nozzle tip at the origin. Their bounding boxes must not touch the print. Default: "
            + "as in Base.", GH_ParamAccess.list, optional: true);
        ports.Overrides("max_flow_mm3_s=20");
        ports.Text("Start G-code", "SC",
            "Start G-code, with placeholders such as {nozzle_temperature_c}. Default: as in Base.", access: GH_ParamAccess.item, optional: true);
        ports.Text("End G-code", "EC", "End G-code, with placeholders such as {nozzle_temperature_c}. Default: as in Base.", optional: true);
        ports.Text("Name", "Na", "Name of the printer.", "custom");
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrinterParam(), "Printer", "P", "Printer.");
        ports.Curve("Bed", "B", "Outline of the bed.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var units = run.Units;
        var printer = (run.Maybe<Printer>(0) ?? new Printer()) with { Name = run.Get<string>(7), Title = run.Get<string>(7) };
        if (run.Maybe<IGH_GeometricGoo>(1) is { } bed) printer = WithBed(printer, BoundsOf(bed, units));
        if (run.MaybeValue<double>(2) is not null) printer = printer with { NozzleDiameter = run.Positive(2) };
        var head = run.List<IGH_GeometricGoo>(3);
        if (head.Count > 0) printer = printer with { HeadBoxes = new ValueList<Bounds>(head.Select(h => BoundsOf(h, units))) };
        if (run.Maybe<string>(5) is { } start) printer = printer with { StartGCode = new ValueList<string>(TextLines.Of(start)) };
        if (run.Maybe<string>(6) is { } end) printer = printer with { EndGCode = new ValueList<string>(TextLines.Of(end)) };
        var made = run.Require((new PrintSetup() with { Printer = printer }).With(run.List<string>(4))).Printer;
        run.SetAll(new PrinterGoo(made), RhinoGeometry.ToBed(made, units));
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
