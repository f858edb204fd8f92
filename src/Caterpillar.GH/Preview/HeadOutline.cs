namespace Caterpillar.GH.Preview;

/// <summary>The print head as rings and edges, its profile and mesh, and a turtle that points in the direction of motion.</summary>
internal sealed class HeadOutline
{
    private const int Corners = 24;
    private const double TurtleSize = 2;
    private readonly DocumentUnits _units;
    private readonly Rg.Line[] _lines;
    private readonly Rg.Line[] _moved;
    private readonly Rg.Point3d[] _profile;
    private readonly TriMesh _mesh;

    public HeadOutline(Printer printer, DocumentUnits units)
    {
        _units = units;
        var s = units.FromMillimeters;
        var lines = new List<Rg.Line>();
        var profile = new List<Rg.Point3d> { Rg.Point3d.Origin };
        for (var i = 0; i < printer.HeadOutline.Count; i++)
        {
            var ring = printer.HeadOutline[i];
            profile.Add(new Rg.Point3d(ring.Radius * s, 0, ring.Height * s));
            for (var k = 0; k < Corners; k++)
            {
                lines.Add(new Rg.Line(At(ring, k), At(ring, k + 1)));
                if (i > 0 && k % (Corners / 4) == 0) lines.Add(new Rg.Line(At(printer.HeadOutline[i - 1], k), At(ring, k)));
            }
        }
        for (var i = printer.HeadOutline.Count - 1; i >= 0; i--)
            profile.Add(new Rg.Point3d(-printer.HeadOutline[i].Radius * s, 0, printer.HeadOutline[i].Height * s));
        profile.Add(Rg.Point3d.Origin);
        foreach (var box in printer.HeadBoxes)
        {
            var c = RhinoGeometry.ToBox(box, units).GetCorners();
            foreach (var (a, b) in new[] { (0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7) })
                lines.Add(new Rg.Line(c[a], c[b]));
        }
        _lines = lines.ToArray();
        _moved = new Rg.Line[_lines.Length + 3];
        _profile = profile.ToArray();
        _mesh = HeadMesh.Of(printer);

        Rg.Point3d At(HeadPoint ring, int corner)
        {
            var (sin, cos) = Angle.SinCos(360.0 * (corner % Corners) / Corners);
            return new Rg.Point3d(ring.Radius * cos * s, ring.Radius * sin * s, ring.Height * s);
        }
    }

    /// <summary>The head in its own frame, and in that of the motion a triangle with its sharp corner forward. The array is used again.</summary>
    public Rg.Line[] At(Frame head, Frame pose)
    {
        var triangle = Turtle.TriangleOf(pose, TurtleSize);
        for (var i = 0; i < 3; i++)
            _moved[_lines.Length + i] = new Rg.Line(RhinoGeometry.ToPoint(triangle[i], _units), RhinoGeometry.ToPoint(triangle[(i + 1) % 3], _units));
        for (var i = 0; i < _lines.Length; i++) _moved[i] = new Rg.Line(In(head, _lines[i].From), In(head, _lines[i].To));
        return _moved;
    }

    /// <summary>The profile of the head in the plane of X and Z, of its own frame. Null for a head without extent.</summary>
    public Rg.Curve? ProfileAt(Frame head) => PolylineMaker.Of(System.Array.ConvertAll(_profile, p => In(head, p)));

    /// <summary>Nozzle, head and boxes in the frame of the head. Null for a head without extent.</summary>
    public Rg.Mesh? MeshAt(Frame head)
        => _mesh.TriangleCount == 0 ? null : RhinoMesh.FromTriangles(_mesh.Transformed(Affine.FromFrame(head)), _units);

    // Points are in the units of the document.
    private Rg.Point3d In(Frame head, Rg.Point3d p)
    {
        var s = _units.ToMillimeters;
        return RhinoGeometry.ToPoint(head.ToWorld(new Vec3(p.X * s, p.Y * s, p.Z * s)), _units);
    }
}
