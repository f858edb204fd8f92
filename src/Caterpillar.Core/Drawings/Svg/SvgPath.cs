namespace Caterpillar.Drawings;

/// <summary>
/// The data of an SVG path (SVG 1.1, section 8.3): all commands, absolute and relative. Subpaths are in user units with Y as in the file. Lines become
/// polylines, Béziers become NURBS curves, and elliptical arcs become arcs or NURBS curves (implementation notes F.6).
/// </summary>
internal sealed class SvgPath(string data)
{
    private readonly byte[] _text = Encoding.ASCII.GetBytes(data);
    private readonly List<Curve> _subpaths = [];
    private readonly List<Curve> _pieces = [];
    private readonly List<Vec3> _line = [];
    private int _at;
    private Vec3 _start;
    private Vec3 _here;
    private Vec3 _control;
    private char _last;

    /// <summary>The subpaths, or the error and its position in the text. Subpaths without length are counted.</summary>
    public static (IReadOnlyList<Curve> Subpaths, int Empty, string? Error, int At) Parse(string data)
    {
        var path = new SvgPath(data);
        try
        {
            path.Run();
            return (path._subpaths, path.Empty, null, path._at);
        }
        catch (FormatException e)
        {
            return ([], 0, e.Message, path._at);
        }
    }

    private int Empty { get; set; }

    private void Run()
    {
        Skip();
        if (_at < _text.Length && _text[_at] is not ((byte)'M' or (byte)'m')) throw new FormatException("Path data must begin with M.");
        for (; _at < _text.Length; Skip())
        {
            var command = (char)_text[_at];
            if (!IsCommand(command)) throw new FormatException("Expected a path command: M L H V C S Q T A or Z.");
            _at++;
            Repeat(command);
        }
        End(false);
    }

    private void Repeat(char command)
    {
        if (command is 'Z' or 'z')
        {
            Close();
            _last = 'Z';
            return;
        }
        for (var first = true; ; first = false)
        {
            if (!first)
            {
                Skip();
                if (_at >= _text.Length || !StartsNumber(_text[_at])) return;
                // Pairs after a move are lines.
                if (command == 'M') command = 'L';
                if (command == 'm') command = 'l';
            }
            One(command);
            _last = char.ToUpperInvariant(command);
        }
    }

    private void One(char command)
    {
        var relative = command >= 'a';
        var origin = relative ? _here : Vec3.Zero;
        switch (char.ToUpperInvariant(command))
        {
            case 'M':
                var to = Pair(origin);
                End(false);
                _start = _here = to;
                break;
            case 'L':
                LineTo(Pair(origin));
                break;
            case 'H':
                LineTo(new Vec3(Number() + origin.X, _here.Y));
                break;
            case 'V':
                LineTo(new Vec3(_here.X, Number() + origin.Y));
                break;
            case 'C':
                CurveTo(Pair(origin), Pair(origin), Pair(origin));
                break;
            case 'S':
                CurveTo(_last is 'C' or 'S' ? 2 * _here - _control : _here, Pair(origin), Pair(origin));
                break;
            case 'Q':
                QuadTo(Pair(origin), Pair(origin));
                break;
            case 'T':
                QuadTo(_last is 'Q' or 'T' ? 2 * _here - _control : _here, Pair(origin));
                break;
            default:
                ArcTo(Number(), Number(), Number(), Flag(), Flag(), Pair(origin));
                break;
        }
    }

    private void LineTo(Vec3 to)
    {
        if (_line.Count == 0) _line.Add(_here);
        if (to != _here) _line.Add(to);
        _here = to;
    }

    private void CurveTo(Vec3 a, Vec3 b, Vec3 to)
    {
        if (a != _here || b != _here || to != _here) Add(NurbsCurve.Clamped(3, [_here, a, b, to]));
        (_control, _here) = (b, to);
    }

    private void QuadTo(Vec3 control, Vec3 to)
    {
        if (control != _here || to != _here) Add(NurbsCurve.Clamped(2, [_here, control, to]));
        (_control, _here) = (control, to);
    }

    private void ArcTo(double rx, double ry, double rotation, bool large, bool positive, Vec3 to)
    {
        if (to == _here) return;
        (rx, ry) = (Math.Abs(rx), Math.Abs(ry));
        if (rx == 0 || ry == 0)
        {
            LineTo(to);
            return;
        }
        // F.6.5: to the frame of the ellipse, in which it is a unit circle.
        var (sin, cos) = Angle.SinCos(rotation);
        var half = 0.5 * (_here - to);
        var px = (cos * half.X + sin * half.Y) / rx;
        var py = (cos * half.Y - sin * half.X) / ry;
        var squared = px * px + py * py;
        if (squared > 1)
        {
            // Radii too small for the distance are scaled up (F.6.6).
            var grow = Math.Sqrt(squared);
            (rx, ry, px, py) = (rx * grow, ry * grow, px / grow, py / grow);
            squared = 1;
        }
        var offset = squared > 0 ? Math.Sqrt((1 - squared) / squared) : 0;
        if (large == positive) offset = -offset;
        var (cx, cy) = (offset * py, -offset * px);
        var from = Angle.Atan2(py - cy, px - cx);
        var sweep = Angle.Atan2(-py - cy, -px - cx) - from;
        if (positive && sweep <= 0) sweep += 360;
        if (!positive && sweep >= 0) sweep -= 360;
        var middle = 0.5 * (_here + to);
        var axisX = new Vec3(cos, sin) * rx;
        var axisY = new Vec3(-sin, cos) * ry;
        var (s, c) = Angle.SinCos(from);
        if (Math.Abs(sweep) > 360 || sweep == 0 || double.IsNaN(sweep) || double.IsNaN(cx + cy))
        {
            LineTo(to);
            return;
        }
        var unit = new ArcCurve(Frame.FromAxes(new Vec3(cx, cy), new Vec3(c, s), new Vec3(-s, c)), 1, sweep);
        var map = new Affine(axisX, axisY, Vec3.UnitZ, middle);
        // A circle keeps its frame exactly; its image under unequal radii is not a circle.
        Add(rx == ry ? new ArcCurve(Frame.FromAxes(map.Apply(unit.Center), map.ApplyDirection(unit.Frame.X), map.ApplyDirection(unit.Frame.Y)), rx, sweep)
            : unit.Transformed(map));
        _here = to;
    }

    private void Add(Curve piece)
    {
        Flush();
        _pieces.Add(piece);
    }

    private void Flush()
    {
        if (_line.Count > 1) _pieces.Add(new PolylineCurve(_line));
        _line.Clear();
    }

    private void Close()
    {
        if (_here != _start) LineTo(_start);
        End(true);
    }

    private void End(bool closed)
    {
        if (_pieces.Count == 0 && _line.Count > 1)
        {
            if (closed && _line.Count > 3 && _line[_line.Count - 1] == _line[0]) _line.RemoveAt(_line.Count - 1);
            else closed = false;
            _subpaths.Add(new PolylineCurve(_line, closed));
            _line.Clear();
            return;
        }
        if (_line.Count == 1 || closed) Empty += _pieces.Count == 0 ? 1 : 0;
        Flush();
        if (_pieces.Count == 1) _subpaths.Add(_pieces[0]);
        else if (_pieces.Count > 1) _subpaths.Add(new PolyCurve(_pieces, double.MaxValue));
        _pieces.Clear();
    }

    private static bool IsCommand(char c) => char.ToUpperInvariant(c) is 'M' or 'L' or 'H' or 'V' or 'C' or 'S' or 'Q' or 'T' or 'A' or 'Z';

    private static bool StartsNumber(byte c) => c is >= (byte)'0' and <= (byte)'9' or (byte)'-' or (byte)'+' or (byte)'.';

    private void Skip()
    {
        while (_at < _text.Length && (_text[_at] <= ' ' || _text[_at] == ',')) _at++;
    }

    private Vec3 Pair(Vec3 origin)
    {
        var x = Number();
        var y = Number();
        return new Vec3(origin.X + x, origin.Y + y);
    }

    private double Number()
    {
        Skip();
        var next = NumberReader.Scan(_text, _at, _text.Length, true, out var value);
        if (next == _at) throw new FormatException("Expected a number.");
        if (!(Math.Abs(value) <= 1e9)) throw new FormatException("A number is out of range.");
        _at = next;
        return value;
    }

    // 0 or 1, which need no separator after them.
    private bool Flag()
    {
        Skip();
        if (_at < _text.Length && (_text[_at] == 0x30 || _text[_at] == 0x31)) return _text[_at++] == '1';
        throw new FormatException("Expected a flag, 0 or 1.");
    }
}
