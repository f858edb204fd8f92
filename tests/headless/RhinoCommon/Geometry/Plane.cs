using System;
using System.Globalization;

namespace Rhino.Geometry
{
    public struct Plane : IEquatable<Plane>
    {
        public Plane(Point3d origin, Vector3d normal)
        {
            Origin = origin;
            ZAxis = normal.Unit();
            XAxis = ZAxis.AnyPerpendicular();
            YAxis = Vector3d.CrossProduct(ZAxis, XAxis);
        }

        public Plane(Point3d origin, Vector3d xDirection, Vector3d yDirection)
        {
            Origin = origin;
            XAxis = xDirection.Unit();
            ZAxis = Vector3d.CrossProduct(XAxis, yDirection).Unit();
            YAxis = Vector3d.CrossProduct(ZAxis, XAxis);
        }

        public static Plane WorldXY => new Plane(Point3d.Origin, Vector3d.XAxis, Vector3d.YAxis);

        public static Plane Unset => new Plane { Origin = Point3d.Unset };

        public Point3d Origin { get; set; }

        public Vector3d XAxis { get; set; }

        public Vector3d YAxis { get; set; }

        public Vector3d ZAxis { get; set; }

        public Vector3d Normal => ZAxis;

        public bool IsValid => Origin.IsValid && Math.Abs(XAxis.SquareLength - 1) < 1e-6 && Math.Abs(YAxis.SquareLength - 1) < 1e-6
            && Math.Abs(ZAxis.SquareLength - 1) < 1e-6 && Math.Abs(XAxis * YAxis) < 1e-6;

        public static bool operator ==(Plane a, Plane b) => a.Equals(b);

        public static bool operator !=(Plane a, Plane b) => !a.Equals(b);

        public Point3d PointAt(double u, double v) => Origin + XAxis * u + YAxis * v;

        public Point3d PointAt(double u, double v, double w) => PointAt(u, v) + ZAxis * w;

        public bool Transform(Transform xform)
        {
            this = new Plane(xform * Origin, xform * XAxis, xform * YAxis);
            return IsValid;
        }

        public bool Equals(Plane plane) => Origin == plane.Origin && XAxis == plane.XAxis && YAxis == plane.YAxis && ZAxis == plane.ZAxis;

        public override bool Equals(object obj) => obj is Plane other && Equals(other);

        public override int GetHashCode() => Origin.GetHashCode() ^ XAxis.GetHashCode() ^ YAxis.GetHashCode();

        public override string ToString()
            => string.Format(CultureInfo.InvariantCulture, "Origin={0} XAxis={1}, YAxis={2}, ZAxis={3}", Origin, XAxis, YAxis, ZAxis);
    }
}
