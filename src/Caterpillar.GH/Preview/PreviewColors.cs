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
    Width,
}

/// <summary>A color band for each printing move that is shown: roles, or sixteen steps of a number from its minimum to its maximum.</summary>
internal sealed class PreviewColors(byte[] bands, IReadOnlyList<Color> colors, IReadOnlyList<string> texts)
{
    /// <summary>The band of other moves.</summary>
    public const byte Hidden = byte.MaxValue;

    private const int Steps = 16;
    private const double NotPrinted = double.NegativeInfinity;

    /// <summary>The color of each band.</summary>
    public IReadOnlyList<Color> Colors => colors;

    /// <summary>Meaning of each band.</summary>
    public IReadOnlyList<string> Texts => texts;

    public int BandOf(int move) => bands[move];

    /// <summary>The value of each move for <see cref="Of"/>. The timeline is needed for times only.</summary>
    public static double[] ValuesOf(Toolpath toolpath, SceneParts parts, PreviewColor by, Timeline? timeline, CancellationToken cancel)
    {
        var values = new double[toolpath.Count];
        for (var i = 0; i < values.Length; i++) values[i] = NotPrinted;
        foreach (var block in parts.Blocks)
        {
            cancel.ThrowIfCancellationRequested();
            foreach (var move in block.Moves)
            {
                values[move] = by switch
                {
                    PreviewColor.Role => (int)block.Role,
                    PreviewColor.Layer => parts.Layers[move] == ShownLayers.None ? double.NaN : parts.Layers[move],
                    PreviewColor.Order => move,
                    PreviewColor.Time => timeline!.StartOf(move),
                    _ => ValueOf(toolpath, toolpath[move], by),
                };
            }
        }
        return values;
    }

    /// <summary>The colors of the moves of some layers.</summary>
    public static PreviewColors Of(double[] values, SceneParts parts, ShownLayers layers, PreviewColor by)
    {
        var bands = new byte[values.Length];
        var (least, greatest) = (double.PositiveInfinity, double.NegativeInfinity);
        var roles = new List<Role>();
        for (var i = 0; i < values.Length; i++)
        {
            bands[i] = Hidden;
            var value = values[i];
            if (value == NotPrinted || !layers.Has(parts.Layers[i])) continue;
            bands[i] = 0;
            if (by == PreviewColor.Role) bands[i] = BandOf(roles, (Role)value);
            else if (value < least) least = value;
            if (value > greatest) greatest = value;
        }
        if (by == PreviewColor.Role)
            return new PreviewColors(bands, roles.Select(r => RhinoGeometry.ToColor(Palette.Of(r))).ToArray(), roles.Select(r => r.ToString()).ToArray());
        if (!(greatest >= least)) (least, greatest) = (0, 0);
        // Computed values differ in their last digits.
        if (greatest - least < 1e-9 * Math.Abs(greatest)) greatest = least;
        var count = greatest > least ? Steps : 1;
        for (var i = 0; i < bands.Length && count > 1; i++)
        {
            if (bands[i] == 0 && values[i] > least) bands[i] = (byte)Math.Min((values[i] - least) / (greatest - least) * count, count - 1);
        }
        var colors = Enumerable.Range(0, count).Select(k => RhinoGeometry.ToColor(Palette.At(count == 1 ? 0.5 : (double)k / (count - 1)))).ToArray();
        var texts = Enumerable.Range(0, count).Select(k => Text(by, least + (greatest - least) * k / count, least + (greatest - least) * (k + 1) / count));
        return new PreviewColors(bands, colors, texts.ToArray());
    }

    private static byte BandOf(List<Role> roles, Role role)
    {
        var band = roles.IndexOf(role);
        if (band >= 0) return (byte)band;
        roles.Add(role);
        return (byte)(roles.Count - 1);
    }

    private static double ValueOf(Toolpath toolpath, in Move move, PreviewColor by) => by switch
    {
        PreviewColor.Speed => move.Speed,
        PreviewColor.Width => toolpath.BeadOf(move)?.Width(BeadShape.Stadium) ?? double.NaN,
        _ => move.Length > 0 && toolpath.VolumePerE(move.Tool) * move.Deposited is { } volume ? volume / move.Length * move.Speed : double.NaN,
    };

    private static string Text(PreviewColor by, double from, double to)
    {
        string N(double value, int decimals) => NumberFormatter.Format(value, decimals);
        return by switch
        {
            PreviewColor.Speed => $"{N(from, 1)} to {N(to, 1)} mm/s",
            PreviewColor.Flow => $"{N(from, 2)} to {N(to, 2)} mm³/s",
            PreviewColor.Width => $"{N(from, 3)} to {N(to, 3)} mm",
            PreviewColor.Layer => $"Layer {N(Math.Ceiling(from), 0)} to {N(Math.Floor(to), 0)}",
            PreviewColor.Order => $"Move {N(Math.Ceiling(from), 0)} to {N(Math.Floor(to), 0)}",
            _ => $"{N(from, 0)} to {N(to, 0)} s",
        };
    }
}
