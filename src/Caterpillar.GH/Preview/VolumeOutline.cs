namespace Caterpillar.GH.Preview;

/// <summary>Bed and build volume of a printer as lines, in document units.</summary>
internal static class VolumeOutline
{
    private const int Corners = 48;

    public static Rg.Line[] Of(Printer printer, DocumentUnits units)
    {
        var box = printer.BuildBounds;
        var foot = new List<Vec3>();
        if (printer.BedShape == BedShape.Round)
        {
            for (var i = 0; i < Corners; i++)
            {
                var (sin, cos) = Angle.SinCos(360.0 * i / Corners);
                foot.Add(box.Center.WithZ(box.Min.Z) + new Vec3(cos * box.Size.X / 2, sin * box.Size.Y / 2));
            }
        }
        else
        {
            foot.AddRange([box.Min, new Vec3(box.Max.X, box.Min.Y, box.Min.Z), box.Max.WithZ(box.Min.Z), new Vec3(box.Min.X, box.Max.Y, box.Min.Z)]);
        }
        var lines = new List<Rg.Line>();
        void Add(Vec3 a, Vec3 b) => lines.Add(new Rg.Line(RhinoGeometry.ToPoint(a, units), RhinoGeometry.ToPoint(b, units)));
        for (var i = 0; i < foot.Count; i++)
        {
            var (a, b) = (foot[i], foot[(i + 1) % foot.Count]);
            Add(a, b);
            Add(a.WithZ(box.Max.Z), b.WithZ(box.Max.Z));
            if (i % (foot.Count / 4) == 0) Add(a, a.WithZ(box.Max.Z));
        }
        return lines.ToArray();
    }
}
