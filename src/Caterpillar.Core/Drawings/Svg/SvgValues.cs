namespace Caterpillar.Drawings;

/// <summary>SVG lengths, lists of numbers and transforms. Null if the text is invalid.</summary>
internal static class SvgValues
{
    /// <summary>CSS pixels per mm.</summary>
    public const double PixelsPerMm = 96 / Units.MmPerInch;

    /// <summary>A length in CSS pixels. Percentages refer to <paramref name="whole"/>.</summary>
    public static double? Length(string? text, double whole)
    {
        if (text is null) return null;
        var bytes = Encoding.ASCII.GetBytes(text.Trim());
        var next = NumberReader.Scan(bytes, 0, bytes.Length, true, out var value);
        if (next == 0 || !(Math.Abs(value) <= 1e9)) return null;
        var unit = Encoding.ASCII.GetString(bytes, next, bytes.Length - next).Trim();
        double? factor = unit switch
        {
            "" or "px" => 1,
            "mm" => PixelsPerMm,
            "cm" => 10 * PixelsPerMm,
            "in" => 96,
            "pt" => 96 / 72.0,
            "pc" => 16,
            "Q" or "q" => PixelsPerMm / 4,
            "%" => whole / 100,
            _ => null,
        };
        return value * factor;
    }

    /// <summary>Numbers separated by spaces or commas.</summary>
    public static double[]? Numbers(string text)
    {
        var bytes = Encoding.ASCII.GetBytes(text);
        var values = new List<double>();
        for (var at = 0; ;)
        {
            while (at < bytes.Length && (bytes[at] <= ' ' || bytes[at] == ',')) at++;
            if (at == bytes.Length) return values.ToArray();
            var next = NumberReader.Scan(bytes, at, bytes.Length, true, out var value);
            if (next == at || !(Math.Abs(value) <= 1e9)) return null;
            values.Add(value);
            at = next;
        }
    }

    /// <summary>A list of transforms as one map. The last in the list acts first.</summary>
    public static Affine? Transform(string text)
    {
        var map = Affine.Identity;
        var at = 0;
        while (true)
        {
            while (at < text.Length && (text[at] <= ' ' || text[at] == ',')) at++;
            if (at == text.Length) return map;
            var open = text.IndexOf('(', at);
            var close = open < 0 ? -1 : text.IndexOf(')', open);
            if (close < 0 || Numbers(text.Substring(open + 1, close - open - 1)) is not { } n) return null;
            if (One(text.Substring(at, open - at).Trim(), n) is not { } next) return null;
            map = next.Then(map);
            at = close + 1;
        }
    }

    /// <summary>The map of a viewBox onto a viewport in pixels, by preserveAspectRatio.</summary>
    public static Affine ViewBox(double[] box, double x, double y, double width, double height, string? aspect)
    {
        var (sx, sy) = (width / box[2], height / box[3]);
        double dx = 0, dy = 0;
        var words = (aspect ?? "xMidYMid").Split([' '], StringSplitOptions.RemoveEmptyEntries);
        var align = words.Length > 0 ? words[0] : "xMidYMid";
        if (align != "none")
        {
            var s = words.Length > 1 && words[1] == "slice" ? Math.Max(sx, sy) : Math.Min(sx, sy);
            dx = (width - box[2] * s) * Share(align, "xMin", "xMax");
            dy = (height - box[3] * s) * Share(align, "YMin", "YMax");
            (sx, sy) = (s, s);
        }
        return new Affine(new Vec3(sx, 0), new Vec3(0, sy), Vec3.UnitZ, new Vec3(x + dx - box[0] * sx, y + dy - box[1] * sy));
    }

    private static double Share(string align, string low, string high)
        => align.IndexOf(low, StringComparison.Ordinal) >= 0 ? 0 : align.IndexOf(high, StringComparison.Ordinal) >= 0 ? 1 : 0.5;

    private static Affine? One(string name, double[] n)
    {
        switch (name)
        {
            case "matrix" when n.Length == 6:
                return new Affine(new Vec3(n[0], n[1]), new Vec3(n[2], n[3]), Vec3.UnitZ, new Vec3(n[4], n[5]));
            case "translate" when n.Length is 1 or 2:
                return Affine.Move(new Vec3(n[0], n.Length > 1 ? n[1] : 0));
            case "scale" when n.Length is 1 or 2:
                return Affine.Scale(n[0], n.Length > 1 ? n[1] : n[0], 1);
            case "rotate" when n.Length == 1:
                return Affine.Rotate(Vec3.UnitZ, n[0]);
            case "rotate" when n.Length == 3:
                return Affine.Move(new Vec3(-n[1], -n[2])).Then(Affine.Rotate(Vec3.UnitZ, n[0])).Then(Affine.Move(new Vec3(n[1], n[2])));
            case "skewX" when n.Length == 1 && Skew(n[0]) is { } x:
                return new Affine(Vec3.UnitX, new Vec3(x, 1), Vec3.UnitZ, Vec3.Zero);
            case "skewY" when n.Length == 1 && Skew(n[0]) is { } y:
                return new Affine(new Vec3(1, y), Vec3.UnitY, Vec3.UnitZ, Vec3.Zero);
            default:
                return null;
        }
    }

    private static double? Skew(double degrees)
    {
        var (sin, cos) = Angle.SinCos(degrees);
        return cos != 0 ? sin / cos : null;
    }
}
