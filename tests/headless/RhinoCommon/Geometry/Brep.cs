using System.Collections.Generic;
using System.Linq;
using Rhino.DocObjects;

namespace Rhino.Geometry
{
    /// <summary>Here only a set of flat quadrilaterals, as a box has them.</summary>
    public class Brep : GeometryBase
    {
        private readonly List<Point3d[]> _quads = new List<Point3d[]>();

        internal Brep(params Point3d[][] quads) => _quads.AddRange(quads);

        public bool IsSolid => _quads.Count == 6;

        public static Brep CreateFromBox(BoundingBox box) => box.IsValid ? OfCorners(box.GetCorners()) : null;

        public static Brep CreateFromBox(Box box) => box.IsValid ? OfCorners(box.GetCorners()) : null;

        public override GeometryBase Duplicate() => CopyOf();

        public Brep DuplicateBrep() => (Brep)CopyOf();

        private static Brep OfCorners(Point3d[] c)
            => new Brep(new[] { "0321", "4567", "0154", "1265", "2376", "3047" }.Select(q => q.Select(i => c[i - '0']).ToArray()).ToArray());

        internal Mesh[] Meshes() => _quads.Select(q =>
        {
            var mesh = new Mesh();
            mesh.Vertices.AddVertices(q);
            mesh.Faces.AddFace(0, 1, 2, 3);
            return mesh;
        }).ToArray();

        internal override ObjectType KindOf() => ObjectType.Brep;

        internal override GeometryBase CopyOf()
        {
            var copy = new Brep();
            copy._quads.AddRange(_quads.Select(q => q.ToArray()));
            return copy;
        }

        internal override void Map(Transform xform)
        {
            foreach (var q in _quads)
            {
                for (var i = 0; i < q.Length; i++) q[i] = xform * q[i];
            }
        }

        internal override BoundingBox Box(Transform xform) => new BoundingBox(_quads.SelectMany(q => q).Select(p => xform * p));

        internal override IEnumerable<double> Numbers() => _quads.SelectMany(q => q).SelectMany(p => new[] { p.X, p.Y, p.Z });
    }

    /// <summary>Here any surface is a set of flat quadrilaterals.</summary>
    public abstract class Surface : GeometryBase
    {
        internal Brep Faces { get; set; } = new Brep();

        public Brep ToBrep() => Faces.DuplicateBrep();

        internal override ObjectType KindOf() => ObjectType.Surface;

        internal override void Map(Transform xform) => Faces.Transform(xform);

        internal override BoundingBox Box(Transform xform) => Faces.GetBoundingBox(xform);

        internal override IEnumerable<double> Numbers() => Faces.Numbers();
    }

    public class PlaneSurface : Surface
    {
        public PlaneSurface(Plane plane, Interval xExtents, Interval yExtents)
        {
            Point3d At(double x, double y) => plane.Origin + plane.XAxis * x + plane.YAxis * y;
            Faces = new Brep(new[] { At(xExtents.T0, yExtents.T0), At(xExtents.T1, yExtents.T0), At(xExtents.T1, yExtents.T1), At(xExtents.T0, yExtents.T1) });
        }

        private PlaneSurface()
        {
        }

        internal override GeometryBase CopyOf() => new PlaneSurface { Faces = Faces.DuplicateBrep() };
    }

    public class Extrusion : Surface
    {
        public static Extrusion CreateBoxExtrusion(Box box, bool cap = true) => new Extrusion { Faces = Brep.CreateFromBox(box) };

        public Brep ToBrep(bool splitKinkyFaces) => Faces.DuplicateBrep();

        internal override ObjectType KindOf() => ObjectType.Extrusion;

        internal override GeometryBase CopyOf() => new Extrusion { Faces = Faces.DuplicateBrep() };
    }

    /// <summary>Here meshed as its control mesh; Rhino makes the limit surface.</summary>
    public class SubD : GeometryBase
    {
        internal Mesh Control { get; private set; } = new Mesh();

        public static SubD CreateFromMesh(Mesh mesh) => new SubD { Control = mesh.DuplicateMesh() };

        internal override ObjectType KindOf() => ObjectType.SubD;

        internal override GeometryBase CopyOf() => new SubD { Control = Control.DuplicateMesh() };

        internal override void Map(Transform xform) => Control.Transform(xform);

        internal override BoundingBox Box(Transform xform) => Control.GetBoundingBox(xform);

        internal override IEnumerable<double> Numbers() => Control.Numbers();
    }

    public class MeshingParameters
    {
        public static MeshingParameters Default => new MeshingParameters();

        public double Tolerance { get; set; }

        public double MinimumEdgeLength { get; set; } = 0.0001;

        public double MaximumEdgeLength { get; set; }

        public double RefineAngle { get; set; }

        public bool RefineGrid { get; set; }

        public bool JaggedSeams { get; set; }

        public bool SimplePlanes { get; set; }
    }
}
