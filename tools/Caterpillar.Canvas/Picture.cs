using System;
using System.Globalization;

namespace Caterpillar.CanvasPictures;

/// <summary>Draws a definition as Grasshopper's canvas shows it. Components carry their icon,
/// and their name above it as plug-ins for teaching show it.</summary>
internal static class Picture
{
    private const string Canvas = "#d4d0c8";
    private const string Ink = "#1e1e1e";
    private const string Edge = "#3c3c3c";
    private const string Plain = "#c9c9c9";
    private const string Orange = "#f7a93b";
    private const string Red = "#e0463c";
    private const string Yellow = "#fffa8c";
    private const double Border = 24;

    /// <summary>What the picture covers: everything, and an edge.</summary>
    public static Box Extent(Layout layout)
    {
        var extent = layout.Extent.Grown(Border);
        return new Box(Math.Floor(extent.X), Math.Floor(extent.Y), Math.Ceiling(extent.Width) + 1, Math.Ceiling(extent.Height) + 1);
    }

    public static string Svg(Layout layout, Results results, Func<Item, byte[]?> icon)
    {
        var surface = new SvgSurface(Extent(layout));
        Draw(surface, layout, results, icon);
        return surface.ToString();
    }

    public static void Draw(ISurface surface, Layout layout, Results results, Func<Item, byte[]?> icon)
    {
        surface.Rectangle(Extent(layout), 0, Canvas, Canvas);
        foreach (var frame in layout.Frames)
        {
            surface.Rectangle(frame.Box, 8, frame.Group.Color, Edge, 0.55);
            surface.Text(frame.Group.NickName, new Spot(frame.Box.X + 4, frame.Box.Y - 7), 15, Side.Start, Ink, bold: true);
        }
        foreach (var wire in layout.Wires) DrawWire(surface, wire, results);
        foreach (var placed in layout.Objects) DrawObject(surface, placed, results, icon);
    }

    private static void DrawWire(ISurface surface, Wire wire, Results results)
    {
        const string Thread = "#585858";
        var flow = results.Flows.TryGetValue(wire.From.Item.Outputs[wire.Output].Id, out var known) ? known : Flow.Item;
        surface.Curve(wire, Thread, flow == Flow.Item ? 2 : 4.5, flow == Flow.Tree);
        if (flow != Flow.Item) surface.Curve(wire, Canvas, 1.5, flow == Flow.Tree);
    }

    private static void DrawObject(ISurface surface, Placed placed, Results results, Func<Item, byte[]?> icon)
    {
        var item = placed.Item;
        for (var i = 0; i < placed.Inputs.Count && HasGrips(item); i++) surface.Disc(placed.InputAt(i), 3, "#ffffff", Edge);
        for (var i = 0; i < placed.Outputs.Count && HasGrips(item); i++) surface.Disc(placed.OutputAt(i), 3, "#ffffff", Edge);
        var body = results.Failed.Contains(item.Id) ? Red : results.Warned.Contains(item.Id) ? Orange : Plain;
        switch (item.Look)
        {
            case Look.Component: DrawComponent(surface, placed, body, icon(item)); break;
            case Look.Panel: DrawPanel(surface, placed, results); break;
            case Look.Slider: DrawSlider(surface, placed); break;
            case Look.Parameter:
                surface.Rectangle(placed.Box, 4, body, Edge);
                surface.Text(item.NickName, new Spot(placed.Box.MiddleX, placed.Box.MiddleY + 3.5), 10, Side.Middle, Ink);
                break;
            default: DrawValue(surface, placed); break;
        }
    }

    // What only explains has no wires; its grips would say nothing.
    private static bool HasGrips(Item item) => item.Look is not Look.Panel || item.NickName != "Read me";

    private static void DrawComponent(ISurface surface, Placed placed, string body, byte[]? icon)
    {
        var (box, core) = (placed.Box, placed.Core);
        surface.Rectangle(box, 4, body, Edge);
        for (var i = 0; i < placed.Inputs.Count; i++)
            surface.Text(placed.Item.Inputs[i].NickName, new Spot(placed.Inputs[i].Right - 3, placed.Inputs[i].MiddleY + 3.5), 10, Side.End, Ink);
        for (var i = 0; i < placed.Outputs.Count; i++)
            surface.Text(placed.Item.Outputs[i].NickName, new Spot(placed.Outputs[i].X + 3, placed.Outputs[i].MiddleY + 3.5), 10, Side.Start, Ink);
        if (icon is not null) surface.Image(new Box(core.X, core.MiddleY - 12, 24, 24), icon);
        else surface.Rectangle(new Box(core.X + 4, core.Y + 2, 16, core.Height - 4), 3, Edge, Edge);
        surface.Text(placed.Item.Name, new Spot(box.MiddleX, box.Y - 3), 9, Side.Middle, "#5a5a5a");
    }

    private static void DrawPanel(ISurface surface, Placed placed, Results results)
    {
        var box = placed.Box;
        var note = placed.Item.NickName == "Read me";
        surface.Rectangle(box, 2, note ? "#ffffff" : Yellow, Edge);
        var top = box.Y;
        if (placed.Item.NickName.Length > 0 && placed.Item.NickName != "Panel")
        {
            surface.Text(placed.Item.NickName, new Spot(box.MiddleX, top + 11), 9, Side.Middle, "#5a5a5a", bold: true);
            top += Letters.PanelLine;
        }
        var lines = results.Panels.TryGetValue(placed.Item.Id, out var solved) ? solved : placed.Item.Text.Split('\n');
        var letters = (int)((box.Width - (placed.Item.Numbered ? 24 : 12)) / Letters.PanelLetter);
        for (var i = 0; i < lines.Count; i++)
        {
            if (placed.Item.Numbered && top + Letters.PanelLine < box.Bottom)
                surface.Text(i.ToString(CultureInfo.InvariantCulture), new Spot(box.X + 4, top + Letters.PanelLine - 2), 8, Side.Start, "#7a7a5a");
            foreach (var line in Wrapped.Lines(lines[i], letters))
            {
                top += Letters.PanelLine;
                if (top > box.Bottom - 1) return;
                surface.Text(line, new Spot(box.X + (placed.Item.Numbered ? 18 : 6), top - 2), 10, Side.Start, Ink, mono: true);
            }
        }
    }

    private static void DrawSlider(ISurface surface, Placed placed)
    {
        var (box, item) = (placed.Box, placed.Item);
        var name = Math.Min(Letters.Width(item.NickName) + 14, box.Width / 2);
        surface.Rectangle(box, 4, "#e6e6e6", Edge);
        surface.Rectangle(new Box(box.X, box.Y, name, box.Height), 4, "#4a4a4a", Edge);
        surface.Text(item.NickName, new Spot(box.X + name / 2, box.MiddleY + 3.5), 10, Side.Middle, "#ffffff");
        double from = box.X + name + 10, to = box.Right - 10, grip = from + (to - from) * Math.Min(1, Math.Max(0, item.Fraction));
        surface.Rectangle(new Box(from, box.MiddleY - 0.5, to - from, 1), 0, "#9a9a9a", "#9a9a9a");
        surface.Disc(new Spot(grip, box.MiddleY), 4, "#ffffff", Edge);
        var right = grip < (from + to) / 2;
        var width = Letters.Width(item.Text) + 6;
        surface.Rectangle(new Box(right ? to + 6 - width : from - 6, box.MiddleY - 7, width, 14), 0, "#e6e6e6", "#e6e6e6");
        surface.Text(item.Text, new Spot(right ? to + 4 : from - 4, box.MiddleY + 3.5), 10, right ? Side.End : Side.Start, Ink);
    }

    private static void DrawValue(ISurface surface, Placed placed)
    {
        var (box, item) = (placed.Box, placed.Item);
        var name = Math.Min(Letters.Width(item.NickName) + 14, box.Width / 2);
        surface.Rectangle(box, 4, Plain, Edge);
        var field = new Box(box.X + name, box.Y + 3, box.Width - name - 4, box.Height - 6);
        var dark = item.Look != Look.ValueList;
        surface.Rectangle(field, 2, dark ? "#3c3c3c" : "#ffffff", Edge);
        surface.Text(item.NickName, new Spot(box.X + name / 2, box.MiddleY + 3.5), 10, Side.Middle, Ink);
        surface.Text(item.Text, new Spot(field.MiddleX, field.MiddleY + 3.5), 10, Side.Middle, dark ? "#ffffff" : Ink);
        if (!dark) surface.Text("▾", new Spot(field.Right - 4, field.MiddleY + 4), 10, Side.End, Ink);
    }
}
