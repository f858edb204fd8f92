using System;
using System.IO;
using System.Linq;
using Rhino.Runtime;

namespace Rhino.Geometry
{
    /// <summary>Reads polylines, meshes, and Breps of flat faces with four corners, in the form of openNURBS archives of version 4.</summary>
    internal static class OpenNurbs
    {
        private const int ClassId = 0x0002FFFB;
        private const int ClassData = 0x0002FFFC;
        private static readonly Guid Polyline = new Guid("4ED7D4E6-E947-11d3-BFE5-0010830122F0");
        private static readonly Guid MeshId = new Guid("4ED7D4E4-E947-11d3-BFE5-0010830122F0");
        private static readonly Guid BrepId = new Guid("60B5DBC5-E660-11d3-BFE4-0010830122F0");
        private static readonly Guid Nurbs = new Guid("4ED7D4DE-E947-11d3-BFE5-0010830122F0");

        public static CommonObject Read(byte[] bytes)
        {
            using (var reader = new BinaryReader(new MemoryStream(bytes)))
            {
                var id = Begin(reader);
                var version = reader.ReadByte() >> 4;
                if (id == Polyline && version == 1) return ReadPolyline(reader);
                if (id == MeshId && version == 3) return ReadMesh(reader);
                if (id == BrepId && version == 3) return ReadBrep(reader);
                throw GeometryBase.NeedsRhino("Reading an object of class " + id);
            }
        }

        // Up to the data of an object, whose class it returns.
        private static Guid Begin(BinaryReader reader)
        {
            reader.ReadInt64();
            Chunk(reader, ClassId);
            var id = new Guid(reader.ReadBytes(16));
            reader.ReadInt32();
            Chunk(reader, ClassData);
            return id;
        }

        private static PolylineCurve ReadPolyline(BinaryReader reader)
            => new PolylineCurve(Enumerable.Range(0, reader.ReadInt32())
                .Select(_ => new Point3d(reader.ReadDouble(), reader.ReadDouble(), reader.ReadDouble())));

        private static Mesh ReadMesh(BinaryReader reader)
        {
            int vertices = reader.ReadInt32(), faces = reader.ReadInt32();
            // Domains, boxes, whether it is closed; no parameters and no statistics.
            reader.ReadBytes(10 * 8 + 16 * 4 + 4);
            if (reader.ReadBytes(5).Any(b => b != 0)) throw GeometryBase.NeedsRhino("Reading a mesh with parameters");
            var size = reader.ReadInt32();
            int Index() => size == 1 ? reader.ReadByte() : size == 2 ? reader.ReadUInt16() : reader.ReadInt32();
            var corners = Enumerable.Range(0, faces * 4).Select(_ => Index()).ToArray();
            reader.ReadInt64();
            if (reader.ReadByte() != 0) throw GeometryBase.NeedsRhino("Reading a compressed mesh");
            var mesh = new Mesh();
            for (var i = 0; i < vertices; i++) mesh.Vertices.Add(reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle());
            for (var i = 0; i < corners.Length; i += 4)
            {
                if (corners[i + 2] == corners[i + 3]) mesh.Faces.AddFace(corners[i], corners[i + 1], corners[i + 2]);
                else mesh.Faces.AddFace(corners[i], corners[i + 1], corners[i + 2], corners[i + 3]);
            }
            return mesh;
        }

        // After the curves in the plane and in space come the surfaces, of which each is here the whole face.
        private static Brep ReadBrep(BinaryReader reader)
        {
            for (var curves = 0; curves < 2; curves++)
            {
                reader.ReadInt32();
                reader.ReadBytes(reader.ReadInt32());
            }
            reader.ReadBytes(8 + 1);
            var faces = new Point3d[reader.ReadInt32()][];
            for (var i = 0; i < faces.Length; i++)
            {
                reader.ReadInt32();
                var start = reader.BaseStream.Position;
                var id = Begin(reader);
                reader.ReadByte();
                var form = Enumerable.Range(0, 6).Select(_ => reader.ReadInt32());
                if (id != Nurbs || !form.SequenceEqual(new[] { 3, 0, 2, 2, 2, 2 })) throw GeometryBase.NeedsRhino("Reading a Brep with curved faces");
                // Two integers, the box, and two lists of two knots.
                reader.ReadBytes(2 * 4 + 6 * 8 + 2 * (4 + 2 * 8) + 4);
                var p = Enumerable.Range(0, 4).Select(_ => new Point3d(reader.ReadDouble(), reader.ReadDouble(), reader.ReadDouble())).ToArray();
                faces[i] = new[] { p[0], p[2], p[3], p[1] };
                reader.BaseStream.Position = start + 4;
                var length = reader.ReadInt32();
                reader.BaseStream.Position += length;
            }
            return new Brep(faces);
        }

        private static void Chunk(BinaryReader reader, int code)
        {
            if (reader.ReadInt32() != code) throw new InvalidDataException("An archive of openNURBS has chunks of a class id and class data.");
            reader.ReadInt32();
        }
    }
}
