namespace Caterpillar.Files;

/// <summary>PNG (ISO 15948) as brightness: color types 0, 2, 3, 4 and 6, depths 1 to 16, Adam7 interlacing.</summary>
internal sealed class PngReader
{
    private static readonly byte[] Signature = [0x89, 0x50, 0x4E, 0x47, 13, 10, 26, 10];

    // First column and row, steps.
    private static readonly (int X, int Y, int Dx, int Dy)[] Plain = [(0, 0, 1, 1)];
    private static readonly (int X, int Y, int Dx, int Dy)[] Adam7 =
        [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)];

    private readonly byte[] _file;
    private int _width;
    private int _height;
    private int _depth;
    private int _color;
    private (int X, int Y, int Dx, int Dy)[] _passes = Plain;
    private byte[] _palette = [];
    private byte[] _transparency = [];

    private PngReader(byte[] file) => _file = file;

    public static bool IsPng(byte[] bytes) => bytes.Length >= 33 && bytes.Take(8).SequenceEqual(Signature);

    /// <exception cref="InvalidDataException">The file is damaged.</exception>
    public static GrayImage Read(byte[] bytes) => new PngReader(bytes).Read();

    private int Channels => _color switch { 0 or 3 => 1, 4 => 2, 2 => 3, _ => 4 };

    private int RowBytes(int width) => (int)(((long)width * Channels * _depth + 7) / 8);

    private GrayImage Read()
    {
        using var packed = new MemoryStream();
        for (var at = 8; at + 12 <= _file.Length;)
        {
            var length = BigEndian(at);
            if (length < 0 || length > _file.Length - at - 12) throw new InvalidDataException("A chunk is longer than the file.");
            var name = BigEndian(at + 4);
            if (at == 8) ReadHeader(name, length);
            else if (name == 0x504C5445) _palette = Slice(at + 8, length);
            else if (name == 0x74524E53) _transparency = Slice(at + 8, length);
            else if (name == 0x49444154) packed.Write(_file, at + 8, length);
            else if (name == 0x49454E44) break;
            at += length + 12;
        }
        var count = ImageReader.Pixels(_width, _height);
        var data = Unpack(packed);
        var pixels = new double[count];
        var from = 0;
        foreach (var pass in _passes) ReadPass(data, ref from, pass, pixels);
        return new GrayImage(_width, _height, pixels);
    }

    private void ReadHeader(int name, int length)
    {
        if (name != 0x49484452 || length != 13) throw new InvalidDataException("The header of the PNG is missing.");
        _width = BigEndian(16);
        _height = BigEndian(20);
        _depth = _file[24];
        _color = _file[25];
        _passes = _file[28] == 1 ? Adam7 : Plain;
        int[] depths = _color switch { 0 => [1, 2, 4, 8, 16], 3 => [1, 2, 4, 8], 2 or 4 or 6 => [8, 16], _ => [] };
        if (!depths.Contains(_depth)) throw new InvalidDataException("The PNG has an unknown color type or depth.");
    }

    private byte[] Unpack(MemoryStream packed)
    {
        var size = _passes.Select(Size).Where(p => p.Width > 0).Sum(p => (RowBytes(p.Width) + 1L) * p.Height);
        // Deflate shrinks at most about 1032 times; a declared size beyond that is not allocated.
        if (packed.Length < 2 || size > packed.Length * 1100) throw new InvalidDataException("The PNG is cut off.");
        packed.Position = 2;
        var data = new byte[size];
        using var inflate = new DeflateStream(packed, CompressionMode.Decompress);
        return ReadStream.Fill(inflate, data, 0, data.Length) == data.Length ? data : throw new InvalidDataException("The PNG is cut off.");
    }

    private (int Width, int Height) Size((int X, int Y, int Dx, int Dy) pass)
        => (_width <= pass.X ? 0 : (_width - pass.X + pass.Dx - 1) / pass.Dx, _height <= pass.Y ? 0 : (_height - pass.Y + pass.Dy - 1) / pass.Dy);

    private void ReadPass(byte[] data, ref int from, (int X, int Y, int Dx, int Dy) pass, double[] pixels)
    {
        var (width, height) = Size(pass);
        if (width == 0) return;
        var row = RowBytes(width);
        var step = Math.Max(1, Channels * _depth / 8);
        for (var y = 0; y < height; y++, from += row + 1)
        {
            Unfilter(data, from, row, step, y > 0 ? from - row : -1);
            for (var x = 0; x < width; x++) pixels[(pass.Y + y * pass.Dy) * _width + pass.X + x * pass.Dx] = Brightness(data, from + 1, x);
        }
    }

    private static void Unfilter(byte[] data, int filterAt, int row, int step, int above)
    {
        var filter = data[filterAt];
        if (filter > 4) throw new InvalidDataException("The PNG has an unknown filter.");
        for (var i = 0; i < row; i++)
        {
            int left = i >= step ? data[filterAt + 1 + i - step] : 0;
            int up = above >= 0 ? data[above + i] : 0;
            int corner = above >= 0 && i >= step ? data[above + i - step] : 0;
            var predicted = filter switch { 0 => 0, 1 => left, 2 => up, 3 => (left + up) / 2, _ => Paeth(left, up, corner) };
            data[filterAt + 1 + i] = (byte)(data[filterAt + 1 + i] + predicted);
        }
    }

    private static int Paeth(int left, int up, int corner)
    {
        int p = left + up - corner, dl = Math.Abs(p - left), du = Math.Abs(p - up), dc = Math.Abs(p - corner);
        return dl <= du && dl <= dc ? left : du <= dc ? up : corner;
    }

    private double Brightness(byte[] data, int row, int x)
    {
        double At(int channel) => Sample(data, row, x * Channels + channel) / (double)((1 << _depth) - 1);
        if (_color == 3) return PaletteBrightness(Sample(data, row, x));
        var gray = _color is 2 or 6 ? Gray(At(0), At(1), At(2)) : At(0);
        var alpha = _color is 4 or 6 ? At(Channels - 1) : 1;
        return 1 - alpha + gray * alpha;
    }

    private double PaletteBrightness(int index)
    {
        if (index * 3 + 2 >= _palette.Length) throw new InvalidDataException("The PNG uses a color beyond its palette.");
        var gray = Gray(_palette[index * 3] / 255.0, _palette[index * 3 + 1] / 255.0, _palette[index * 3 + 2] / 255.0);
        var alpha = index < _transparency.Length ? _transparency[index] / 255.0 : 1;
        return 1 - alpha + gray * alpha;
    }

    // Equal channels are gray exactly.
    private static double Gray(double r, double g, double b) => r == g && g == b ? r : 0.2126 * r + 0.7152 * g + 0.0722 * b;

    private int Sample(byte[] data, int row, int index)
    {
        if (_depth == 8) return data[row + index];
        if (_depth == 16) return (data[row + 2 * index] << 8) | data[row + 2 * index + 1];
        var bit = index * _depth;
        return (data[row + bit / 8] >> (8 - _depth - bit % 8)) & ((1 << _depth) - 1);
    }

    private int BigEndian(int at) => (_file[at] << 24) | (_file[at + 1] << 16) | (_file[at + 2] << 8) | _file[at + 3];

    private byte[] Slice(int at, int length) => [.. new ArraySegment<byte>(_file, at, length)];
}
