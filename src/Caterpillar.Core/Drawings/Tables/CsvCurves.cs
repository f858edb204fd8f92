namespace Caterpillar.Drawings;

/// <summary>
/// Points in rows: x, y and optionally z. Files with other columns start with a line of column names. Rows with another value in the column <c>curve</c>, or
/// after an empty line, begin a new curve. Lines with <c>#</c> are comments. Cells are separated by commas, semicolons, tabs or spaces. With any separator but
/// the comma, decimal commas are allowed.
/// </summary>
internal sealed class CsvCurves(CurveSource source)
{
    private const int MaxColumns = 64;

    private readonly byte[] _bytes = source.Bytes;
    private readonly List<double>?[] _values = new List<double>?[CurveColumns.Settings];
    private readonly int[] _starts = new int[MaxColumns];
    private readonly int[] _ends = new int[MaxColumns];
    private CurveColumn[]? _columns;
    private byte _delimiter;
    private readonly List<Vec3> _points = [];
    private byte _lineEnd;
    private int _curveLine;
    private int _line = 1;
    private int _lineStart;
    private int _keyStart;
    private int _keyEnd;

    // The values of the row at hand by column, as far as they are not settings of points.
    private readonly double?[] _row = new double?[(int)CurveColumn.Key];

    // Dots of the curve at hand by the number of their point.
    private readonly List<(int Point, double Volume)> _dots = [];

    public static void Read(CurveSource source) => new CsvCurves(source).ReadAll();

    private void ReadAll()
    {
        _lineEnd = Array.IndexOf(_bytes, (byte)'\n') < 0 ? (byte)'\r' : (byte)'\n';
        for (var at = ByteOrderMark.Length(_bytes); at < _bytes.Length; _line++)
        {
            if ((_line & 0x3FFF) == 0) source.Pulse(at, _bytes.Length);
            _lineStart = at;
            if (_columns is { Length: 3 } && TryPoint(ref at)) continue;
            var end = Array.IndexOf(_bytes, _lineEnd, at);
            if (end < 0) end = _bytes.Length;
            at = end + 1;
            if (!ReadLine(_lineStart, end)) return;
        }
        EndCurve();
    }

    private bool ReadLine(int start, int end)
    {
        while (start < end && _bytes[start] <= ' ' && _bytes[start] != '\t') start++;
        while (end > start && _bytes[end - 1] <= ' ' && _bytes[end - 1] != '\t') end--;
        if (start == end)
        {
            EndCurve();
            return true;
        }
        if (_bytes[start] == '#') return true;
        if (_delimiter == 0) _delimiter = DelimiterOf(start, end);
        var cells = Cells(start, end);
        if (cells < 0) return Fail("curves.csv", "A row has more than 64 cells.", start);
        if (_columns is null)
        {
            if (!Names(cells)) return !source.Diagnostics.HasErrors;
        }
        return Row(cells);
    }

    // The row of most files, three plain numbers, without a look for its end and its cells; any other is read as usual.
    private bool TryPoint(ref int start)
    {
        if (!(_columns![0] == CurveColumn.X && _columns[1] == CurveColumn.Y && _columns[2] == CurveColumn.Z)) return false;
        var at = start;
        if (!TryCell(ref at, _delimiter, out var x) || !TryCell(ref at, _delimiter, out var y) || !TryCell(ref at, _lineEnd, out var z)) return false;
        start = at;
        Add(x, y, z);
        return true;
    }

    private bool TryCell(ref int at, byte after, out double value)
    {
        var end = NumberReader.Scan(_bytes, at, _bytes.Length, true, out value);
        if (end == at || double.IsInfinity(value)) return false;
        if (after == '\n' && end < _bytes.Length && _bytes[end] == '\r') end++;
        if (end < _bytes.Length ? _bytes[end] != after : after != _lineEnd) return false;
        at = end + 1;
        return true;
    }

    private void Add(double x, double y, double z)
    {
        if (_points.Count == 0) _curveLine = _line;
        var unit = source.Options.UnitLength;
        _points.Add(new Vec3(x * unit, y * unit, z * unit));
    }

    // True if the row already holds values: then the columns are x, y and z.
    private bool Names(int cells)
    {
        var words = false;
        for (var i = 0; i < cells; i++) words |= !TryNumber(i, out _, out _);
        if (!words)
        {
            if (cells is not (2 or 3))
                return Fail("curves.csv", "Expected rows of x, y and z. Other columns need a first line with their names, for example x,y,z,width,speed.",
                    _starts[0]);
            _columns = cells == 2 ? [CurveColumn.X, CurveColumn.Y] : [CurveColumn.X, CurveColumn.Y, CurveColumn.Z];
            return true;
        }
        _columns = new CurveColumn[cells];
        var seen = new bool[(int)CurveColumn.Key + 1];
        for (var i = 0; i < cells; i++)
        {
            var name = Cell(i);
            var column = CurveColumns.Of(name);
            _columns[i] = column;
            if (column == CurveColumn.Ignored)
            {
                source.Diagnostics.Add(Severity.Warning, "curves.ignored", $"Unknown column \"{Short(name)}\" is ignored.", At(_starts[i]));
                continue;
            }
            if (seen[(int)column]) return Fail("curves.csv", $"The column \"{Short(name)}\" occurs twice.", _starts[i]);
            seen[(int)column] = true;
            var setting = column - CurveColumn.Area;
            if (setting is >= 0 and < CurveColumns.Settings) _values[setting] = [];
        }
        return seen[(int)CurveColumn.X] && seen[(int)CurveColumn.Y] ? false
            : Fail("curves.csv", "The first line must contain numbers, or the column names x and y.", _starts[0]);
    }

    private bool Row(int cells)
    {
        var columns = _columns!;
        if (cells != columns.Length)
            return Fail("curves.csv", $"The row has {NumberFormatter.Format(cells)} cells instead of {NumberFormatter.Format(columns.Length)}.", _starts[0]);
        var key = Array.IndexOf(columns, CurveColumn.Key);
        if (key >= 0 && !SameKey(_starts[key], _ends[key])) EndCurve();
        if (_points.Count == 0)
        {
            _curveLine = _line;
            (_keyStart, _keyEnd) = key >= 0 ? (_starts[key], _ends[key]) : (0, 0);
        }
        for (var i = 0; i < cells; i++)
        {
            var column = columns[i];
            if (column is CurveColumn.Key or CurveColumn.Ignored) continue;
            if (!TryNumber(i, out var value, out var percent)) return Fail("curves.number", $"\"{Short(Cell(i))}\" is not a number.", _starts[i]);
            if (double.IsNaN(value - value)) return Fail("curves.not_finite", "Values must be finite.", _starts[i]);
            if (percent && !Resolve(column, ref value)) return Fail("curves.percent", CurveColumns.NoPercentage, _starts[i]);
            if (column > CurveColumn.Z && value < 0 && column != CurveColumn.Layer) return Fail("curves.bead", CurveColumns.Negative, _starts[i]);
            if (column - CurveColumn.Area is >= 0 and < CurveColumns.Settings and var setting) _values[setting]!.Add(value);
            else if (column != CurveColumn.Dot) _row[(int)column] = value;
            else if (value > 0) _dots.Add((_points.Count, value));
        }
        if (Given(CurveColumn.Tool) is > 1000 || Given(CurveColumn.Layer) is > 1e8 or < -1e8)
            return Fail("curves.number", "The tool or layer number is out of range.", _starts[0]);
        Add(Given(CurveColumn.X) ?? 0, Given(CurveColumn.Y) ?? 0, Given(CurveColumn.Z) ?? 0);
        return true;
    }

    private double? Given(CurveColumn column) => _row[(int)column];

    private void EndCurve()
    {
        if (_points.Count == 0) return;
        var points = _points.ToArray();
        var columns = Array.ConvertAll(_values, v => v?.ToArray());
        foreach (var column in _values) column?.Clear();
        _points.Clear();
        if (_dots.Count == 0)
        {
            Add(points, columns, 0);
            return;
        }
        // The curve is drawn from dot to dot.
        var from = 0;
        var volume = 0.0;
        foreach (var (at, next) in _dots)
        {
            if (at > from) Add(Part(points, from, at), Array.ConvertAll(columns, c => c is null ? null : Part(c, from, at)), volume);
            (from, volume) = (at, next);
        }
        _dots.Clear();
        var last = points.Length - 1;
        if (from < last) Add(Part(points, from, last), Array.ConvertAll(columns, c => c is null ? null : Part(c, from, last)), volume);
        else source.Curves.Add(With(UserCurve.DotAt(points[last], volume)));
    }

    private static T[] Part<T>(T[] values, int from, int to) => new ArraySegment<T>(values, from, to - from + 1).ToArray();

    private void Add(Vec3[] points, double[]?[] columns, double dot)
    {
        if (dot > 0 && Array.TrueForAll(points, p => p == points[0]))
        {
            source.Curves.Add(With(UserCurve.DotAt(points[0], dot)));
            return;
        }
        var curve = source.Polyline(points, false, source.Place(_curveLine), out var endDropped);
        if (curve is null) return;
        if (endDropped) columns = CurveColumns.Shortened(columns, points.Length - 1);
        source.Curves.Add(CurveColumns.WithValues(With(new UserCurve(curve) { Dot = dot }), columns));
    }

    private UserCurve With(UserCurve curve) => curve with
    {
        Name = Encoding.UTF8.GetString(_bytes, _keyStart, _keyEnd - _keyStart).Trim('"', '\''),
        Flow = Given(CurveColumn.Flow),
        Tool = (int)(Given(CurveColumn.Tool) ?? 0),
        Layer = Given(CurveColumn.Layer) is { } layer ? new Layer((int)layer, curve.Curve.Bounds.Max.Z) : null,
        Source = source.Place(_curveLine),
    };

    private bool SameKey(int start, int end)
    {
        if (_points.Count == 0) return true;
        if (end - start != _keyEnd - _keyStart) return false;
        for (var i = 0; i < end - start; i++)
        {
            if (_bytes[start + i] != _bytes[_keyStart + i]) return false;
        }
        return true;
    }

    private byte DelimiterOf(int start, int end) => (byte)";\t, ".First(c => c == ' ' || Array.IndexOf(_bytes, (byte)c, start, end - start) >= 0);

    private int Cells(int start, int end)
    {
        var count = 0;
        for (var at = start; ;)
        {
            while (at < end && (_bytes[at] == ' ' || (_bytes[at] <= ' ' && _bytes[at] != _delimiter))) at++;
            if (_delimiter == ' ' && at >= end) return count;
            if (count == MaxColumns) return -1;
            var from = at;
            var quote = at < end && _bytes[at] == '"';
            if (quote)
            {
                var close = Array.IndexOf(_bytes, (byte)'"', at + 1, end - at - 1);
                at = close < 0 ? end : close + 1;
            }
            while (at < end && (_delimiter == ' ' ? _bytes[at] > ' ' : _bytes[at] != _delimiter)) at++;
            var to = at;
            while (to > from && _bytes[to - 1] <= ' ') to--;
            if (quote && to - from >= 2 && _bytes[to - 1] == '"') (from, to) = (from + 1, to - 1);
            _starts[count] = from;
            _ends[count++] = to;
            if (at >= end) return count;
            at++;
        }
    }

    private bool TryNumber(int cell, out double value, out bool percent)
    {
        var (start, end) = (_starts[cell], _ends[cell]);
        percent = end > start && _bytes[end - 1] == '%';
        if (percent)
        {
            end--;
            while (end > start && _bytes[end - 1] == ' ') end--;
        }
        if (NumberReader.TryParse(_bytes, start, end, out value)) return true;
        if (_delimiter != ',' && DecimalComma(start, end, out value)) return true;
        return NotFinite(start, end, out value);
    }

    private bool DecimalComma(int start, int end, out double value)
    {
        value = 0;
        var comma = Array.IndexOf(_bytes, (byte)',', start, end - start);
        if (comma < 0 || Array.IndexOf(_bytes, (byte)',', comma + 1, end - comma - 1) >= 0 || Array.IndexOf(_bytes, (byte)'.', start, end - start) >= 0)
            return false;
        var copy = Part(_bytes, start, end - 1);
        copy[comma - start] = (byte)'.';
        return NumberReader.TryParse(copy, 0, copy.Length, out value);
    }

    // "nan" and "inf" differ from words: they are values, but invalid ones.
    private bool NotFinite(int start, int end, out double value)
    {
        value = double.NaN;
        var text = end - start is >= 3 and <= 9 ? Encoding.ASCII.GetString(_bytes, start, end - start).TrimStart('+', '-').ToUpperInvariant() : "";
        return text is "NAN" or "INF" or "INFINITY" || NumberReader.Scan(_bytes, start, end, true, out _) == end && end > start;
    }

    private bool Resolve(CurveColumn column, ref double value)
    {
        var reference = CurveColumns.Whole(column, source.Options);
        value = value / 100 * reference;
        return reference > 0;
    }

    private string Cell(int cell) => Encoding.UTF8.GetString(_bytes, _starts[cell], _ends[cell] - _starts[cell]);

    private static string Short(string text) => text.Length > 30 ? text.Substring(0, 30) + "…" : text;

    private SourceLocation At(int offset) => source.Place(_line, offset - _lineStart + 1);

    private bool Fail(string code, string message, int offset) => source.Fail(code, message, At(offset));
}
