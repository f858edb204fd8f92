using System;

namespace Rhino.Geometry
{
    public struct Transform : IEquatable<Transform>
    {
        public Transform(double diagonalValue) : this()
        {
            M00 = M11 = M22 = diagonalValue;
            M33 = 1;
        }

        public static Transform Identity => new Transform(1);

        public double M00 { get; set; }

        public double M01 { get; set; }

        public double M02 { get; set; }

        public double M03 { get; set; }

        public double M10 { get; set; }

        public double M11 { get; set; }

        public double M12 { get; set; }

        public double M13 { get; set; }

        public double M20 { get; set; }

        public double M21 { get; set; }

        public double M22 { get; set; }

        public double M23 { get; set; }

        public double M30 { get; set; }

        public double M31 { get; set; }

        public double M32 { get; set; }

        public double M33 { get; set; }

        public bool IsIdentity => Equals(Identity);

        public double Determinant
            => M00 * (M11 * M22 - M12 * M21) - M01 * (M10 * M22 - M12 * M20) + M02 * (M10 * M21 - M11 * M20);

        public static Transform Translation(Vector3d motion) => Translation(motion.X, motion.Y, motion.Z);

        public static Transform Translation(double dx, double dy, double dz)
        {
            var t = Identity;
            t.M03 = dx;
            t.M13 = dy;
            t.M23 = dz;
            return t;
        }

        public static Transform Scale(Point3d anchor, double scaleFactor)
        {
            var t = new Transform(scaleFactor);
            t.M03 = anchor.X * (1 - scaleFactor);
            t.M13 = anchor.Y * (1 - scaleFactor);
            t.M23 = anchor.Z * (1 - scaleFactor);
            return t;
        }

        public static Transform Scale(Plane plane, double xScaleFactor, double yScaleFactor, double zScaleFactor)
        {
            var diagonal = Identity;
            diagonal.M00 = xScaleFactor;
            diagonal.M11 = yScaleFactor;
            diagonal.M22 = zScaleFactor;
            return FromPlane(plane) * diagonal * ToPlane(plane);
        }

        public static Transform Rotation(double angleRadians, Point3d rotationCenter) => Rotation(angleRadians, Vector3d.ZAxis, rotationCenter);

        public static Transform Rotation(double angleRadians, Vector3d rotationAxis, Point3d rotationCenter)
        {
            var u = rotationAxis.Unit();
            double s = Math.Sin(angleRadians), c = Math.Cos(angleRadians), k = 1 - c;
            var t = Identity;
            t.M00 = c + u.X * u.X * k;
            t.M01 = u.X * u.Y * k - u.Z * s;
            t.M02 = u.X * u.Z * k + u.Y * s;
            t.M10 = u.Y * u.X * k + u.Z * s;
            t.M11 = c + u.Y * u.Y * k;
            t.M12 = u.Y * u.Z * k - u.X * s;
            t.M20 = u.Z * u.X * k - u.Y * s;
            t.M21 = u.Z * u.Y * k + u.X * s;
            t.M22 = c + u.Z * u.Z * k;
            return Translation(new Vector3d(rotationCenter)) * t * Translation(-new Vector3d(rotationCenter));
        }

        public static Transform PlaneToPlane(Plane plane0, Plane plane1) => FromPlane(plane1) * ToPlane(plane0);

        public static Transform operator *(Transform a, Transform b)
        {
            var product = new Transform();
            for (var i = 0; i < 4; i++)
            {
                for (var j = 0; j < 4; j++)
                {
                    var sum = 0.0;
                    for (var k = 0; k < 4; k++) sum += a[i, k] * b[k, j];
                    product[i, j] = sum;
                }
            }
            return product;
        }

        public static Point3d operator *(Transform m, Point3d p)
        {
            var w = m.M30 * p.X + m.M31 * p.Y + m.M32 * p.Z + m.M33;
            var s = w == 0 ? 1 : 1 / w;
            return new Point3d(
                (m.M00 * p.X + m.M01 * p.Y + m.M02 * p.Z + m.M03) * s,
                (m.M10 * p.X + m.M11 * p.Y + m.M12 * p.Z + m.M13) * s,
                (m.M20 * p.X + m.M21 * p.Y + m.M22 * p.Z + m.M23) * s);
        }

        public static Vector3d operator *(Transform m, Vector3d v) => new Vector3d(
            m.M00 * v.X + m.M01 * v.Y + m.M02 * v.Z,
            m.M10 * v.X + m.M11 * v.Y + m.M12 * v.Z,
            m.M20 * v.X + m.M21 * v.Y + m.M22 * v.Z);

        public double this[int row, int column]
        {
            get
            {
                switch (row * 4 + column)
                {
                    case 0: return M00;
                    case 1: return M01;
                    case 2: return M02;
                    case 3: return M03;
                    case 4: return M10;
                    case 5: return M11;
                    case 6: return M12;
                    case 7: return M13;
                    case 8: return M20;
                    case 9: return M21;
                    case 10: return M22;
                    case 11: return M23;
                    case 12: return M30;
                    case 13: return M31;
                    case 14: return M32;
                    default: return M33;
                }
            }

            set
            {
                switch (row * 4 + column)
                {
                    case 0: M00 = value; break;
                    case 1: M01 = value; break;
                    case 2: M02 = value; break;
                    case 3: M03 = value; break;
                    case 4: M10 = value; break;
                    case 5: M11 = value; break;
                    case 6: M12 = value; break;
                    case 7: M13 = value; break;
                    case 8: M20 = value; break;
                    case 9: M21 = value; break;
                    case 10: M22 = value; break;
                    case 11: M23 = value; break;
                    case 12: M30 = value; break;
                    case 13: M31 = value; break;
                    case 14: M32 = value; break;
                    default: M33 = value; break;
                }
            }
        }

        public bool Equals(Transform other)
        {
            for (var i = 0; i < 16; i++)
            {
                if (this[i / 4, i % 4] != other[i / 4, i % 4]) return false;
            }
            return true;
        }

        public override bool Equals(object obj) => obj is Transform other && Equals(other);

        public override int GetHashCode() => M00.GetHashCode() ^ M03.GetHashCode() ^ M13.GetHashCode() ^ M23.GetHashCode();

        private static Transform FromPlane(Plane p)
        {
            var t = Identity;
            t.M00 = p.XAxis.X;
            t.M10 = p.XAxis.Y;
            t.M20 = p.XAxis.Z;
            t.M01 = p.YAxis.X;
            t.M11 = p.YAxis.Y;
            t.M21 = p.YAxis.Z;
            t.M02 = p.ZAxis.X;
            t.M12 = p.ZAxis.Y;
            t.M22 = p.ZAxis.Z;
            return Translation(new Vector3d(p.Origin)) * t;
        }

        private static Transform ToPlane(Plane p)
        {
            var t = Identity;
            t.M00 = p.XAxis.X;
            t.M01 = p.XAxis.Y;
            t.M02 = p.XAxis.Z;
            t.M10 = p.YAxis.X;
            t.M11 = p.YAxis.Y;
            t.M12 = p.YAxis.Z;
            t.M20 = p.ZAxis.X;
            t.M21 = p.ZAxis.Y;
            t.M22 = p.ZAxis.Z;
            return t * Translation(-new Vector3d(p.Origin));
        }
    }
}
