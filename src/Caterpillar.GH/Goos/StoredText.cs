using Newtonsoft.Json;

namespace Caterpillar.GH.Goos;

/// <summary>Text as it is stored in definitions: pure ASCII, because their XML drops rare characters.</summary>
internal static class StoredText
{
    /// <summary>Version of the form in which values are stored in definitions.</summary>
    public const int Version = 1;

    public static byte[] Deflate(byte[] bytes)
    {
        using var memory = new MemoryStream();
        using (var stream = new DeflateStream(memory, CompressionLevel.Optimal)) stream.Write(bytes, 0, bytes.Length);
        return memory.ToArray();
    }

    /// <summary>Null for bytes that are damaged.</summary>
    public static byte[]? Inflate(byte[] bytes)
    {
        try
        {
            using var stream = new DeflateStream(new MemoryStream(bytes), CompressionMode.Decompress);
            using var memory = new MemoryStream();
            stream.CopyTo(memory);
            return memory.ToArray();
        }
        catch (Exception damaged) when (damaged is InvalidDataException or IOException)
        {
            return null;
        }
    }

    public static string Pack(string text)
    {
        using var writer = new System.IO.StringWriter(System.Globalization.CultureInfo.InvariantCulture);
        using var json = new JsonTextWriter(writer) { StringEscapeHandling = StringEscapeHandling.EscapeNonAscii };
        json.WriteValue(text);
        json.Flush();
        return writer.ToString();
    }

    /// <summary>The text. Text that is not packed stays as it is.</summary>
    public static string Unpack(string stored)
    {
        if (stored.Length < 2 || stored[0] != '"') return stored;
        try
        {
            return JsonConvert.DeserializeObject<string>(stored) ?? stored;
        }
        catch (JsonException)
        {
            return stored;
        }
    }
}
