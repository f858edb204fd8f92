using System;
using System.Globalization;
using System.Text;
using System.Xml.Linq;

namespace Caterpillar.CanvasPictures;

/// <summary>Draws into the text of an SVG file.</summary>
internal sealed class SvgSurface : ISurface
{
    private readonly StringBuilder _text = new();

    public SvgSurface(Box extent)
    {
        Add($"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{Number(extent.X)} {Number(extent.Y)} {Number(extent.Width)} {Number(extent.Height)}\" ");
        Add($"width=\"{Number(extent.Width)}\" height=\"{Number(extent.Height)}\" ");
        Add($"font-family=\"Arial, 'Liberation Sans', 'DejaVu Sans Condensed', sans-serif\">\n");
    }

    public void Rectangle(Box box, double radius, string fill, string edge, double opacity = 1)
    {
        Add($"<rect x=\"{Number(box.X)}\" y=\"{Number(box.Y)}\" width=\"{Number(box.Width)}\" height=\"{Number(box.Height)}\" ");
        Add($"rx=\"{Number(radius)}\" fill=\"{fill}\" stroke=\"{edge}\"");
        if (opacity < 1) Add($" opacity=\"{Number(opacity)}\"");
        Add($"/>\n");
    }

    public void Curve(Wire wire, string color, double width, bool dashed)
    {
        var (a, b) = (wire.Start, wire.End);
        Add($"<path d=\"M{Number(a.X)} {Number(a.Y)}C{Number(a.X + wire.Reach)} {Number(a.Y)} {Number(b.X - wire.Reach)} {Number(b.Y)} ");
        Add($"{Number(b.X)} {Number(b.Y)}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{Number(width)}\"");
        if (dashed) Add($" stroke-dasharray=\"7 4\"");
        Add($"/>\n");
    }

    public void Disc(Spot center, double radius, string fill, string edge)
        => Add($"<circle cx=\"{Number(center.X)}\" cy=\"{Number(center.Y)}\" r=\"{Number(radius)}\" fill=\"{fill}\" stroke=\"{edge}\"/>\n");

    public void Text(string text, Spot at, double size, Side side, string color, bool mono = false, bool bold = false)
    {
        Add($"<text x=\"{Number(at.X)}\" y=\"{Number(at.Y)}\" font-size=\"{Number(size)}\" fill=\"{color}\"");
        if (side != Side.Start) Add($" text-anchor=\"{(side == Side.Middle ? "middle" : "end")}\"");
        if (mono) Add($" font-family=\"Consolas, 'DejaVu Sans Mono', monospace\" xml:space=\"preserve\"");
        if (bold) Add($" font-weight=\"bold\"");
        Add($">{new XText(text)}</text>\n");
    }

    public void Image(Box box, byte[] png)
    {
        Add($"<image x=\"{Number(box.X)}\" y=\"{Number(box.Y)}\" width=\"{Number(box.Width)}\" height=\"{Number(box.Height)}\" ");
        Add($"href=\"data:image/png;base64,{Convert.ToBase64String(png)}\"/>\n");
    }

    public override string ToString() => _text + "</svg>\n";

    private void Add(FormattableString text) => _text.Append(FormattableString.Invariant(text));

    private static string Number(double value) => Math.Round(value, 1).ToString(CultureInfo.InvariantCulture);
}
