namespace Caterpillar.CanvasPictures;

/// <summary>How a text stands at its spot.</summary>
internal enum Side
{
    Start,
    Middle,
    End,
}

/// <summary>What a picture is drawn on. Colors are #rrggbb; texts stand on their baseline.</summary>
internal interface ISurface
{
    void Rectangle(Box box, double radius, string fill, string edge, double opacity = 1);

    void Curve(Wire wire, string color, double width, bool dashed);

    void Disc(Spot center, double radius, string fill, string edge);

    void Text(string text, Spot at, double size, Side side, string color, bool mono = false, bool bold = false);

    void Image(Box box, byte[] png);
}
