using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Display;
using Caterpillar.Files;
using Caterpillar.Toolpaths;

namespace Caterpillar.Examples;

/// <summary>The legends of the pictures: the colors of roles, and the scale of numbers.</summary>
internal static class Legends
{
    private static readonly (Role Role, string Name)[] Roles =
    [
        (Role.OuterWall, "outer wall"), (Role.InnerWall, "inner wall"), (Role.OverhangWall, "overhang wall"), (Role.Infill, "infill"),
        (Role.SolidInfill, "solid infill"), (Role.TopSurface, "top surface"), (Role.BottomSurface, "bottom surface"), (Role.Bridge, "bridge"),
        (Role.GapFill, "gap fill"), (Role.Ironing, "ironing"), (Role.Skirt, "skirt, brim"), (Role.Support, "support, raft"),
        (Role.SupportInterface, "support interface"), (Role.PrimeTower, "prime tower"), (Role.Unspecified, "turtles, traces, curves"),
    ];

    /// <summary>Writes <c>legend_roles.svg</c> and <c>legend_scale.svg</c>.</summary>
    public static void Write(string folder)
    {
        const int Columns = 5, Wide = 150, High = 26;
        var cells = Roles.Select((r, i) => (X: 12 + i % Columns * Wide, Y: 12 + i / Columns * High, r.Role, r.Name));
        Save(folder, "legend_roles.svg", 12 + Columns * Wide, 12 + (Roles.Length + Columns - 1) / Columns * High,
            cells.SelectMany(c => new[] { Box(c.X, c.Y, 14, Palette.Of(c.Role)), Text(c.X + 20, c.Y + 12, c.Name) }));
        const int Steps = 60;
        Save(folder, "legend_scale.svg", 420, 42, Enumerable.Range(0, Steps).Select(i => Box(60 + 5 * i, 12, 6, Palette.At(i / (Steps - 1.0))))
            .Append(Text(12, 24, "lowest")).Append(Text(372, 24, "highest")));
    }

    private static string Box(int x, int y, int wide, Rgb color)
        => FormattableString.Invariant($"<rect x=\"{x}\" y=\"{y}\" width=\"{wide}\" height=\"14\" fill=\"rgb({color.R},{color.G},{color.B})\"/>");

    private static string Text(int x, int y, string text) => FormattableString.Invariant($"<text x=\"{x}\" y=\"{y}\">{text}</text>");

    private static void Save(string folder, string name, int width, int height, IEnumerable<string> shapes)
    {
        var size = string.Format(CultureInfo.InvariantCulture, "width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\"", width, height);
        var text = new StringBuilder($"<svg xmlns=\"http://www.w3.org/2000/svg\" {size} font-family=\"sans-serif\" font-size=\"12\" fill=\"#333\">\n");
        text.Append("<rect width=\"100%\" height=\"100%\" fill=\"#fafafa\"/>\n");
        foreach (var shape in shapes) text.Append(shape).Append('\n');
        File.WriteAllText(Path.Combine(folder, name), text.Append("</svg>\n").ToString());
    }
}
