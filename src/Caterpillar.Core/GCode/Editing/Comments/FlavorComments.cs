namespace Caterpillar.GCode;

/// <summary>Changes comments that name the G-code flavor in a conversion, so that the result is read in its new flavor.</summary>
internal sealed class FlavorComments
{
    private const int LongestComment = 200;
    private static readonly Regex Flavor =
        new(@"^(;FLAVOR:|; Flavor |;?\s*(?:machine_)?gcode_flavor = )(\S.*)$", RegexOptions.CultureInvariant);

    private readonly FlavorRules? _target;

    public FlavorComments(DecodedGCode decoding, ConvertTarget? target)
    {
        if (target is null || target.Flavor.Name == decoding.Flavor.Name) return;
        _target = target.Flavor;
        var chunks = decoding.Document!.Chunks;
        if (!FlavorDetector.IsStated(chunks) && FlavorDetector.Detect(chunks, decoding.Axis).Flavor.Name != _target.Name)
            Statement = "; Flavor " + _target.Name;
    }

    /// <summary>A first line that names the flavor if no other comment does. Otherwise null.</summary>
    public string? Statement { get; }

    /// <summary>The new text of a comment.</summary>
    public FileLine Image(FileLine line)
    {
        if (_target is null || line.End - line.Start is < 8 or > LongestComment || line.Text[line.Start] is not ((byte)';' or (byte)' ')) return line;
        var text = TextEncoding.Decode(line.Text, line.Start, line.End);
        var changed = text;
        var match = Flavor.Match(text);
        if (match.Success && FlavorDetector.OfSlicerFlavor(match.Groups[2].Value) is not null) changed = match.Groups[1].Value + Name(match.Groups[1].Value);
        else if (_target.Name != FlavorTable.Bambu.Name && text.IndexOf("BambuStudio", StringComparison.Ordinal) is >= 0 and var at)
            changed = text.Insert(at + "Bambu".Length, " ");
        return changed == text ? line : line.WithText(TextEncoding.Encode(changed));
    }

    // Slicers' "marlin" is Marlin 1, Cura's is Marlin 2.
    private string Name(string key)
        => key[1] == 'F' ? (_target!.Name == FlavorTable.Marlin2.Name ? "Marlin" : _target.Name)
            : _target!.Name == FlavorTable.Marlin1.Name && key[2] != 'F' ? "marlin" : _target.Name;
}
