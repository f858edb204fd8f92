namespace Caterpillar.Files;

/// <summary>Reads images as brightness: PNG (all color types and depths, interlaced too).</summary>
public static class ImageReader
{
    /// <summary>The maximum number of pixels: 100 million.</summary>
    public const long MaxPixels = 100_000_000;

    /// <summary>Reads a file. A file that is not an image gives an error. Throws only if the disk fails.</summary>
    public static Result<GrayImage> Read(string path) => Read(File.ReadAllBytes(path), path);

    /// <summary>Reads the bytes of a file. Messages use the name. Colors become brightness by Rec. 709. Transparency is blended with white.</summary>
    public static Result<GrayImage> Read(byte[] bytes, string name)
    {
        if (bytes is null) throw new ArgumentNullException(nameof(bytes));
        try
        {
            return PngReader.IsPng(bytes) ? new Result<GrayImage>(PngReader.Read(bytes), []) : Failed("The file is not a PNG image.", name);
        }
        catch (InvalidDataException problem)
        {
            return Failed(problem.Message, name);
        }
        catch (IOException)
        {
            // Mono reports damaged compressed data this way; nothing else here touches a disk.
            return Failed("The compressed data of the image is damaged.", name);
        }
    }

    internal static int Pixels(long width, long height)
    {
        if (width < 1 || height < 1) throw new InvalidDataException("The image has no pixels.");
        if (width > MaxPixels || height > MaxPixels || width * height > MaxPixels)
            throw new InvalidDataException("The image has more than 100 million pixels.");
        return (int)(width * height);
    }

    private static Result<GrayImage> Failed(string message, string name)
        => new("image.unreadable", message, new SourceLocation(name));
}
