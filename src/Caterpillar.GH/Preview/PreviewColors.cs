using System.Drawing;
using Caterpillar.Display;
using Caterpillar.GH.Conversion;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;

namespace Caterpillar.GH.Preview;

/// <summary>Value shown by the colors.</summary>
public enum PreviewColor
{
    Role,
    Speed,
    Flow,
    Layer,
    Order,
    Time,
}

/// <summary>A color band for each visible move: roles, or sixteen steps of a number from its minimum to its maximum.</summary>
internal sealed class PreviewColors
{
    private const int Steps = 16;
    private readonly byte[] _bands;

    private PreviewColors(byte[] bands, IReadOnlyList<Color> colors, IReadOnlyList<string> texts)
    {
        _bands = bands;
        Colors = colors;
        Texts = texts;
    }

    /// <summary>The color of each band.</summary>
    public IReadOnlyList<Color> Colors { get; }

    /// <summary>Meaning of each band.</summary>
    public IReadOnlyList<string> Texts { get; }

    public int BandOf(int move) => _bands[move];

    /// <param name="toolpath">The moves.</param>
    /// <param name="shown">Whether a move is shown.</param>
    /// <param name="by">What the colors show.</param>
    /// <param name="timeline">When the moves happen. Needed for times only.</param>
    public static PreviewColors Of(Toolpath toolpath, Func<int, bool> shown, PreviewColor by, Timeline? timeline)
    {
        if (by == PreviewColor.Role) return OfRoles(toolpath, shown);
        var values = new double[toolpath.Count];
        var (least, greatest) = (double.PositiveInfinity, double.NegativeInfinity);
        for (var i = 0; i < values.Length; i++)
        {
            if (!shown(i)) continue;
            values[i] = Value(toolpath, i, by, timeline);
            if (double.IsNaN(values[i])) continue;
            least = Math.Min(least, values[i]);
            greatest = Math.Max(greatest, values[i]);
        }
        if (!(greatest >= least)) (least, greatest) = (0, 0);
        var count = greatest > least ? Steps : 1;
        var bands = new byte[values.Length];
        for (var i = 0; i < bands.Length; i++)
            bands[i] = greatest > least && values[i] > least ? (byte)Math.Min((values[i] - least) / (greatest - least) * count, count - 1) : (byte)0;
        var colors = Enumerable.Range(0, count).Select(k => RhinoGeometry.ToColor(Palette.At(count == 1 ? 0.5 : (double)k / (count - 1)))).ToArray();
        var texts = Enumerable.Range(0, count).Select(k => Text(by, least + (greatest - least) * k / count, least + (greatest - least) * (k + 1) / count));
        return new PreviewColors(bands, colors, texts.ToArray());
    }

    private static PreviewColors OfRoles(Toolpath toolpath, Func<int, bool> shown)
    {
        var roles = new List<Role>();
        var bands = new byte[toolpath.Count];
        for (var i = 0; i < bands.Length; i++)
        {
            if (!shown(i)) continue;
            var role = toolpath[i].Role;
            var band = roles.IndexOf(role);
            if (band < 0)
            {
                band = roles.Count;
                roles.Add(role);
            }
            bands[i] = (byte)band;
        }
        return new PreviewColors(bands, roles.Select(r => RhinoGeometry.ToColor(Palette.Of(r))).ToArray(), roles.Select(r => r.ToString()).ToArray());
    }

    private static double Value(Toolpath toolpath, int i, PreviewColor by, Timeline? timeline)
    {
        var move = toolpath[i];
        return by switch
        {
            PreviewColor.Speed => move.Speed,
            PreviewColor.Flow => move.Length > 0 && toolpath.VolumeOf(move) is { } volume ? volume / move.Length * move.Speed : double.NaN,
            PreviewColor.Layer => toolpath.NumberOfLayer(move) ?? double.NaN,
            PreviewColor.Order => i,
            _ => timeline!.StartOf(i),
        };
    }

    private static string Text(PreviewColor by, double from, double to)
    {
        string N(double value, int decimals) => NumberFormatter.Format(value, decimals);
        return by switch
        {
            PreviewColor.Speed => $"{N(from, 1)} to {N(to, 1)} mm/s",
            PreviewColor.Flow => $"{N(from, 2)} to {N(to, 2)} mm³/s",
            PreviewColor.Layer => $"Layer {N(Math.Ceiling(from), 0)} to {N(Math.Floor(to), 0)}",
            PreviewColor.Order => $"Move {N(Math.Ceiling(from), 0)} to {N(Math.Floor(to), 0)}",
            _ => $"{N(from, 0)} to {N(to, 0)} s",
        };
    }
}
