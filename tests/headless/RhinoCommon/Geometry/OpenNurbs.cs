using System;
using System.IO;
using System.Linq;
using Rhino.Runtime;

namespace Rhino.Geometry
{
    /// <summary>Reads polylines and meshes in the form of openNURBS archives of version 4.</summary>
    internal static class OpenNurbs
    {
        private const int ClassId = 0x0002FFFB;
        private const int ClassData = 0x0002FFFC;
        private static readonly Guid Polyline = new Guid("4ED7D4E6-E947-11d3-BFE5-0010830122F0");
        private static readonly Guid MeshId = new Guid("4ED7D4E4-E947-11d3-BFE5-0010830122F0");

        public static CommonObject Read(byte[] bytes)
        {
            using (var reader = new BinaryReader(new MemoryStream(bytes)))
            {
                reader.ReadInt64();
                Chunk(reader, ClassId);
                var id = new Guid(reader.ReadBytes(16));
                reader.ReadInt32();
                Chunk(reader, ClassData);
                var version = reader.ReadByte() >> 4;
                if (id == Polyline && version == 1) return ReadPolyline(reader);
                if (id == MeshId && version == 3) return ReadMesh(reader);
                throw GeometryBase.NeedsRhino("Reading an object of class " + id);
            }
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

        private static void Chunk(BinaryReader reader, int code)
        {
            if (reader.ReadInt32() != code) throw new InvalidDataException("An archive of openNURBS has chunks of a class id and class data.");
            reader.ReadInt32();
        }
    }
}
