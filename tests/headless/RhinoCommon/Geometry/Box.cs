namespace Rhino.Geometry
{
    public struct Box
    {
        public Box(BoundingBox bbox)
            : this(Plane.WorldXY, new Interval(bbox.Min.X, bbox.Max.X), new Interval(bbox.Min.Y, bbox.Max.Y), new Interval(bbox.Min.Z, bbox.Max.Z))
        {
        }

        public Box(Plane basePlane, Interval xSize, Interval ySize, Interval zSize)
        {
            Plane = basePlane;
            X = xSize;
            Y = ySize;
            Z = zSize;
        }

        public Plane Plane { get; set; }

        public Interval X { get; set; }

        public Interval Y { get; set; }

        public Interval Z { get; set; }

        public bool IsValid => Plane.IsValid && X.T1 >= X.T0 && Y.T1 >= Y.T0 && Z.T1 >= Z.T0;

        public BoundingBox BoundingBox => new BoundingBox(GetCorners());

        public bool MakeValid()
        {
            X = Ordered(X);
            Y = Ordered(Y);
            Z = Ordered(Z);
            return Plane.IsValid;
        }

        /// <summary>The bottom counter-clockwise, then the top.</summary>
        public Point3d[] GetCorners()
        {
            var (plane, x, y, z) = (Plane, X, Y, Z);
            Point3d At(double a, double b, double c) => plane.Origin + plane.XAxis * a + plane.YAxis * b + plane.ZAxis * c;
            return new[]
            {
                At(x.T0, y.T0, z.T0), At(x.T1, y.T0, z.T0), At(x.T1, y.T1, z.T0), At(x.T0, y.T1, z.T0),
                At(x.T0, y.T0, z.T1), At(x.T1, y.T0, z.T1), At(x.T1, y.T1, z.T1), At(x.T0, y.T1, z.T1),
            };
        }

        private static Interval Ordered(Interval i) => i.T1 < i.T0 ? new Interval(i.T1, i.T0) : i;
    }
}
