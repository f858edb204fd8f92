using System;
using Rhino.DocObjects;

namespace Rhino.Geometry
{
    public class Curve : GeometryBase
    {
        internal Curve()
        {
        }

        public Interval Domain
        {
            get => Range;
            set => Range = value;
        }

        public int Degree => DegreeOf();

        public int SpanCount => Spans().Length - 1;

        public bool IsClosed => PointAtStart.DistanceTo(PointAtEnd) <= 1e-9 * (1 + Length()) && SpanCount > 0 && Length() > 0;

        public Point3d PointAtStart => PointAt(Domain.T0);

        public Point3d PointAtEnd => PointAt(Domain.T1);

        public Vector3d TangentAtStart => TangentAt(Domain.T0);

        public Vector3d TangentAtEnd => TangentAt(Domain.T1);

        internal virtual Interval Range { get; set; }

        public override GeometryBase Duplicate() => CopyOf();

        public Curve DuplicateCurve() => (Curve)CopyOf();

        public Point3d PointAt(double t) => At(t);

        public Vector3d TangentAt(double t)
        {
            var h = Domain.Length * 1e-6;
            var a = Math.Max(Domain.T0, t - h);
            var b = Math.Min(Domain.T1, t + h);
            return (At(b) - At(a)).Unit();
        }

        public double GetLength() => Length();

        public NurbsCurve ToNurbsCurve() => Nurbs();

        public bool IsPolyline() => TryGetPolyline(out _);

        public bool TryGetPolyline(out Polyline polyline)
        {
            polyline = AsPolyline();
            return polyline != null;
        }

        public bool TryGetArc(out Arc arc) => IsArcExactly(out arc);

        public bool IsLinear() => AsPolyline() is Polyline p && p.Count == 2;

        public bool Reverse()
        {
            Flip();
            return true;
        }

        internal override ObjectType KindOf() => ObjectType.Curve;

        internal override BoundingBox Box(Transform xform)
        {
            var box = BoundingBox.Empty;
            var spans = Spans();
            for (var i = 0; i + 1 < spans.Length; i++)
            {
                var steps = DegreeOf() == 1 ? 1 : 64;
                for (var k = 0; k <= steps; k++) box.Union(xform * At(spans[i] + (spans[i + 1] - spans[i]) * k / steps));
            }
            return box;
        }

        internal override GeometryBase CopyOf() => throw new NotSupportedException();

        internal override void Map(Transform xform) => throw new NotSupportedException();

        internal override System.Collections.Generic.IEnumerable<double> Numbers()
        {
            var nurbs = Nurbs();
            for (var i = 0; i < nurbs.Points.Count; i++)
            {
                var p = nurbs.Points[i];
                yield return p.Location.X;
                yield return p.Location.Y;
                yield return p.Location.Z;
                yield return p.Weight;
            }
            for (var i = 0; i < nurbs.Knots.Count; i++) yield return nurbs.Knots[i];
        }

        internal virtual Point3d At(double t) => throw new NotSupportedException();

        internal virtual NurbsCurve Nurbs() => throw new NotSupportedException();

        internal virtual int DegreeOf() => 1;

        internal virtual double[] Spans() => new[] { Domain.T0, Domain.T1 };

        internal virtual Polyline AsPolyline() => null;

        internal virtual bool IsArcExactly(out Arc arc)
        {
            arc = default;
            return false;
        }

        internal virtual void Flip() => throw new NotSupportedException();

        // Sums of chords, halved until they agree: curves here are short and tests are patient.
        internal virtual double Length()
        {
            var spans = Spans();
            var sum = 0.0;
            for (var i = 0; i + 1 < spans.Length; i++) sum += SpanLength(spans[i], spans[i + 1]);
            return sum;
        }

        private double SpanLength(double a, double b)
        {
            if (DegreeOf() == 1) return At(a).DistanceTo(At(b));
            const int steps = 256;
            double coarse = 0, fine = 0;
            for (var k = 0; k < steps; k++)
            {
                var t0 = a + (b - a) * k / steps;
                var t1 = a + (b - a) * (k + 1) / steps;
                var middle = At((t0 + t1) / 2);
                coarse += At(t0).DistanceTo(At(t1));
                fine += At(t0).DistanceTo(middle) + middle.DistanceTo(At(t1));
            }
            return fine + (fine - coarse) / 3;
        }
    }
}
