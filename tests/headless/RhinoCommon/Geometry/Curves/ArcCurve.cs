using System;

namespace Rhino.Geometry
{
    public struct Circle
    {
        public Circle(Plane plane, double radius)
        {
            Plane = plane;
            Radius = radius;
        }

        public Circle(Point3d center, double radius) : this(new Plane(center, Vector3d.XAxis, Vector3d.YAxis), radius)
        {
        }

        public Plane Plane { get; set; }

        public double Radius { get; set; }

        public Point3d Center => Plane.Origin;

        public bool IsValid => Radius > 0 && Plane.IsValid;

        public Point3d PointAt(double t) => Plane.PointAt(Math.Cos(t) * Radius, Math.Sin(t) * Radius);
    }

    public struct Arc
    {
        public Arc(Plane plane, double radius, double angleRadians) : this(new Circle(plane, radius), new Interval(0, angleRadians))
        {
        }

        public Arc(Circle circle, Interval angleIntervalRadians)
        {
            Plane = circle.Plane;
            Radius = circle.Radius;
            AngleDomain = angleIntervalRadians;
        }

        public Plane Plane { get; set; }

        public double Radius { get; set; }

        public Interval AngleDomain { get; set; }

        public Point3d Center => Plane.Origin;

        public double Angle => AngleDomain.Length;

        public double AngleDegrees => RhinoMath.ToDegrees(Angle);

        public double StartAngle => AngleDomain.T0;

        public double EndAngle => AngleDomain.T1;

        public double Length => Math.Abs(Angle * Radius);

        public bool IsValid => Radius > 0 && Plane.IsValid && Angle > 0;

        public Point3d StartPoint => PointAt(StartAngle);

        public Point3d EndPoint => PointAt(EndAngle);

        public Point3d PointAt(double t) => Plane.PointAt(Math.Cos(t) * Radius, Math.Sin(t) * Radius);
    }

    public class ArcCurve : Curve
    {
        private Arc _arc;

        public ArcCurve(Arc arc)
        {
            _arc = arc;
            Range = new Interval(0, arc.Length);
        }

        public ArcCurve(Circle circle) : this(new Arc(circle, new Interval(0, RhinoMath.TwoPI)))
        {
        }

        public Arc Arc => _arc;

        public double Radius => _arc.Radius;

        public double AngleRadians => _arc.Angle;

        internal override bool CheckValid() => _arc.IsValid;

        internal override int DegreeOf() => 2;

        internal override GeometryBase CopyOf() => new ArcCurve(_arc) { Range = Range };

        internal override void Map(Transform xform)
        {
            var scale = (xform * _arc.Plane.XAxis).Length;
            if (Math.Abs((xform * _arc.Plane.YAxis).Length - scale) > 1e-9 * scale) throw NeedsRhino("Stretching an arc into an ellipse");
            var plane = _arc.Plane;
            plane.Transform(xform);
            _arc = new Arc(new Circle(plane, _arc.Radius * scale), _arc.AngleDomain);
        }

        internal override Point3d At(double t) => _arc.PointAt(_arc.AngleDomain.ParameterAt((t - Domain.T0) / Domain.Length));

        internal override double Length() => _arc.Length;

        internal override bool IsArcExactly(out Arc arc)
        {
            arc = _arc;
            return true;
        }

        internal override void Flip()
        {
            var plane = new Plane(_arc.Center, _arc.Plane.XAxis, -_arc.Plane.YAxis);
            _arc = new Arc(new Circle(plane, _arc.Radius), new Interval(-_arc.EndAngle, -_arc.StartAngle));
        }

        // Rational quadratic spans of at most a right angle.
        internal override NurbsCurve Nurbs()
        {
            var spans = Math.Max(1, (int)Math.Ceiling(_arc.Angle / RhinoMath.HalfPI - 1e-9));
            var nurbs = new NurbsCurve(3, true, 3, 2 * spans + 1);
            var step = _arc.Angle / spans;
            var weight = Math.Cos(step / 2);
            for (var i = 0; i <= spans; i++)
            {
                nurbs.Points.SetPoint(2 * i, _arc.PointAt(_arc.StartAngle + i * step), 1);
                var t = Domain.ParameterAt((double)i / spans);
                nurbs.Knots[2 * i] = t;
                nurbs.Knots[2 * i + 1] = t;
                if (i == spans) break;
                var middle = _arc.StartAngle + (i + 0.5) * step;
                var corner = _arc.Plane.PointAt(Math.Cos(middle) * _arc.Radius / weight, Math.Sin(middle) * _arc.Radius / weight);
                nurbs.Points.SetPoint(2 * i + 1, corner, weight);
            }
            return nurbs;
        }
    }
}
