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
    private readonly Rg.Mesh _mesh;

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
        _mesh = RhinoMesh.FromTriangles(HeadMesh.Of(printer), units);

        Rg.Point3d At(HeadPoint ring, int corner)
        {
            var (sin, cos) = Angle.SinCos(360.0 * (corner % Corners) / Corners);
            return new Rg.Point3d(ring.Radius * cos * s, ring.Radius * sin * s, ring.Height * s);
        }
    }

    /// <summary>The head with the nozzle at the origin of a frame, and a triangle with its sharp corner forward. The array is used again.</summary>
    public Rg.Line[] At(Frame pose)
    {
        var tip = RhinoGeometry.ToPoint(pose.Origin, _units);
        var triangle = Turtle.TriangleOf(pose, TurtleSize);
        for (var i = 0; i < 3; i++)
            _moved[_lines.Length + i] = new Rg.Line(RhinoGeometry.ToPoint(triangle[i], _units), RhinoGeometry.ToPoint(triangle[(i + 1) % 3], _units));
        var by = new Rg.Vector3d(tip.X, tip.Y, tip.Z);
        for (var i = 0; i < _lines.Length; i++) _moved[i] = new Rg.Line(_lines[i].From + by, _lines[i].To + by);
        return _moved;
    }

    /// <summary>The profile of the head in the plane of X and Z, with the nozzle at a point. Null for a head without extent.</summary>
    public Rg.Curve? ProfileAt(Rg.Point3d tip)
    {
        var by = new Rg.Vector3d(tip.X, tip.Y, tip.Z);
        return PolylineMaker.Of(System.Array.ConvertAll(_profile, p => p + by));
    }

    /// <summary>Nozzle, head and boxes with the nozzle at a point. Null for a head without extent.</summary>
    public Rg.Mesh? MeshAt(Rg.Point3d tip)
    {
        if (_mesh.Faces.Count == 0) return null;
        var mesh = _mesh.DuplicateMesh();
        mesh.Translate(new Rg.Vector3d(tip.X, tip.Y, tip.Z));
        return mesh;
    }
}
