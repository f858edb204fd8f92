using System;
using System.Collections.Generic;
using System.Drawing;
using GH_IO.Serialization;
using GH_IO.Types;

namespace GH_IO
{
    public interface GH_ISerializable
    {
        bool Write(GH_IWriter writer);

        bool Read(GH_IReader reader);
    }
}

namespace GH_IO.Serialization
{
    public interface GH_IChunk
    {
        string Name { get; }

        int Index { get; }

        int ItemCount { get; }

        List<GH_Item> Items { get; }

        int ChunkCount { get; }

        List<GH_IChunk> Chunks { get; }
    }

    public interface GH_IReader : GH_IChunk
    {
        GH_IReader FindChunk(string name);

        GH_IReader FindChunk(string name, int index);

        bool ChunkExists(string name);

        bool ChunkExists(string name, int index);

        bool ItemExists(string name);

        bool ItemExists(string name, int index);

        bool GetBoolean(string item_name);

        int GetInt32(string item_name);

        int GetInt32(string item_name, int item_index);

        long GetInt64(string item_name);

        double GetDouble(string item_name);

        double GetDouble(string item_name, int item_index);

        Guid GetGuid(string item_name);

        Guid GetGuid(string item_name, int item_index);

        string GetString(string item_name);

        string GetString(string item_name, int item_index);

        byte[] GetByteArray(string item_name);

        GH_Point3D GetPoint3D(string item_name);

        GH_Plane GetPlane(string item_name);

        GH_Version GetVersion(string item_name);

        bool TryGetBoolean(string item_name, ref bool value);

        bool TryGetInt32(string item_name, ref int value);

        bool TryGetDouble(string item_name, ref double value);

        bool TryGetGuid(string item_name, ref Guid value);

        bool TryGetString(string item_name, ref string value);

        bool TryGetDrawingColor(string item_name, ref Color value);
    }

    public interface GH_IWriter : GH_IChunk
    {
        GH_IWriter CreateChunk(string chunk_name);

        GH_IWriter CreateChunk(string chunk_name, int chunk_index);

        void SetBoolean(string item_name, bool item_value);

        void SetInt32(string item_name, int item_value);

        void SetInt32(string item_name, int item_index, int item_value);

        void SetInt64(string item_name, long item_value);

        void SetDouble(string item_name, double item_value);

        void SetDouble(string item_name, int item_index, double item_value);

        void SetGuid(string item_name, Guid item_value);

        void SetGuid(string item_name, int item_index, Guid item_value);

        void SetString(string item_name, string item_value);

        void SetString(string item_name, int item_index, string item_value);

        void SetByteArray(string item_name, byte[] item_value);

        void SetPoint3D(string item_name, GH_Point3D item_value);

        void SetPlane(string item_name, GH_Plane item_value);

        void SetVersion(string item_name, GH_Version item_value);

        void SetVersion(string item_name, int major, int minor, int revision);

        void SetDrawingColor(string item_name, Color item_value);

        void SetDrawingPointF(string item_name, PointF item_value);

        void SetDrawingRectangleF(string item_name, RectangleF item_value);
    }
}
