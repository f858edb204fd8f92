using System;
using System.Collections.Generic;
using System.Drawing;
using System.Globalization;
using System.Linq;
using System.Xml;
using GH_IO.Types;

namespace GH_IO.Serialization
{
    public class GH_Chunk : GH_IReader, GH_IWriter
    {
        private readonly List<GH_Item> _items = new List<GH_Item>();
        private readonly List<GH_Chunk> _chunks = new List<GH_Chunk>();

        internal GH_Chunk(string name, int index)
        {
            Name = name;
            Index = index;
        }

        public string Name { get; }

        public int Index { get; }

        public int ItemCount => _items.Count;

        public List<GH_Item> Items => _items.ToList();

        public int ChunkCount => _chunks.Count;

        public List<GH_IChunk> Chunks => _chunks.Cast<GH_IChunk>().ToList();

        public GH_IReader FindChunk(string name) => FindChunk(name, -1);

        public GH_IReader FindChunk(string name, int index) => _chunks.Find(c => c.Name == name && c.Index == index);

        public bool ChunkExists(string name) => FindChunk(name) != null;

        public bool ChunkExists(string name, int index) => FindChunk(name, index) != null;

        public GH_IWriter CreateChunk(string chunk_name) => CreateChunk(chunk_name, -1);

        public GH_IWriter CreateChunk(string chunk_name, int chunk_index)
        {
            var chunk = new GH_Chunk(chunk_name, chunk_index);
            if (FindChunk(chunk_name, chunk_index) != null) throw new ArgumentException("The chunk " + Name + " has a chunk " + chunk_name + " already.");
            _chunks.Add(chunk);
            return chunk;
        }

        public bool ItemExists(string name) => ItemExists(name, -1);

        public bool ItemExists(string name, int index) => Find(name, index) != null;

        public bool GetBoolean(string item_name) => Get<bool>(item_name);

        public int GetInt32(string item_name) => Get<int>(item_name);

        public int GetInt32(string item_name, int item_index) => Get<int>(item_name, item_index);

        public long GetInt64(string item_name) => Get<long>(item_name);

        public double GetDouble(string item_name) => Get<double>(item_name);

        public double GetDouble(string item_name, int item_index) => Get<double>(item_name, item_index);

        public Guid GetGuid(string item_name) => Get<Guid>(item_name);

        public Guid GetGuid(string item_name, int item_index) => Get<Guid>(item_name, item_index);

        public string GetString(string item_name) => Get<string>(item_name);

        public string GetString(string item_name, int item_index) => Get<string>(item_name, item_index);

        public byte[] GetByteArray(string item_name) => Get<byte[]>(item_name);

        public GH_Point3D GetPoint3D(string item_name) => Get<GH_Point3D>(item_name);

        public GH_Plane GetPlane(string item_name) => Get<GH_Plane>(item_name);

        public GH_Version GetVersion(string item_name) => Get<GH_Version>(item_name);

        public bool TryGetBoolean(string item_name, ref bool value) => TryGet(item_name, ref value);

        public bool TryGetInt32(string item_name, ref int value) => TryGet(item_name, ref value);

        public bool TryGetDouble(string item_name, ref double value) => TryGet(item_name, ref value);

        public bool TryGetGuid(string item_name, ref Guid value) => TryGet(item_name, ref value);

        public bool TryGetString(string item_name, ref string value) => TryGet(item_name, ref value);

        public bool TryGetDrawingColor(string item_name, ref Color value) => TryGet(item_name, ref value);

        public void SetBoolean(string item_name, bool item_value) => Set(item_name, -1, GH_Types.gh_bool, item_value);

        public void SetInt32(string item_name, int item_value) => Set(item_name, -1, GH_Types.gh_int32, item_value);

        public void SetInt32(string item_name, int item_index, int item_value) => Set(item_name, item_index, GH_Types.gh_int32, item_value);

        public void SetInt64(string item_name, long item_value) => Set(item_name, -1, GH_Types.gh_int64, item_value);

        public void SetDouble(string item_name, double item_value) => Set(item_name, -1, GH_Types.gh_double, item_value);

        public void SetDouble(string item_name, int item_index, double item_value) => Set(item_name, item_index, GH_Types.gh_double, item_value);

        public void SetGuid(string item_name, Guid item_value) => Set(item_name, -1, GH_Types.gh_guid, item_value);

        public void SetGuid(string item_name, int item_index, Guid item_value) => Set(item_name, item_index, GH_Types.gh_guid, item_value);

        public void SetString(string item_name, string item_value) => Set(item_name, -1, GH_Types.gh_string, item_value ?? "");

        public void SetString(string item_name, int item_index, string item_value) => Set(item_name, item_index, GH_Types.gh_string, item_value ?? "");

        public void SetByteArray(string item_name, byte[] item_value) => Set(item_name, -1, GH_Types.gh_bytearray, item_value);

        public void SetPoint3D(string item_name, GH_Point3D item_value) => Set(item_name, -1, GH_Types.gh_point3d, item_value);

        public void SetPlane(string item_name, GH_Plane item_value) => Set(item_name, -1, GH_Types.gh_plane, item_value);

        public void SetVersion(string item_name, GH_Version item_value) => Set(item_name, -1, GH_Types.gh_version, item_value);

        public void SetVersion(string item_name, int major, int minor, int revision) => SetVersion(item_name, new GH_Version(major, minor, revision));

        public void SetDrawingColor(string item_name, Color item_value) => Set(item_name, -1, GH_Types.gh_drawing_color, item_value);

        public void SetDrawingPointF(string item_name, PointF item_value) => Set(item_name, -1, GH_Types.gh_drawing_pointf, item_value);

        public void SetDrawingRectangleF(string item_name, RectangleF item_value) => Set(item_name, -1, GH_Types.gh_drawing_rectanglef, item_value);

        internal void WriteXml(XmlWriter writer, string element)
        {
            writer.WriteStartElement(element);
            writer.WriteAttributeString("name", Name);
            if (Index >= 0) writer.WriteAttributeString("index", Index.ToString(CultureInfo.InvariantCulture));
            if (element == "Archive")
            {
                writer.WriteComment("Grasshopper archive");
                writer.WriteComment("Grasshopper and GH_IO.dll are copyrighted by Robert McNeel & Associates");
                writer.WriteComment("Archive generated by GH_IO.dll file utility library {0.2.0002}");
            }
            if (_items.Count > 0)
            {
                writer.WriteStartElement("items");
                writer.WriteAttributeString("count", _items.Count.ToString(CultureInfo.InvariantCulture));
                foreach (var item in Sorted(_items, i => i.Name, i => i.Index)) item.WriteXml(writer);
                writer.WriteEndElement();
            }
            if (_chunks.Count > 0)
            {
                writer.WriteStartElement("chunks");
                writer.WriteAttributeString("count", _chunks.Count.ToString(CultureInfo.InvariantCulture));
                foreach (var chunk in _chunks) chunk.WriteXml(writer, "chunk");
                writer.WriteEndElement();
            }
            writer.WriteEndElement();
        }

        internal static GH_Chunk ReadXml(XmlElement e)
        {
            var index = e.HasAttribute("index") ? int.Parse(e.GetAttribute("index"), CultureInfo.InvariantCulture) : -1;
            var chunk = new GH_Chunk(e.GetAttribute("name"), index);
            foreach (var item in Children(e, "items", "item")) chunk._items.Add(GH_Item.ReadXml(item));
            foreach (var child in Children(e, "chunks", "chunk")) chunk._chunks.Add(ReadXml(child));
            return chunk;
        }

        private static IEnumerable<XmlElement> Children(XmlElement e, string group, string kind)
            => e[group] == null ? Enumerable.Empty<XmlElement>() : e[group].ChildNodes.OfType<XmlElement>().Where(c => c.Name == kind);

        // Items stand in the order of their names, as the archive keeps them in a sorted dictionary.
        private static IEnumerable<T> Sorted<T>(IEnumerable<T> all, Func<T, string> name, Func<T, int> index)
            => all.OrderBy(name, StringComparer.OrdinalIgnoreCase).ThenBy(index);

        private GH_Item Find(string name, int index) => _items.Find(i => i.Name == name && i.Index == index);

        private T Get<T>(string name, int index = -1)
        {
            var item = Find(name, index);
            if (item == null) throw new KeyNotFoundException("The chunk " + Name + " has no item " + name + ".");
            return (T)item.InternalData;
        }

        private bool TryGet<T>(string name, ref T value)
        {
            if (!(Find(name, -1)?.InternalData is T found)) return false;
            value = found;
            return true;
        }

        private void Set(string name, int index, GH_Types type, object value)
        {
            if (Find(name, index) != null) throw new InvalidOperationException("The chunk " + Name + " has an item " + name + " already.");
            _items.Add(new GH_Item(name, index, type, value));
        }
    }

    public class GH_LooseChunk : GH_Chunk
    {
        public GH_LooseChunk(string chunk_name) : base(chunk_name, -1)
        {
        }
    }
}
