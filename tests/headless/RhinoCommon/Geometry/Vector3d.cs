using System;
using System.Globalization;

namespace Rhino.Geometry
{
    public struct Vector3d : IEquatable<Vector3d>
    {
        public Vector3d(double x, double y, double z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        public Vector3d(Point3d point) : this(point.X, point.Y, point.Z)
        {
        }

        public static Vector3d Zero => default;

        public static Vector3d XAxis => new Vector3d(1, 0, 0);

        public static Vector3d YAxis => new Vector3d(0, 1, 0);

        public static Vector3d ZAxis => new Vector3d(0, 0, 1);

        public double X { get; set; }

        public double Y { get; set; }

        public double Z { get; set; }

        public double SquareLength => X * X + Y * Y + Z * Z;

        public double Length => Math.Sqrt(SquareLength);

        public bool IsZero => X == 0 && Y == 0 && Z == 0;

        public bool IsValid => RhinoMath.IsValidDouble(X) && RhinoMath.IsValidDouble(Y) && RhinoMath.IsValidDouble(Z);

        public static Vector3d operator *(Vector3d vector, double t) => new Vector3d(vector.X * t, vector.Y * t, vector.Z * t);

        public static Vector3d operator *(double t, Vector3d vector) => vector * t;

        public static double operator *(Vector3d vector1, Vector3d vector2) => vector1.X * vector2.X + vector1.Y * vector2.Y + vector1.Z * vector2.Z;

        public static Vector3d operator +(Vector3d vector1, Vector3d vector2)
            => new Vector3d(vector1.X + vector2.X, vector1.Y + vector2.Y, vector1.Z + vector2.Z);

        public static Vector3d operator -(Vector3d vector1, Vector3d vector2)
            => new Vector3d(vector1.X - vector2.X, vector1.Y - vector2.Y, vector1.Z - vector2.Z);

        public static Vector3d operator -(Vector3d vector) => new Vector3d(-vector.X, -vector.Y, -vector.Z);

        public static bool operator ==(Vector3d a, Vector3d b) => a.Equals(b);

        public static bool operator !=(Vector3d a, Vector3d b) => !a.Equals(b);

        public static Vector3d CrossProduct(Vector3d a, Vector3d b)
            => new Vector3d(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

        public bool Equals(Vector3d vector) => X == vector.X && Y == vector.Y && Z == vector.Z;

        public override bool Equals(object obj) => obj is Vector3d other && Equals(other);

        public override int GetHashCode() => X.GetHashCode() ^ Y.GetHashCode() ^ Z.GetHashCode();

        public bool Unitize()
        {
            var length = Length;
            if (!(length > 0)) return false;
            this = this * (1 / length);
            return true;
        }

        public void Transform(Transform transformation) => this = transformation * this;

        public override string ToString() => string.Format(CultureInfo.InvariantCulture, "{0},{1},{2}", X, Y, Z);

        internal Vector3d Unit()
        {
            var unit = this;
            unit.Unitize();
            return unit;
        }

        internal Vector3d AnyPerpendicular()
            => CrossProduct(this, Math.Abs(X) < Math.Abs(Z) || Math.Abs(Y) < Math.Abs(Z) ? XAxis : ZAxis).Unit();
    }
}
