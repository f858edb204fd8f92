using Rhino.Geometry;

namespace Grasshopper.Kernel.Types
{
    public class GH_Line : GH_GeometricGoo<Line>
    {
        public GH_Line()
        {
        }

        public GH_Line(Line line) : base(line)
        {
        }

        public override bool IsValid => m_value.Length > 0;

        public override string TypeName => "Line";

        public override string TypeDescription => "A line segment";

        public override BoundingBox Boundingbox => m_value.BoundingBox;

        public override IGH_GeometricGoo DuplicateGeometry() => new GH_Line(m_value);

        public override BoundingBox GetBoundingBox(Transform xform) => ((GH_Line)Transform(xform)).Boundingbox;

        public override IGH_GeometricGoo Transform(Transform xform) => new GH_Line(new Line(xform * m_value.From, xform * m_value.To));

        public override IGH_GeometricGoo Morph(SpaceMorph xmorph) => null;

        public override string ToString() => "Line (" + m_value.From + " to " + m_value.To + ")";

        public override bool CastFrom(object source)
        {
            if (!(Casting.Bare(source) is Line line)) return false;
            m_value = line;
            return true;
        }

        public override bool CastTo<Q>(ref Q target) => Casting.Give(m_value, ref target);
    }

    public class GH_Arc : GH_GeometricGoo<Arc>
    {
        public GH_Arc()
        {
        }

        public GH_Arc(Arc arc) : base(arc)
        {
        }

        public override bool IsValid => m_value.IsValid;

        public override string TypeName => "Arc";

        public override string TypeDescription => "A circular arc";

        public override BoundingBox Boundingbox => new ArcCurve(m_value).GetBoundingBox(true);

        public override IGH_GeometricGoo DuplicateGeometry() => new GH_Arc(m_value);

        public override BoundingBox GetBoundingBox(Transform xform) => new ArcCurve(m_value).GetBoundingBox(xform);

        public override IGH_GeometricGoo Transform(Transform xform)
        {
            var curve = new ArcCurve(m_value);
            return curve.Transform(xform) ? new GH_Arc(curve.Arc) : null;
        }

        public override IGH_GeometricGoo Morph(SpaceMorph xmorph) => null;

        public override string ToString() => "Arc";

        public override bool CastFrom(object source)
        {
            if (!(Casting.Bare(source) is Arc arc)) return false;
            m_value = arc;
            return true;
        }

        public override bool CastTo<Q>(ref Q target) => Casting.Give(m_value, ref target);
    }

    public class GH_Circle : GH_GeometricGoo<Circle>
    {
        public GH_Circle()
        {
        }

        public GH_Circle(Circle circle) : base(circle)
        {
        }

        public override bool IsValid => m_value.IsValid;

        public override string TypeName => "Circle";

        public override string TypeDescription => "A circle";

        public override BoundingBox Boundingbox => new ArcCurve(m_value).GetBoundingBox(true);

        public override IGH_GeometricGoo DuplicateGeometry() => new GH_Circle(m_value);

        public override BoundingBox GetBoundingBox(Transform xform) => new ArcCurve(m_value).GetBoundingBox(xform);

        public override IGH_GeometricGoo Transform(Transform xform)
        {
            var curve = new ArcCurve(m_value);
            return curve.Transform(xform) ? new GH_Circle(new Circle(curve.Arc.Plane, curve.Radius)) : null;
        }

        public override IGH_GeometricGoo Morph(SpaceMorph xmorph) => null;

        public override string ToString() => "Circle";

        public override bool CastFrom(object source)
        {
            if (!(Casting.Bare(source) is Circle circle)) return false;
            m_value = circle;
            return true;
        }

        public override bool CastTo<Q>(ref Q target) => Casting.Give(m_value, ref target);
    }
}
