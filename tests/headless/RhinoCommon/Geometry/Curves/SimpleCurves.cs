using System;
using System.Collections.Generic;
using System.Linq;

namespace Rhino.Geometry
{
    public class PolylineCurve : Curve
    {
        private Point3d[] _points;
        private double[] _parameters;

        public PolylineCurve(IEnumerable<Point3d> points)
        {
            _points = points.ToArray();
            _parameters = Enumerable.Range(0, _points.Length).Select(i => (double)i).ToArray();
        }

        public int PointCount => _points.Length;

        internal override Interval Range
        {
            get => new Interval(_parameters[0], _parameters[_parameters.Length - 1]);
            set => _parameters = _parameters.Select(t => value.T0 + (t - Domain.T0) / Domain.Length * value.Length).ToArray();
        }

        public Point3d Point(int index) => _points[index];

        public Polyline ToPolyline() => new Polyline(_points);

        // Neighbors at one place are not valid, nor is a line there and back, which counts as closed.
        internal override bool CheckValid() => _points.Length > 1 && _points.All(p => p.IsValid)
            && Enumerable.Range(1, _points.Length - 1).All(i => _points[i].DistanceTo(_points[i - 1]) > RhinoMath.ZeroTolerance)
            && !(_points.Length == 3 && _points[0].DistanceTo(_points[2]) <= RhinoMath.ZeroTolerance);

        internal override GeometryBase CopyOf() => new PolylineCurve(_points) { _parameters = (double[])_parameters.Clone() };

        internal override void Map(Transform xform) => _points = _points.Select(p => xform * p).ToArray();

        internal override BoundingBox Box(Transform xform) => new BoundingBox(_points.Select(p => xform * p));

        internal override double[] Spans() => (double[])_parameters.Clone();

        internal override Polyline AsPolyline() => new Polyline(_points);

        internal override void Flip()
        {
            Array.Reverse(_points);
            Array.Reverse(_parameters);
            _parameters = _parameters.Select(t => -t).ToArray();
        }

        internal override Point3d At(double t)
        {
            var i = Array.FindLastIndex(_parameters, p => p <= t);
            i = Math.Max(0, Math.Min(i, _points.Length - 2));
            var s = (t - _parameters[i]) / (_parameters[i + 1] - _parameters[i]);
            return s == 1 ? _points[i + 1] : _points[i] + (_points[i + 1] - _points[i]) * s;
        }

        internal override NurbsCurve Nurbs()
        {
            var nurbs = new NurbsCurve(3, false, 2, _points.Length);
            for (var i = 0; i < _points.Length; i++)
            {
                nurbs.Points.SetPoint(i, _points[i]);
                nurbs.Knots[i] = _parameters[i];
            }
            return nurbs;
        }
    }

    public class LineCurve : Curve
    {
        private Line _line;

        public LineCurve(Point3d from, Point3d to) : this(new Line(from, to))
        {
        }

        public LineCurve(Line line)
        {
            _line = line;
            Range = new Interval(0, line.Length);
        }

        public Line Line => _line;

        internal override bool CheckValid() => _line.IsValid;

        internal override GeometryBase CopyOf() => new LineCurve(_line) { Range = Range };

        internal override void Map(Transform xform) => _line = new Line(xform * _line.From, xform * _line.To);

        internal override Point3d At(double t) => _line.PointAt((t - Domain.T0) / Domain.Length);

        internal override Polyline AsPolyline() => new Polyline(new[] { _line.From, _line.To });

        internal override void Flip() => _line = new Line(_line.To, _line.From);

        internal override NurbsCurve Nurbs()
        {
            var nurbs = new NurbsCurve(3, false, 2, 2);
            nurbs.Points.SetPoint(0, _line.From);
            nurbs.Points.SetPoint(1, _line.To);
            nurbs.Knots[0] = Domain.T0;
            nurbs.Knots[1] = Domain.T1;
            return nurbs;
        }
    }

    /// <summary>Curves one after another; the parameter of the i-th runs from i to i + 1.</summary>
    public class PolyCurve : Curve
    {
        private readonly List<Curve> _segments = new List<Curve>();

        public int SegmentCount => _segments.Count;

        internal override Interval Range
        {
            get => new Interval(0, _segments.Count);
            set => throw new NotSupportedException();
        }

        public Curve SegmentCurve(int index) => index >= 0 && index < _segments.Count ? _segments[index] : null;

        public bool Append(Curve curve)
        {
            if (_segments.Count > 0 && PointAtEnd.DistanceTo(curve.PointAtStart) > 1e-6) return false;
            _segments.Add(curve.DuplicateCurve());
            return true;
        }

        internal override IEnumerable<double> Numbers() => _segments.SelectMany(s => s.Numbers());

        internal override bool CheckValid() => _segments.Count > 0 && _segments.All(s => s.IsValid);

        internal override GeometryBase CopyOf()
        {
            var copy = new PolyCurve();
            copy._segments.AddRange(_segments.Select(s => s.DuplicateCurve()));
            return copy;
        }

        internal override void Map(Transform xform) => _segments.ForEach(s => s.Transform(xform));

        internal override BoundingBox Box(Transform xform) => _segments.Aggregate(BoundingBox.Empty, (box, s) => BoundingBox.Union(box, s.Box(xform)));

        internal override int DegreeOf() => _segments.Max(s => s.Degree);

        internal override double Length() => _segments.Sum(s => s.GetLength());

        internal override double[] Spans() => _segments.SelectMany((s, i) => s.Spans().Skip(i == 0 ? 0 : 1)
            .Select(t => i + (t - s.Domain.T0) / s.Domain.Length)).ToArray();

        internal override Point3d At(double t)
        {
            var i = Math.Max(0, Math.Min((int)Math.Floor(t), _segments.Count - 1));
            return _segments[i].PointAt(_segments[i].Domain.ParameterAt(t - i));
        }

        internal override Polyline AsPolyline()
        {
            var points = new Polyline();
            foreach (var segment in _segments)
            {
                if (!segment.TryGetPolyline(out var part)) return null;
                points.AddRange(points.Count == 0 ? part : part.Skip(1));
            }
            return points.Count < 2 ? null : points;
        }

        internal override void Flip()
        {
            _segments.Reverse();
            _segments.ForEach(s => s.Reverse());
        }

        internal override NurbsCurve Nurbs() => throw NeedsRhino("One NURBS form of a joined curve");
    }
}
