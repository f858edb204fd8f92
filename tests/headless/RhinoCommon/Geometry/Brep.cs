using System.Collections.Generic;
using System.Linq;
using Rhino.DocObjects;

namespace Rhino.Geometry
{
    /// <summary>Here only a set of flat quadrilaterals, as a box has them.</summary>
    public class Brep : GeometryBase
    {
        private readonly List<Point3d[]> _quads = new List<Point3d[]>();

        public bool IsSolid => _quads.Count == 6;

        public static Brep CreateFromBox(BoundingBox box)
        {
            if (!box.IsValid) return null;
            var c = box.GetCorners();
            var brep = new Brep();
            foreach (var q in new[] { "0321", "4567", "0154", "1265", "2376", "3047" }) brep._quads.Add(q.Select(i => c[i - '0']).ToArray());
            return brep;
        }

        public override GeometryBase Duplicate() => CopyOf();

        public Brep DuplicateBrep() => (Brep)CopyOf();

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

    public abstract class Surface : GeometryBase
    {
        public Brep ToBrep() => throw NeedsRhino("A Brep of a surface");
    }

    public class Extrusion : Surface
    {
        public Brep ToBrep(bool splitKinkyFaces) => throw NeedsRhino("A Brep of an extrusion");

        internal override ObjectType KindOf() => ObjectType.Extrusion;

        internal override GeometryBase CopyOf() => new Extrusion();

        internal override void Map(Transform xform)
        {
        }

        internal override BoundingBox Box(Transform xform) => BoundingBox.Empty;

        internal override IEnumerable<double> Numbers() => new double[0];
    }

    public class SubD : GeometryBase
    {
        internal override ObjectType KindOf() => ObjectType.SubD;

        internal override GeometryBase CopyOf() => new SubD();

        internal override void Map(Transform xform)
        {
        }

        internal override BoundingBox Box(Transform xform) => BoundingBox.Empty;

        internal override IEnumerable<double> Numbers() => new double[0];
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
