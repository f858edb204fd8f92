using System.Collections.Generic;
using System.Drawing;
using System.Linq;
using Rhino.DocObjects;
using Rhino.Geometry.Collections;

namespace Rhino.Geometry
{
    public struct MeshFace
    {
        public MeshFace(int a, int b, int c) : this(a, b, c, c)
        {
        }

        public MeshFace(int a, int b, int c, int d)
        {
            A = a;
            B = b;
            C = c;
            D = d;
        }

        public int A { get; set; }

        public int B { get; set; }

        public int C { get; set; }

        public int D { get; set; }

        public bool IsTriangle => C == D;

        public bool IsQuad => C != D;
    }

    public class Mesh : GeometryBase
    {
        public Mesh()
        {
            Vertices = new MeshVertexList();
            Faces = new MeshFaceList();
            VertexColors = new MeshVertexColorList();
        }

        public MeshVertexList Vertices { get; }

        public MeshFaceList Faces { get; }

        public MeshVertexColorList VertexColors { get; }

        public MeshVertexNormalList Normals { get; } = new MeshVertexNormalList();

        /// <summary>True when every edge belongs to two faces; vertices at one place are one.</summary>
        public bool IsClosed => Faces.Count > 0 && Edges().All(e => e.Value == 2);

        public Mesh DuplicateMesh() => (Mesh)Duplicate();

        public override GeometryBase Duplicate() => CopyOf();

        public void Append(Mesh other)
        {
            var offset = Vertices.Count;
            Vertices.AddVertices(other.Vertices.ToPoint3dArray());
            foreach (var f in other.Faces.Items) Faces.AddFace(new MeshFace(f.A + offset, f.B + offset, f.C + offset, f.D + offset));
            foreach (var c in other.VertexColors.Items) VertexColors.Add(c);
        }

        /// <summary>One polyline for each edge with a single face.</summary>
        public Polyline[] GetNakedEdges()
        {
            var naked = Edges().Where(e => e.Value == 1)
                .Select(e => new Polyline(new[] { Vertices.Point3dAt((int)(e.Key >> 32)), Vertices.Point3dAt((int)(e.Key & uint.MaxValue)) })).ToArray();
            return naked.Length == 0 ? null : naked;
        }

        public static Mesh[] CreateFromBrep(Brep brep, MeshingParameters meshingParameters) => brep.Meshes();

        public static Mesh CreateFromSurface(Surface surface, MeshingParameters meshingParameters) => surface.Faces.Meshes()[0];

        public static Mesh CreateFromSubD(SubD subd, int displayDensity) => subd.Control.DuplicateMesh();

        internal override bool CheckValid() => Vertices.Count > 2 && Faces.Count > 0
            && Faces.Items.All(f => new[] { f.A, f.B, f.C, f.D }.All(i => i >= 0 && i < Vertices.Count)) && Vertices.Items.All(v => v.IsValid)
            && Faces.Items.All(f => Corners(f).Select(i => Vertices.Items[i]).Distinct().Count() == Corners(f).Length);

        private static int[] Corners(MeshFace f) => f.IsTriangle ? new[] { f.A, f.B, f.C } : new[] { f.A, f.B, f.C, f.D };

        internal override ObjectType KindOf() => ObjectType.Mesh;

        internal override GeometryBase CopyOf()
        {
            var copy = new Mesh();
            copy.Vertices.UseDoublePrecisionVertices = Vertices.UseDoublePrecisionVertices;
            copy.Append(this);
            return copy;
        }

        internal override void Map(Transform xform)
        {
            for (var i = 0; i < Vertices.Count; i++) Vertices.Items[i] = xform * Vertices.Items[i];
        }

        internal override BoundingBox Box(Transform xform) => new BoundingBox(Vertices.Items.Select(v => xform * v));

        internal override IEnumerable<double> Numbers()
            => Vertices.Items.SelectMany(v => new double[] { (float)v.X, (float)v.Y, (float)v.Z })
                .Concat(Faces.Items.SelectMany(f => new double[] { f.A, f.B, f.C, f.D }));

        private Dictionary<long, int> Edges()
        {
            var edges = new Dictionary<long, int>();
            var first = new Dictionary<Point3d, int>();
            for (var i = Vertices.Count - 1; i >= 0; i--) first[Vertices.Items[i]] = i;
            foreach (var f in Faces.Items)
            {
                var corners = Corners(f).Select(i => first[Vertices.Items[i]]).ToArray();
                for (var i = 0; i < corners.Length; i++)
                {
                    int a = corners[i], b = corners[(i + 1) % corners.Length];
                    var key = a < b ? ((long)a << 32) | (uint)b : ((long)b << 32) | (uint)a;
                    edges.TryGetValue(key, out var count);
                    edges[key] = count + 1;
                }
            }
            return edges;
        }
    }
}

namespace Rhino.Geometry.Collections
{
    public class MeshVertexList
    {
        internal readonly List<Point3d> Items = new List<Point3d>();

        internal MeshVertexList()
        {
        }

        public int Count => Items.Count;

        public bool UseDoublePrecisionVertices { get; set; } = true;

        public int Add(double x, double y, double z)
        {
            Items.Add(UseDoublePrecisionVertices ? new Point3d(x, y, z) : new Point3d((float)x, (float)y, (float)z));
            return Items.Count - 1;
        }

        public int Add(Point3d vertex) => Add(vertex.X, vertex.Y, vertex.Z);

        public void AddVertices(IEnumerable<Point3d> vertices)
        {
            foreach (var vertex in vertices) Add(vertex);
        }

        public Point3d Point3dAt(int index) => Items[index];

        public Point3d[] ToPoint3dArray() => Items.ToArray();
    }

    public class MeshFaceList
    {
        internal readonly List<MeshFace> Items = new List<MeshFace>();

        internal MeshFaceList()
        {
        }

        public int Count => Items.Count;

        public int TriangleCount => Items.Count(f => f.IsTriangle);

        public int QuadCount => Items.Count(f => f.IsQuad);

        public MeshFace this[int index]
        {
            get => Items[index];
            set => Items[index] = value;
        }

        public int AddFace(int vertex1, int vertex2, int vertex3) => AddFace(new MeshFace(vertex1, vertex2, vertex3));

        public int AddFace(int vertex1, int vertex2, int vertex3, int vertex4) => AddFace(new MeshFace(vertex1, vertex2, vertex3, vertex4));

        public int[] AddFaces(IEnumerable<MeshFace> faces) => faces.Select(AddFace).ToArray();

        public int AddFace(MeshFace face)
        {
            Items.Add(face);
            return Items.Count - 1;
        }
    }

    /// <summary>Not kept here.</summary>
    public class MeshVertexNormalList
    {
        internal MeshVertexNormalList()
        {
        }

        public bool ComputeNormals() => true;
    }

    public class MeshVertexColorList
    {
        internal readonly List<Color> Items = new List<Color>();

        internal MeshVertexColorList()
        {
        }

        public int Count => Items.Count;

        public Color this[int index]
        {
            get => Items[index];
            set => Items[index] = value;
        }

        public bool SetColors(Color[] colors)
        {
            Items.Clear();
            Items.AddRange(colors);
            return true;
        }

        public int Add(Color color)
        {
            Items.Add(color);
            return Items.Count - 1;
        }
    }
}
