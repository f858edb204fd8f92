using System.Collections;

namespace Caterpillar.GCode;

/// <summary>
/// The comments of a document that have blocks of their own in binary G-code: producer, printer metadata, thumbnails, settings. The G-code does not contain
/// their lines.
/// </summary>
internal sealed class BinaryTables(int lines)
{
    private const string Begin = "begin", End = "end";

    // Keys of PrusaSlicer, in its order.
    private static readonly string[] PrinterKeys = Keys("printer"), PrintKeys = Keys("print");

    private readonly BitArray _held = new BitArray(lines);
    private readonly BitArray _blank = new BitArray(lines);
    private readonly List<int> _pending = [];
    private readonly SortedDictionary<string, string> _known = new(StringComparer.Ordinal);
    private readonly HashSet<string> _keys = new(PrinterKeys.Concat(PrintKeys), StringComparer.Ordinal);
    private readonly List<KeyValuePair<string, string>> _file = [];
    private readonly List<KeyValuePair<string, string>> _settings = [];
    private readonly List<(Thumbnail, byte[])> _images = [];

    // What an open block collects: lines of settings, of JSON, or an image.
    private readonly List<string> _lines = [];
    private string? _open;
    private Thumbnail? _image;
    private bool _afterImage;
    private int _empty = -1;

    public IReadOnlyList<KeyValuePair<string, string>> File => _file;

    public IReadOnlyList<KeyValuePair<string, string>> Settings => _settings;

    public IReadOnlyList<(Thumbnail ToolpathImage, byte[] Data)> Images => _images;

    public byte[]? Json { get; private set; }

    public IReadOnlyList<KeyValuePair<string, string>> Printer => Table(PrinterKeys);

    public IReadOnlyList<KeyValuePair<string, string>> Print => Table(PrintKeys);

    /// <summary>True for a line (from 0) of a table or a thumbnail.</summary>
    public bool Holds(int line) => _held[line];

    public static BinaryTables Of(GCodeDocument document, CancellationToken cancel)
    {
        var tables = new BinaryTables(document.LineCount);
        var line = 0;
        foreach (var chunk in document.Chunks)
        {
            cancel.ThrowIfCancellationRequested();
            var starts = chunk.LineStarts();
            for (var k = 0; k + 1 < starts.Length; k++, line++)
            {
                var start = starts[k] + (line == 0 ? TextEncoding.MarkLength(chunk) : 0);
                var end = LineEnds.Find(chunk.Text, start, starts[k + 1]);
                if (end == start) tables._blank[line] = true;
                else if (chunk.Text[start] == ';') tables.Comment(TextEncoding.Decode(chunk.Text, start + 1, end).Trim(' ', '\t'), line);
                else tables.Code();
            }
        }
        tables.HoldBlankEnds();
        return tables;
    }

    private static string[] Keys(string table) => [.. EmbeddedText.Rows("comments/BinaryKeys.tsv").Where(r => r[0] == table).Select(r => r[1])];

    // Empty lines at both ends are what readers put between the tables.
    private void HoldBlankEnds()
    {
        var first = 0;
        for (; first < _held.Count && (_held[first] || _blank[first]); first++) _held[first] = true;
        for (var last = _held.Count - 1; last > first && (_held[last] || _blank[last]); last--) _held[last] = true;
    }

    private List<KeyValuePair<string, string>> Table(string[] keys)
    {
        var table = new List<KeyValuePair<string, string>>();
        foreach (var key in keys)
        {
            if (_known.TryGetValue(key, out var value)) table.Add(new KeyValuePair<string, string>(key, value));
            else if (key.IndexOf(" ", StringComparison.Ordinal) < 0 && _settings.Find(s => s.Key == key) is { Key: not null } setting) table.Add(setting);
        }
        return table;
    }

    private void Code()
    {
        _open = null;
        _empty = -1;
        _afterImage = false;
    }

    private void Comment(string text, int line)
    {
        if (_open is not null)
        {
            Inside(text, line);
            return;
        }
        var after = _afterImage;
        var empty = _empty;
        _afterImage = false;
        _empty = -1;
        if (text.Length == 0)
        {
            // The empty comments before and after an image.
            if (after) _held[line] = true;
            else _empty = line;
        }
        else if (Thumbnail.Read(text) is { Format: "PNG" or "JPG" or "QOI" } image)
        {
            Enter("thumbnail", image, line);
            if (empty >= 0) _pending.Add(empty);
        }
        else if (Setting(text, out var key, out var value))
        {
            Known(key, value, line);
        }
        else
        {
            Made(text, line);
        }
    }

    private void Known(string key, string value, int line)
    {
        if (value == Begin && (key is "prusaslicer_config" or "prusaslicer_json_config" or BinaryComments.SetupBlock))
        {
            Enter(key, null, line);
            return;
        }
        if (!_keys.Contains(key) || value.Length == 0) return;
        if (!_known.TryGetValue(key, out var first)) _known.Add(key, first = value);
        // Another value is no part of the table.
        if (first == value) _held[line] = true;
    }

    private void Made(string text, int line)
    {
        const string Generated = "generated by ", Prepared = "prepared by ";
        if (text.StartsWith(Generated, StringComparison.Ordinal) && _file.Count == 0)
        {
            var producer = text.Substring(Generated.Length);
            var on = producer.IndexOf(" on ", StringComparison.Ordinal);
            _file.Add(new KeyValuePair<string, string>("Producer", on < 0 ? producer : producer.Substring(0, on)));
            if (on >= 0) _file.Add(new KeyValuePair<string, string>("Produced on", producer.Substring(on + 4)));
            _held[line] = true;
        }
        else if (text.StartsWith(Prepared, StringComparison.Ordinal) && _file.Count is 1 or 2 && line < 5 && _file[_file.Count - 1].Key != "Prepared by")
        {
            _file.Add(new KeyValuePair<string, string>("Prepared by", text.Substring(Prepared.Length)));
            _held[line] = true;
        }
    }

    private void Enter(string what, Thumbnail? image, int line)
    {
        _open = what;
        _image = image;
        _lines.Clear();
        _pending.Clear();
        _pending.Add(line);
    }

    private void Inside(string text, int line)
    {
        _pending.Add(line);
        var ends = _image is not null
            ? text.StartsWith("thumbnail", StringComparison.Ordinal) && text.EndsWith(" " + End, StringComparison.Ordinal)
            : Setting(text, out var key, out var value) && key == _open && value == End;
        if (!ends)
        {
            _lines.Add(text);
            return;
        }
        // What fits into no table stays a comment.
        if (Close())
        {
            foreach (var taken in _pending) _held[taken] = true;
            _afterImage = _image is not null;
        }
        _open = null;
    }

    private bool Close()
    {
        if (_image is not null)
        {
            try
            {
                var data = Convert.FromBase64String(string.Concat(_lines));
                if (data.Length == 0 || _image.Width == 0 || _image.Height == 0) return false;
                _images.Add((_image, data));
                return true;
            }
            catch (FormatException)
            {
                return false;
            }
        }
        if (_open == "prusaslicer_json_config")
        {
            if (Json is not null) return false;
            Json = TextEncoding.Encode(string.Join("\n", _lines));
            return true;
        }
        if (_settings.Count > 0) return false;
        foreach (var text in _lines)
        {
            if (!Setting(text, out var key, out var value)) return false;
            _settings.Add(new KeyValuePair<string, string>(key, value));
        }
        return true;
    }

    private static bool Setting(string text, out string key, out string value)
    {
        var equals = text.IndexOf("=", StringComparison.Ordinal);
        key = equals > 0 ? text.Substring(0, equals).Trim() : "";
        value = equals > 0 ? text.Substring(equals + 1).Trim() : "";
        return key.Length > 0;
    }
}
