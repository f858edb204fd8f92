using System;
using System.Globalization;

namespace Rhino.Geometry
{
    public struct Point3d : IEquatable<Point3d>
    {
        public Point3d(double x, double y, double z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        public Point3d(Vector3d vector) : this(vector.X, vector.Y, vector.Z)
        {
        }

        public Point3d(Point3d point) : this(point.X, point.Y, point.Z)
        {
        }

        public static Point3d Origin => new Point3d(0, 0, 0);

        public static Point3d Unset => new Point3d(RhinoMath.UnsetValue, RhinoMath.UnsetValue, RhinoMath.UnsetValue);

        public double X { get; set; }

        public double Y { get; set; }

        public double Z { get; set; }

        public bool IsValid => RhinoMath.IsValidDouble(X) && RhinoMath.IsValidDouble(Y) && RhinoMath.IsValidDouble(Z);

        public static Point3d operator *(Point3d point, double t) => new Point3d(point.X * t, point.Y * t, point.Z * t);

        public static Point3d operator +(Point3d point1, Point3d point2) => new Point3d(point1.X + point2.X, point1.Y + point2.Y, point1.Z + point2.Z);

        public static Point3d operator +(Point3d point, Vector3d vector) => new Point3d(point.X + vector.X, point.Y + vector.Y, point.Z + vector.Z);

        public static Point3d operator -(Point3d point, Vector3d vector) => new Point3d(point.X - vector.X, point.Y - vector.Y, point.Z - vector.Z);

        public static Vector3d operator -(Point3d point1, Point3d point2) => new Vector3d(point1.X - point2.X, point1.Y - point2.Y, point1.Z - point2.Z);

        public static bool operator ==(Point3d a, Point3d b) => a.Equals(b);

        public static bool operator !=(Point3d a, Point3d b) => !a.Equals(b);

        public bool Equals(Point3d point) => X == point.X && Y == point.Y && Z == point.Z;

        public override bool Equals(object obj) => obj is Point3d other && Equals(other);

        public override int GetHashCode() => X.GetHashCode() ^ Y.GetHashCode() ^ Z.GetHashCode();

        public double DistanceTo(Point3d other) => (this - other).Length;

        public double DistanceToSquared(Point3d other) => (this - other).SquareLength;

        public void Transform(Transform xform) => this = xform * this;

        public override string ToString() => string.Format(CultureInfo.InvariantCulture, "{0},{1},{2}", X, Y, Z);
    }
}
