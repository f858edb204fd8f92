namespace Caterpillar.GCode;

/// <summary>
/// Updates heights and widths in comments (<c>;Z:</c>, <c>;HEIGHT:</c>, <c>;WIDTH:</c> and similar) after an edit that scales or raises extrusions. A width
/// comment gets the width of the first extrusion after it.
/// </summary>
internal sealed class CommentScale
{
    private const double NoChange = 1e-6;
    private const int LongestComment = 120;

    private readonly Toolpath _before;
    private readonly Toolpath _after;
    private MoveCursor _old;
    private MoveCursor _new;
    private bool _afterChange;

    public CommentScale(Toolpath before, Toolpath after)
    {
        (_before, _after) = (before, after);
        (_old, _new) = (new MoveCursor(before), new MoveCursor(after));
        IsActive = !ReferenceEquals(before, after) && before.Layers.Count == after.Layers.Count;
        for (var i = 0; IsActive && i < before.Layers.Count; i++) ChangesLayers |= before.Layers[i] != after.Layers[i];
    }

    /// <summary>True if comments may change.</summary>
    public bool IsActive { get; }

    /// <summary>True if the heights of layers change.</summary>
    public bool ChangesLayers { get; }

    /// <summary>Continues with other moves of the file, and what became of them.</summary>
    public void Continue(Toolpath before, Toolpath after) => (_old, _new) = (new MoveCursor(before), new MoveCursor(after));

    /// <summary>The new text of a comment on a line of its own.</summary>
    public FileLine Image(FileLine line, int number)
    {
        if (!IsActive || line.End - line.Start is < 2 or > LongestComment || !MayChange(line)) return line;
        var text = TextEncoding.Decode(line.Text, line.Start, line.End);
        var changed = Changed(text, number);
        return changed == text ? line : line.WithText(TextEncoding.Encode(changed));
    }

    // PrusaSlicer's ;BEFORE_LAYER_CHANGE and ;AFTER_LAYER_CHANGE are followed by the bare height.
    private string Changed(string text, int number)
    {
        var bare = _afterChange;
        _afterChange = text is ";BEFORE_LAYER_CHANGE" or ";AFTER_LAYER_CHANGE";
        if (ExtrusionAfter(number, _old) is not { } extrusion) return text;
        var layer = extrusion.Layer >= 0 ? (Before: _before.Layers[extrusion.Layer], After: _after.Layers[extrusion.Layer]) : default;
        if (layer.Before is not null && !IsSame(layer.Before, layer.After))
        {
            double Z(double z) => NewZ(z, layer.Before, layer.After);
            double Height(double h) => h * Ratio(layer.Before, layer.After);
            if (Has(text, "Z")) text = Replace(text, Patterns.Height, Z);
            if (Has(text, ", Z = ")) text = Replace(text, Patterns.NumberedHeight, Z);
            if (Has(text, "BEGIN_LAYER_OBJECT")) text = Replace(text, Patterns.ObjectHeight, Z);
            if (bare) text = Replace(text, Patterns.BareHeight, Z);
            if (Has(text, "HEIGHT:")) text = Replace(text, Patterns.Thickness, Height);
            if (Has(text, "BEGIN_LAYER_OBJECT")) text = Replace(text, Patterns.ObjectThickness, Height);
        }
        if (!Has(text, "WIDTH:")) return text;
        var factor = WidthFactor(extrusion, number, layer.Before is null ? 1 : Ratio(layer.Before, layer.After));
        return factor == 1 ? text : Replace(text, Patterns.Width, w => w * factor);
    }

    private static Move? ExtrusionAfter(int line, MoveCursor moves)
    {
        moves.SkipTo(line + 1);
        while (moves.Valid && (moves.Columns.Kind[moves.Index] != MoveKind.Print || moves.Source <= line)) moves.Next();
        return moves.Valid ? moves.Toolpath[moves.Number] : null;
    }

    // Most edits keep most heights, and most comments have none: patterns are slow.
    private static bool Has(string text, string word) => text.IndexOf(word, StringComparison.Ordinal) >= 0;

    private static bool IsSame(Layer before, Layer after) => before.Z == after.Z && Math.Abs(Ratio(before, after) - 1) <= 1e-15;

    private static double NewZ(double z, Layer before, Layer after)
        => Math.Abs(Ratio(before, after) - 1) <= NoChange || !(before.Z > 0) ? z + after.Z - before.Z : z * after.Z / before.Z;

    private static double Ratio(Layer before, Layer after) => before.Thickness > 0 && after.Thickness > 0 ? after.Thickness / before.Thickness : 1;

    // From the areas of the extrusion before and after; 1 where only its material was changed.
    private double WidthFactor(Move before, int number, double height)
    {
        if (ExtrusionAfter(number, _new) is not { } after || after.Source != before.Source) return 1;
        double was = before.Length, now = after.Length;
        if (!(was > 0 && now > 0 && before.Deposited > 0 && after.Deposited > 0)) return 1;
        if (Math.Abs(now / was - 1) <= NoChange && Math.Abs(height - 1) <= NoChange && !ChangesLayers) return 1;
        return after.Deposited / now / (before.Deposited / was) / height;
    }

    private static string Replace(string text, Regex pattern, Func<double, double> map)
    {
        var match = pattern.Match(text);
        if (!match.Success || !NumberReader.TryParse(match.Groups[1].Value, out var value)) return text;
        var mapped = map(value);
        if (!(Math.Abs(mapped - value) > NoChange) || !(Math.Abs(mapped) < 1e9)) return text;
        return text.Substring(0, match.Groups[1].Index) + NumberFormatter.Format(mapped, 6) + text.Substring(match.Groups[1].Index + match.Groups[1].Length);
    }

    // A quick look: the letters with which such comments begin.
    private bool MayChange(FileLine line)
    {
        var at = line.Start;
        while (at < line.End && line.Text[at] is (byte)' ' or (byte)';') at++;
        if (at == line.End) return false;
        return line.Text[at] is (byte)'Z' or (byte)'H' or (byte)'W' or (byte)'L' or (byte)'l' or (byte)'B' or (byte)'A' || _afterChange;
    }

    // Apart, so that they are made when they are needed first.
    private static class Patterns
    {
        private const string Number = @"(-?\d*\.?\d+)\s*$";
        public static readonly Regex Height = new(@"^;\s*(?:Z|Z_HEIGHT):\s*" + Number, RegexOptions.CultureInvariant);
        public static readonly Regex Thickness = new(@"^;\s*(?:HEIGHT|LAYER_HEIGHT):\s*" + Number, RegexOptions.CultureInvariant);
        public static readonly Regex Width = new(@"^;\s*(?:WIDTH|LINE_WIDTH):\s*" + Number, RegexOptions.CultureInvariant);
        public static readonly Regex NumberedHeight = new(@"^;\s*(?:layer|Layer|LAYER) -?\d+, Z = " + Number, RegexOptions.CultureInvariant);
        public static readonly Regex ObjectHeight = new(@"^;\s*BEGIN_LAYER_OBJECT.* z=(-?\d*\.?\d+)", RegexOptions.CultureInvariant);
        public static readonly Regex ObjectThickness = new(@"^;\s*BEGIN_LAYER_OBJECT.* z_thickness=(-?\d*\.?\d+)", RegexOptions.CultureInvariant);
        public static readonly Regex BareHeight = new("^;" + Number, RegexOptions.CultureInvariant);
    }
}
