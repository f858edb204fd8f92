#pragma warning disable CA1305, CA1307 // Numbers are formatted before; one form for all frameworks.
using System;
using System.Globalization;
using System.Text;

namespace Caterpillar.CanvasPictures;

/// <summary>Draws into the text of an SVG file.</summary>
internal sealed class SvgSurface : ISurface
{
    private readonly StringBuilder _text = new();

    public SvgSurface(Box extent) => _text.Append("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"").Append(Number(extent.X)).Append(' ')
        .Append(Number(extent.Y)).Append(' ').Append(Number(extent.Width)).Append(' ').Append(Number(extent.Height)).Append("\" width=\"")
        .Append(Number(extent.Width)).Append("\" height=\"").Append(Number(extent.Height))
        .Append("\" font-family=\"Arial, 'Liberation Sans', "
            + "'DejaVu Sans Condensed', sans-serif\">\n");

    public void Rectangle(Box box, double radius, string fill, string edge, double opacity = 1)
        => _text.Append($"<rect x=\"{Number(box.X)}\" y=\"{Number(box.Y)}\" width=\"{Number(box.Width)}\" height=\"{Number(box.Height)}\" ")
            .Append($"rx=\"{Number(radius)}\" fill=\"{fill}\" stroke=\"{edge}\"").Append(opacity < 1 ? $" opacity=\"{Number(opacity)}\"" : "").Append("/>\n");

    public void Curve(Wire wire, string color, double width, bool dashed)
    {
        var (a, b) = (wire.Start, wire.End);
        _text.Append($"<path d=\"M{Number(a.X)} {Number(a.Y)}C{Number(a.X + wire.Reach)} {Number(a.Y)} {Number(b.X - wire.Reach)} {Number(b.Y)} ")
            .Append($"{Number(b.X)} {Number(b.Y)}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{Number(width)}\"")
            .Append(dashed ? " stroke-dasharray=\"7 4\"" : "").Append("/>\n");
    }

    public void Disc(Spot center, double radius, string fill, string edge)
        => _text.Append($"<circle cx=\"{Number(center.X)}\" cy=\"{Number(center.Y)}\" r=\"{Number(radius)}\" fill=\"{fill}\" stroke=\"{edge}\"/>\n");

    public void Text(string text, Spot at, double size, Side side, string color, bool mono = false, bool bold = false)
        => _text.Append($"<text x=\"{Number(at.X)}\" y=\"{Number(at.Y)}\" font-size=\"{Number(size)}\" fill=\"{color}\"")
            .Append(side == Side.Start ? "" : side == Side.Middle ? " text-anchor=\"middle\"" : " text-anchor=\"end\"")
            .Append(mono ? " font-family=\"Consolas, 'DejaVu Sans Mono', monospace\" xml:space=\"preserve\"" : "").Append(bold ? " font-weight=\"bold\"" : "")
            .Append('>').Append(Escaped(text)).Append("</text>\n");

    public void Image(Box box, byte[] png)
        => _text.Append($"<image x=\"{Number(box.X)}\" y=\"{Number(box.Y)}\" width=\"{Number(box.Width)}\" height=\"{Number(box.Height)}\" ")
            .Append($"href=\"data:image/png;base64,{Convert.ToBase64String(png)}\"/>\n");

    public override string ToString() => _text + "</svg>\n";

    private static string Escaped(string text) => text.Replace("&", "&amp;").Replace("<", "&lt;").Replace(">", "&gt;");

    private static string Number(double value) => Math.Round(value, 1).ToString(CultureInfo.InvariantCulture);
}
