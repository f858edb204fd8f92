using System;
using GH_IO.Serialization;
using GH_IO.Types;
using Rhino.Geometry;

namespace Grasshopper.Kernel.Types
{
    public class GH_Point : IGH_GeometricGoo
    {
        private Point3d _value;

        public GH_Point()
        {
        }

        public GH_Point(Point3d pt) => _value = pt;

        internal Point3d Value
        {
            get => _value;
            set => _value = value;
        }

        public bool IsValid => _value.IsValid;

        public string IsValidWhyNot => IsValid ? string.Empty : "The coordinates are not valid.";

        public string TypeName => "Point";

        public string TypeDescription => "A 3D point";

        public BoundingBox Boundingbox => new BoundingBox(_value, _value);

        public Guid ReferenceID { get; set; }

        public bool IsReferencedGeometry => false;

        public IGH_Goo Duplicate() => new GH_Point(_value);

        public IGH_GeometricGoo DuplicateGeometry() => new GH_Point(_value);

        public BoundingBox GetBoundingBox(Transform xform) => new BoundingBox(xform * _value, xform * _value);

        public IGH_GeometricGoo Transform(Transform xform) => new GH_Point(xform * _value);

        public IGH_GeometricGoo Morph(SpaceMorph xmorph) => new GH_Point(xmorph.MorphPoint(_value));

        public object ScriptVariable() => _value;

        public override string ToString() => "{" + _value + "}";

        public bool CastFrom(object source)
        {
            if (Casting.Bare(source) is Point3d point) _value = point;
            else if (Casting.Bare(source) is Vector3d vector) _value = new Point3d(vector);
            else if (Casting.Bare(source) is Plane plane) _value = plane.Origin;
            else return false;
            return true;
        }

        public bool CastTo<Q>(out Q target)
        {
            target = default;
            return Casting.Give(_value, ref target);
        }

        public bool Write(GH_IWriter writer)
        {
            writer.SetPoint3D("Coordinate", new GH_Point3D(_value.X, _value.Y, _value.Z));
            return true;
        }

        public bool Read(GH_IReader reader)
        {
            var p = reader.GetPoint3D("Coordinate");
            _value = new Point3d(p.x, p.y, p.z);
            return true;
        }
    }

    public class GH_Transform : GH_Goo<Transform>
    {
        public GH_Transform()
        {
        }

        internal GH_Transform(Transform transform) : base(transform)
        {
        }

        public override bool IsValid => m_value.M33 != 0;

        public override string TypeName => "Transform";

        public override string TypeDescription => "A three-dimensional transformation";

        public override IGH_Goo Duplicate() => new GH_Transform(m_value);

        public override string ToString() => m_value.ToString();

        public override bool CastFrom(object source)
        {
            if (Casting.Bare(source) is not Transform transform) return false;
            m_value = transform;
            return true;
        }

        public override bool CastTo<Q>(ref Q target) => Casting.Give(m_value, ref target);
    }

    public class GH_Plane : GH_GeometricGoo<Plane>
    {
        public GH_Plane()
        {
        }

        public GH_Plane(Plane plane) : base(plane)
        {
        }

        public override bool IsValid => m_value.IsValid;

        public override string TypeName => "Plane";

        public override string TypeDescription => "A plane";

        public override BoundingBox Boundingbox => new BoundingBox(m_value.Origin, m_value.Origin);

        public override IGH_GeometricGoo DuplicateGeometry() => new GH_Plane(m_value);

        public override BoundingBox GetBoundingBox(Transform xform) => new BoundingBox(xform * m_value.Origin, xform * m_value.Origin);

        public override IGH_GeometricGoo Transform(Transform xform)
        {
            var plane = m_value;
            plane.Transform(xform);
            return new GH_Plane(plane);
        }

        public override IGH_GeometricGoo Morph(SpaceMorph xmorph) => null;

        public override string ToString() => m_value.ToString();

        public override bool CastFrom(object source)
        {
            if (Casting.Bare(source) is Plane plane) m_value = plane;
            else if (Casting.Bare(source) is Point3d point) m_value = new Plane(point, Vector3d.XAxis, Vector3d.YAxis);
            else return false;
            return true;
        }

        public override bool CastTo<Q>(ref Q target) => Casting.Give(m_value, ref target);

        public override bool Write(GH_IWriter writer)
        {
            GH_Point3D P(Point3d p) => new GH_Point3D(p.X, p.Y, p.Z);
            writer.SetPlane("plane", new GH_IO.Types.GH_Plane
            {
                Origin = P(m_value.Origin), XAxis = P(new Point3d(m_value.XAxis)), YAxis = P(new Point3d(m_value.YAxis)),
            });
            return true;
        }

        public override bool Read(GH_IReader reader)
        {
            var p = reader.GetPlane("plane");
            m_value = new Plane(new Point3d(p.Origin.x, p.Origin.y, p.Origin.z), new Vector3d(p.XAxis.x, p.XAxis.y, p.XAxis.z),
                new Vector3d(p.YAxis.x, p.YAxis.y, p.YAxis.z));
            return true;
        }
    }

    public class GH_Curve : GH_GeometricGoo<Curve>, IGH_PreviewData
    {
        public GH_Curve()
        {
        }

        public GH_Curve(Curve curve) : base(curve)
        {
        }

        // What a file holds is written as it was.
        internal byte[] Bytes { get; set; }

        public override bool IsValid => m_value != null && m_value.IsValid;

        public override string TypeName => "Curve";

        public override string TypeDescription => "A curve";

        public override BoundingBox Boundingbox => m_value == null ? BoundingBox.Empty : m_value.GetBoundingBox(true);

        public BoundingBox ClippingBox => Boundingbox;

        public override IGH_GeometricGoo DuplicateGeometry() => new GH_Curve(m_value?.DuplicateCurve());

        public override BoundingBox GetBoundingBox(Transform xform) => m_value == null ? BoundingBox.Empty : m_value.GetBoundingBox(xform);

        public override IGH_GeometricGoo Transform(Transform xform)
        {
            m_value?.Transform(xform);
            return this;
        }

        public override IGH_GeometricGoo Morph(SpaceMorph xmorph) => throw new NotSupportedException("Morphing a curve needs Rhino.");

        public override string ToString() => m_value == null ? "Null Curve" : m_value.IsPolyline() ? "Polyline Curve" : "Curve";

        public override bool CastFrom(object source)
        {
            switch (Casting.Bare(source))
            {
                case Curve curve: m_value = curve.DuplicateCurve(); return true;
                case Line line: m_value = new LineCurve(line); return true;
                case Polyline polyline: m_value = polyline.ToPolylineCurve(); return true;
                case Circle circle: m_value = new ArcCurve(circle); return true;
                case Arc arc: m_value = new ArcCurve(arc); return true;
                default: return false;
            }
        }

        public override bool CastTo<Q>(ref Q target) => Casting.Give(m_value, ref target);

        public override bool Write(GH_IWriter writer)
        {
            if (Bytes == null) return true;
            writer.SetInt32("EdgeIndex", -1);
            writer.SetByteArray("ON_Data", Bytes);
            writer.SetGuid("RefID", Guid.Empty);
            return true;
        }

        public override bool Read(GH_IReader reader)
        {
            if (!reader.ItemExists("ON_Data")) return true;
            Bytes = reader.GetByteArray("ON_Data");
            m_value = (Curve)Stored.Read(Bytes);
            return true;
        }

        public void DrawViewportWires(GH_PreviewWireArgs args) => args.Pipeline.DrawCurve(m_value, args.Color, args.Thickness);

        public void DrawViewportMeshes(GH_PreviewMeshArgs args)
        {
        }
    }

    public class GH_Mesh : GH_GeometricGoo<Mesh>
    {
        public GH_Mesh()
        {
        }

        internal GH_Mesh(Mesh mesh) : base(mesh)
        {
        }

        // What a file holds is written as it was.
        internal byte[] Bytes { get; set; }

        public override bool IsValid => m_value != null && m_value.IsValid;

        public override string TypeName => "Mesh";

        public override string TypeDescription => "A mesh";

        public override BoundingBox Boundingbox => m_value == null ? BoundingBox.Empty : m_value.GetBoundingBox(true);

        public override IGH_GeometricGoo DuplicateGeometry() => new GH_Mesh(m_value?.DuplicateMesh());

        public override BoundingBox GetBoundingBox(Transform xform) => m_value == null ? BoundingBox.Empty : m_value.GetBoundingBox(xform);

        public override IGH_GeometricGoo Transform(Transform xform)
        {
            m_value?.Transform(xform);
            return this;
        }

        public override IGH_GeometricGoo Morph(SpaceMorph xmorph) => throw new NotSupportedException("Morphing a mesh needs Rhino.");

        public override string ToString() => m_value == null ? "Null Mesh" : "Mesh (V:" + m_value.Vertices.Count + " F:" + m_value.Faces.Count + ")";

        public override bool CastFrom(object source)
        {
            if (!(Casting.Bare(source) is Mesh mesh)) return false;
            m_value = mesh.DuplicateMesh();
            return true;
        }

        public override bool CastTo<Q>(ref Q target) => Casting.Give(m_value, ref target);

        public override bool Write(GH_IWriter writer)
        {
            if (Bytes == null) return true;
            writer.SetByteArray("ON_Data", Bytes);
            writer.SetGuid("RefID", Guid.Empty);
            return true;
        }

        public override bool Read(GH_IReader reader)
        {
            if (!reader.ItemExists("ON_Data")) return true;
            Bytes = reader.GetByteArray("ON_Data");
            m_value = (Mesh)Stored.Read(Bytes);
            return true;
        }
    }

    public class GH_Brep : GH_GeometricGoo<Brep>
    {
        public GH_Brep()
        {
        }

        internal GH_Brep(Brep brep) : base(brep)
        {
        }

        // What a file holds is written as it was.
        internal byte[] Bytes { get; set; }

        public override bool IsValid => m_value != null && m_value.IsValid;

        public override string TypeName => "Brep";

        public override string TypeDescription => "A boundary representation";

        public override BoundingBox Boundingbox => m_value == null ? BoundingBox.Empty : m_value.GetBoundingBox(true);

        public override IGH_GeometricGoo DuplicateGeometry() => new GH_Brep(m_value?.DuplicateBrep());

        public override BoundingBox GetBoundingBox(Transform xform) => m_value == null ? BoundingBox.Empty : m_value.GetBoundingBox(xform);

        public override IGH_GeometricGoo Transform(Transform xform)
        {
            m_value?.Transform(xform);
            return this;
        }

        public override IGH_GeometricGoo Morph(SpaceMorph xmorph) => throw new NotSupportedException("Morphing a Brep needs Rhino.");

        public override string ToString() => "Brep";

        public override bool CastFrom(object source)
        {
            if (!(Casting.Bare(source) is Brep brep)) return false;
            m_value = brep.DuplicateBrep();
            return true;
        }

        public override bool CastTo<Q>(ref Q target) => Casting.Give(m_value, ref target);

        public override bool Write(GH_IWriter writer)
        {
            if (Bytes == null) return true;
            writer.SetByteArray("ON_Data", Bytes);
            writer.SetGuid("RefID", Guid.Empty);
            return true;
        }

        public override bool Read(GH_IReader reader)
        {
            if (!reader.ItemExists("ON_Data")) return true;
            Bytes = reader.GetByteArray("ON_Data");
            m_value = (Brep)Stored.Read(Bytes);
            return true;
        }
    }

    public class GH_Box : GH_GeometricGoo<Box>
    {
        public GH_Box()
        {
        }

        internal GH_Box(Box box) : base(box)
        {
        }

        public override bool IsValid => m_value.IsValid;

        public override string TypeName => "Box";

        public override string TypeDescription => "A box";

        public override BoundingBox Boundingbox => m_value.BoundingBox;

        public override IGH_GeometricGoo DuplicateGeometry() => new GH_Box(m_value);

        public override BoundingBox GetBoundingBox(Transform xform) => new BoundingBox(System.Array.ConvertAll(m_value.GetCorners(), p => xform * p));

        public override IGH_GeometricGoo Transform(Transform xform)
        {
            var plane = m_value.Plane;
            plane.Transform(xform);
            return new GH_Box(new Box(plane, m_value.X, m_value.Y, m_value.Z));
        }

        public override IGH_GeometricGoo Morph(SpaceMorph xmorph) => throw new NotSupportedException("Morphing a box needs Rhino.");

        public override string ToString() => "Box";

        public override bool CastFrom(object source)
        {
            if (!(Casting.Bare(source) is Box box)) return false;
            m_value = box;
            return true;
        }

        public override bool CastTo<Q>(ref Q target) => Casting.Give(m_value, ref target);
    }

    /// <summary>Surfaces, extrusions and SubDs, which have goo of their own in Grasshopper.</summary>
    internal sealed class AnyGeometry : GH_GeometricGoo<GeometryBase>
    {
        public AnyGeometry()
        {
        }

        public AnyGeometry(GeometryBase geometry) : base(geometry)
        {
        }

        public override string TypeName => m_value.GetType().Name;

        public override string TypeDescription => "Geometry";

        public override BoundingBox Boundingbox => m_value.GetBoundingBox(true);

        public override IGH_GeometricGoo DuplicateGeometry() => new AnyGeometry(m_value.Duplicate());

        public override BoundingBox GetBoundingBox(Transform xform) => m_value.GetBoundingBox(xform);

        public override IGH_GeometricGoo Transform(Transform xform)
        {
            m_value.Transform(xform);
            return this;
        }

        public override IGH_GeometricGoo Morph(SpaceMorph xmorph) => throw new NotSupportedException("Morphing needs Rhino.");

        public override string ToString() => TypeName;

        public override bool CastTo<Q>(ref Q target) => Casting.Give(m_value, ref target);
    }
}
