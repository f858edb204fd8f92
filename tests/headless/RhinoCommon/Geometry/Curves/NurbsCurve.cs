using System;
using System.Collections.Generic;
using System.Linq;
using Rhino.Geometry.Collections;

namespace Rhino.Geometry
{
    /// <summary>The knot vector has two knots fewer than textbooks give it, as in Rhino: one at each end is implied.</summary>
    public class NurbsCurve : Curve
    {
        public NurbsCurve(int degree, int pointCount) : this(3, false, degree + 1, pointCount)
        {
        }

        public NurbsCurve(int dimension, bool rational, int order, int pointCount)
        {
            if (dimension != 3) throw new NotSupportedException();
            IsRational = rational;
            Order = order;
            Points = new NurbsCurvePointList(pointCount);
            Knots = new NurbsCurveKnotList(order + pointCount - 2);
        }

        public int Order { get; }

        public bool IsRational { get; internal set; }

        public NurbsCurvePointList Points { get; }

        public NurbsCurveKnotList Knots { get; }

        internal override Interval Range
        {
            get => new Interval(Knots[Order - 2], Knots[Points.Count - 1]);
            set
            {
                var from = Domain;
                for (var i = 0; i < Knots.Count; i++) Knots[i] = value.T0 + (Knots[i] - from.T0) / from.Length * value.Length;
            }
        }

        public static NurbsCurve Create(bool periodic, int degree, IEnumerable<Point3d> points)
        {
            if (periodic) throw NeedsRhino("A periodic curve from points");
            var all = points.ToArray();
            if (all.Length < 2) return null;
            degree = Math.Min(degree, all.Length - 1);
            var nurbs = new NurbsCurve(degree, all.Length);
            for (var i = 0; i < all.Length; i++) nurbs.Points.SetPoint(i, all[i]);
            for (var i = 0; i < nurbs.Knots.Count; i++) nurbs.Knots[i] = Math.Max(0, Math.Min(i - degree + 1, all.Length - degree));
            return nurbs;
        }

        internal override bool CheckValid()
        {
            for (var i = 1; i < Knots.Count; i++)
            {
                if (Knots[i] < Knots[i - 1]) return false;
            }
            return Points.Count >= Order && Domain.Length > 0;
        }

        internal override int DegreeOf() => Order - 1;

        internal override GeometryBase CopyOf()
        {
            var copy = new NurbsCurve(3, IsRational, Order, Points.Count);
            for (var i = 0; i < Points.Count; i++) copy.Points[i] = Points[i];
            for (var i = 0; i < Knots.Count; i++) copy.Knots[i] = Knots[i];
            return copy;
        }

        internal override void Map(Transform xform)
        {
            for (var i = 0; i < Points.Count; i++) Points[i] = new ControlPoint(xform * Points[i].Location, Points[i].Weight);
        }

        internal override NurbsCurve Nurbs() => (NurbsCurve)CopyOf();

        internal override Polyline AsPolyline() => Order == 2 ? new Polyline(Enumerable.Range(0, Points.Count).Select(i => Points[i].Location)) : null;

        internal override double[] Spans()
            => Enumerable.Range(Order - 2, Points.Count - Order + 2).Select(i => Knots[i]).Distinct().ToArray();

        internal override void Flip()
        {
            var points = Enumerable.Range(0, Points.Count).Select(i => Points[i]).Reverse().ToArray();
            var knots = Enumerable.Range(0, Knots.Count).Select(i => -Knots[i]).Reverse().ToArray();
            for (var i = 0; i < points.Length; i++) Points[i] = points[i];
            for (var i = 0; i < knots.Length; i++) Knots[i] = knots[i];
        }

        // De Boor on homogeneous points. Knot i of the textbook vector is knot i - 1 here.
        internal override Point3d At(double t)
        {
            var degree = Order - 1;
            t = Math.Max(Domain.T0, Math.Min(Domain.T1, t));
            var span = degree;
            while (span < Points.Count - 1 && Knots[span] <= t) span++;
            var d = new double[Order][];
            for (var j = 0; j <= degree; j++)
            {
                var p = Points[span - degree + j];
                d[j] = new[] { p.Location.X * p.Weight, p.Location.Y * p.Weight, p.Location.Z * p.Weight, p.Weight };
            }
            for (var r = 1; r <= degree; r++)
            {
                for (var j = degree; j >= r; j--)
                {
                    double low = Knots[span - degree + j - 1], high = Knots[span + j - r];
                    var a = high > low ? (t - low) / (high - low) : 0;
                    for (var k = 0; k < 4; k++) d[j][k] = (1 - a) * d[j - 1][k] + a * d[j][k];
                }
            }
            var end = d[degree];
            return new Point3d(end[0] / end[3], end[1] / end[3], end[2] / end[3]);
        }
    }
}

namespace Rhino.Geometry.Collections
{
    public sealed class NurbsCurveKnotList
    {
        private readonly double[] _knots;

        internal NurbsCurveKnotList(int count) => _knots = new double[count];

        public int Count => _knots.Length;

        public double this[int index]
        {
            get => _knots[index];
            set => _knots[index] = value;
        }
    }

    public class NurbsCurvePointList
    {
        private readonly ControlPoint[] _points;

        internal NurbsCurvePointList(int count)
        {
            _points = new ControlPoint[count];
            for (var i = 0; i < count; i++) _points[i] = new ControlPoint(Point3d.Origin, 1);
        }

        public int Count => _points.Length;

        public ControlPoint this[int index]
        {
            get => _points[index];
            set => _points[index] = value;
        }

        public bool SetPoint(int index, Point3d point)
        {
            _points[index] = new ControlPoint(point, 1);
            return true;
        }

        public bool SetPoint(int index, Point3d point, double weight)
        {
            _points[index] = new ControlPoint(point, weight);
            return true;
        }

        public double GetWeight(int index) => _points[index].Weight;
    }
}
