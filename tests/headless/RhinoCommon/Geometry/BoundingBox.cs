using System;
using System.Collections.Generic;

namespace Rhino.Geometry
{
    public struct BoundingBox
    {
        public BoundingBox(Point3d min, Point3d max)
        {
            Min = min;
            Max = max;
        }

        public BoundingBox(double minX, double minY, double minZ, double maxX, double maxY, double maxZ)
            : this(new Point3d(minX, minY, minZ), new Point3d(maxX, maxY, maxZ))
        {
        }

        public BoundingBox(IEnumerable<Point3d> points)
        {
            this = Empty;
            foreach (var point in points) Union(point);
        }

        public static BoundingBox Empty => new BoundingBox(1, 0, 0, -1, 0, 0);

        public static BoundingBox Unset => new BoundingBox(Point3d.Unset, Point3d.Unset);

        public Point3d Min { get; set; }

        public Point3d Max { get; set; }

        public bool IsValid => Min.IsValid && Max.IsValid && Min.X <= Max.X && Min.Y <= Max.Y && Min.Z <= Max.Z;

        public Point3d Center => Min + (Max - Min) * 0.5;

        public Vector3d Diagonal => Max - Min;

        public bool Contains(Point3d point)
            => point.X >= Min.X && point.Y >= Min.Y && point.Z >= Min.Z && point.X <= Max.X && point.Y <= Max.Y && point.Z <= Max.Z;

        public void Inflate(double amount)
        {
            Min = Min - new Vector3d(amount, amount, amount);
            Max = Max + new Vector3d(amount, amount, amount);
        }

        public Point3d[] GetCorners()
        {
            if (!IsValid) return null;
            return new[]
            {
                new Point3d(Min.X, Min.Y, Min.Z), new Point3d(Max.X, Min.Y, Min.Z), new Point3d(Max.X, Max.Y, Min.Z), new Point3d(Min.X, Max.Y, Min.Z),
                new Point3d(Min.X, Min.Y, Max.Z), new Point3d(Max.X, Min.Y, Max.Z), new Point3d(Max.X, Max.Y, Max.Z), new Point3d(Min.X, Max.Y, Max.Z),
            };
        }

        public bool Transform(Transform xform)
        {
            if (!IsValid) return false;
            var corners = GetCorners();
            for (var i = 0; i < corners.Length; i++) corners[i] = xform * corners[i];
            this = new BoundingBox(corners);
            return true;
        }

        public void Union(BoundingBox other)
        {
            if (!other.IsValid) return;
            Union(other.Min);
            Union(other.Max);
        }

        public void Union(Point3d point)
        {
            if (!IsValid)
            {
                Min = Max = point;
                return;
            }
            Min = new Point3d(Math.Min(Min.X, point.X), Math.Min(Min.Y, point.Y), Math.Min(Min.Z, point.Z));
            Max = new Point3d(Math.Max(Max.X, point.X), Math.Max(Max.Y, point.Y), Math.Max(Max.Z, point.Z));
        }

        public static BoundingBox Union(BoundingBox a, BoundingBox b)
        {
            a.Union(b);
            return a;
        }
    }
}
