using System;
using Caterpillar.Files;
using Caterpillar.Shaping;

namespace Caterpillar.Examples;

/// <summary>A rough map of the continents by longitude and latitude. Land is white. The outlines were drawn by hand for this example.</summary>
internal static class WorldMap
{
    // Longitude, latitude, degrees.
    private static readonly double[][] Land =
    [
        // North America
        [-168, 66, -156, 71, -128, 70, -110, 68, -95, 72, -82, 70, -80, 62, -94, 59, -85, 55, -79, 52, -77, 62, -65, 60, -56, 52, -66, 49, -60, 46, -70, 43,
            -76, 35, -81, 31, -80, 25, -83, 29,
            -90, 29, -97, 27, -97, 21, -91, 18, -87, 21, -88, 16, -83, 14, -83, 10, -78, 8, -82, 7, -86, 11, -93, 15, -105, 20, -110, 24, -114, 31, -117, 33,
                -124, 40, -124, 48, -132, 56, -147, 61, -158, 57, -165, 60],
        // Greenland
        [-73, 78, -58, 82, -30, 83, -18, 78, -22, 70, -40, 65, -44, 60, -52, 64, -54, 70, -60, 76],
        // South America
        [-78, 8, -72, 12, -62, 10, -52, 5, -50, 0, -35, -6, -39, -14, -41, -22, -48, -26, -54, -34, -58, -38, -65, -43, -66, -48, -69, -54, -75, -50, -73, -40,
            -71, -30, -70, -18, -76, -14, -81, -5, -80, 1],
        // Africa
        [-6, 36, 10, 37, 11, 33, 20, 32, 32, 31, 35, 24, 39, 16, 43, 11, 51, 12, 46, 3, 40, -4, 40, -14, 35, -20, 35, -25, 28, -33, 19, -35, 15, -27, 12, -17,
            13, -8, 9, 0, 9, 5, -5, 5, -13, 9, -17, 15, -16, 22, -10, 30],
        // Madagascar
        [49, -12, 50, -16, 47, -25, 44, -24, 44, -17],
        // Europe and Asia
        [-9, 37, -9, 43, -2, 44, -5, 48, 2, 51, 8, 54, 11, 56, 8, 57, 5, 59, 5, 62, 14, 68, 26, 71, 40, 67, 34, 65, 44, 66, 55, 69, 68, 69, 70, 73, 87, 75, 104,
            78, 114, 74, 140, 73, 160, 70, 180, 69, 180, 65, 178, 63, 163, 60,
            162, 56, 157, 51, 156, 57, 162, 61, 152, 59, 137, 54, 141, 53, 140, 48, 132, 43, 127, 39, 129, 35, 126, 34, 125, 39, 118, 39, 122, 37, 120, 34, 122,
                30, 117, 24, 108, 21, 109, 12, 105, 9, 101, 13, 103, 2, 98, 9, 98, 16, 92, 22,
            87, 21, 80, 15, 80, 10, 77, 8, 73, 17, 70, 22, 62, 25, 57, 26, 50, 30, 56, 26, 59, 22, 52, 16, 43, 13, 39, 21, 35, 28, 36, 36, 28, 37, 27, 40, 23,
                38, 19, 42, 13, 45, 18, 40, 16, 38, 10, 44, 3, 43, -1, 37],
        // Great Britain, Japan, Borneo, Sumatra, New Guinea, New Zealand, Iceland
        [-5, 50, 1, 51, 0, 53, -3, 58, -6, 57, -4, 54],
        [130, 32, 136, 34, 141, 36, 142, 40, 145, 43, 141, 45, 139, 38, 132, 35],
        [109, 1, 113, -3, 116, -3, 119, 5, 116, 7, 111, 2],
        [95, 5, 100, 2, 106, -4, 105, -6, 99, 0],
        [131, -1, 138, -2, 147, -6, 150, -10, 141, -9, 137, -6],
        [173, -35, 178, -38, 175, -41, 171, -44, 168, -47, 167, -45, 172, -41],
        [-24, 65, -16, 66, -14, 64, -20, 63],
        // Australia, Tasmania
        [114, -22, 122, -18, 130, -12, 136, -12, 136, -16, 140, -17, 142, -11, 146, -19, 153, -26, 150, -37, 145, -39, 139, -36, 131, -32, 118, -35, 115, -32],
        [145, -41, 148, -41, 147, -43],
        // Antarctica
        [-180, -90, -180, -78, -150, -77, -110, -74, -75, -72, -60, -64, -60, -75, -30, -78, 0, -70, 50, -67, 90, -66, 140, -67, 165, -71, 165, -78, 180, -78,
            180, -90],
    ];

    public static GrayImage Draw(int width, int height)
    {
        var pixels = new double[width * height];
        for (var y = 0; y < height; y++)
        {
            for (var x = 0; x < width; x++)
            {
                double longitude = (x + 0.5) / width * 360 - 180, latitude = 90 - (y + 0.5) / height * 180;
                pixels[y * width + x] = Array.Exists(Land, outline => Contains(outline, longitude, latitude)) ? 1 : 0;
            }
        }
        return new GrayImage(width, height, pixels);
    }

    private static bool Contains(double[] outline, double x, double y)
    {
        var inside = false;
        for (int i = 0, j = outline.Length - 2; i < outline.Length; j = i, i += 2)
        {
            if (outline[i + 1] > y != outline[j + 1] > y
                && x < (outline[j] - outline[i]) * (y - outline[i + 1]) / (outline[j + 1] - outline[i + 1]) + outline[i])
                inside = !inside;
        }
        return inside;
    }

    /// <summary>File name of the map that turtle scripts read.</summary>
    public const string FileName = "world_map.png";

    /// <summary>The map as a PNG of 300 × 150 pixels.</summary>
    public static byte[] ToPng()
    {
        var map = Draw(300, 150);
        var image = new RasterImage(map.Width, map.Height, new Rgb(0, 0, 0));
        for (var y = 0; y < map.Height; y++)
        {
            for (var x = 0; x < map.Width; x++)
            {
                if (map[x, y] > 0.5) image[x, y] = new Rgb(255, 255, 255);
            }
        }
        return PngWriter.ToBytes(image);
    }
}
