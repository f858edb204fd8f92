using System;

namespace Rhino.Geometry
{
    public struct Point3f : IEquatable<Point3f>
    {
        public Point3f(float x, float y, float z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        public float X { get; set; }

        public float Y { get; set; }

        public float Z { get; set; }

        public bool Equals(Point3f point) => X == point.X && Y == point.Y && Z == point.Z;

        public override bool Equals(object obj) => obj is Point3f other && Equals(other);

        public override int GetHashCode() => X.GetHashCode() ^ Y.GetHashCode() ^ Z.GetHashCode();
    }

    public struct Point4d : IEquatable<Point4d>
    {
        public Point4d(double x, double y, double z, double w)
        {
            X = x;
            Y = y;
            Z = z;
            W = w;
        }

        public double X { get; set; }

        public double Y { get; set; }

        public double Z { get; set; }

        public double W { get; set; }

        public bool Equals(Point4d point) => X == point.X && Y == point.Y && Z == point.Z && W == point.W;

        public override bool Equals(object obj) => obj is Point4d other && Equals(other);

        public override int GetHashCode() => X.GetHashCode() ^ Y.GetHashCode() ^ Z.GetHashCode() ^ W.GetHashCode();
    }

    public struct Interval : IEquatable<Interval>
    {
        public Interval(double t0, double t1)
        {
            T0 = t0;
            T1 = t1;
        }

        public double T0 { get; set; }

        public double T1 { get; set; }

        public double Min => Math.Min(T0, T1);

        public double Max => Math.Max(T0, T1);

        public double Length => T1 - T0;

        public bool IsValid => RhinoMath.IsValidDouble(T0) && RhinoMath.IsValidDouble(T1);

        public double ParameterAt(double normalizedParameter) => (1 - normalizedParameter) * T0 + normalizedParameter * T1;

        public bool Equals(Interval other) => T0 == other.T0 && T1 == other.T1;

        public override bool Equals(object obj) => obj is Interval other && Equals(other);

        public override int GetHashCode() => T0.GetHashCode() ^ T1.GetHashCode();
    }

    public struct Line
    {
        public Line(Point3d from, Point3d to)
        {
            From = from;
            To = to;
        }

        public Point3d From { get; set; }

        public Point3d To { get; set; }

        public double Length => From.DistanceTo(To);

        public Vector3d Direction => To - From;

        public bool IsValid => From.IsValid && To.IsValid && From != To;

        public BoundingBox BoundingBox => new BoundingBox(new[] { From, To });

        public Point3d PointAt(double t) => From + (To - From) * t;
    }

    public struct ControlPoint
    {
        // The list of the public API names the constructor's second point Euclidean: Location is the point divided by its weight.
        public ControlPoint(Point3d euclideanPt, double weight)
        {
            Location = euclideanPt;
            Weight = weight;
        }

        public Point3d Location { get; set; }

        public double Weight { get; set; }
    }
}
