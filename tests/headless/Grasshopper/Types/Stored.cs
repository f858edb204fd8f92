using System;
using System.IO;
using System.IO.Compression;
using System.Text;
using Rhino.Runtime;

namespace Grasshopper.Kernel.Types
{
    /// <summary>Geometry as definitions hold it: an object of RhinoCommon as .NET serializes it, compressed.</summary>
    internal static class Stored
    {
        private const byte Reference = 9;
        private const byte Bytes = 15;

        public static CommonObject Read(byte[] bytes)
        {
            using (var inflated = new DeflateStream(new MemoryStream(bytes), CompressionMode.Decompress))
            using (var reader = new BinaryReader(inflated, Encoding.UTF8))
            {
                reader.ReadBytes(17);
                Expect(reader, 12);
                reader.ReadInt32();
                reader.ReadString();
                Expect(reader, 5);
                reader.ReadInt32();
                reader.ReadString();
                for (var members = reader.ReadInt32(); members > 0; members--) reader.ReadString();
                // Three integers and an array of bytes, then the id of the library and the version of the form.
                reader.ReadBytes(8 + 4 + 4);
                var archive = reader.ReadInt32();
                var library = reader.ReadInt32();
                Expect(reader, Reference);
                reader.ReadInt32();
                Expect(reader, Bytes);
                reader.ReadInt32();
                var length = reader.ReadInt32();
                reader.ReadByte();
                return CommonObject.FromBase64String(archive, library, Convert.ToBase64String(reader.ReadBytes(length)));
            }
        }

        private static void Expect(BinaryReader reader, byte record)
        {
            if (reader.ReadByte() != record) throw new NotSupportedException("The headless host reads serialized objects of RhinoCommon only.");
        }
    }
}
