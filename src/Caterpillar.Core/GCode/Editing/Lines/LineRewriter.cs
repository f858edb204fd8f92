namespace Caterpillar.GCode;

/// <summary>Changes words of a line in place, in the style of its file, so that it makes a move from a given state.</summary>
internal sealed class LineRewriter(LineStyle style, FlavorRules rules, ExtrusionAxis axis, ExtrusionAxis source)
{
    private const double NoChange = InterpreterState.NoChange;

    // Of words. Others come before F.
    private static readonly byte[] UsualOrder = Encoding.ASCII.GetBytes("GXYZIJKRP F");
    private readonly byte _extruder = axis.FirstLetter;
    private readonly List<Edit> _edits = [];
    private ParsedLine _line = new();
    private byte[] _out = new byte[256];

    public byte[] Bytes => _out;

    public int Count { get; private set; }

    /// <summary>
    /// Makes a scanned line do a move. <paramref name="command"/> is the G number of a straight move, or −1 for the G number of the line.
    /// <paramref name="carried"/> is the rounding error of E.
    /// </summary>
    public void Rewrite(ParsedLine line, FileLine bytes, TargetMove move, InterpreterState state, int command, double carried)
    {
        _line = line;
        _edits.Clear();
        var text = bytes.Text;
        var head = state.Head;
        var relative = state.Modes.Relative;
        var unit = state.Modes.Unit;
        Motion(move, state, command);
        Axis(text, 'X', move.X - head.ShiftX, head.X, unit, relative);
        Axis(text, 'Y', move.Y - head.ShiftY, head.Y, unit, relative);
        Axis(text, 'Z', move.Z - head.ShiftZ, head.Z, unit, relative);
        Turn(text, move.Turns, state);
        Centers(move, state, unit);
        Extruder(text, move, state, carried);
        Feed(text, move, state, unit);
        Apply(bytes);
    }

    private static int Rank(byte letter) => Array.IndexOf(UsualOrder, letter) is >= 0 and var rank ? rank : UsualOrder.Length - 2;

    /// <summary>True if a number has more decimals than the limit.</summary>
    public bool IsTooFine(ParsedLine line, byte[] text)
    {
        for (var i = 0; i < line.Count; i++)
        {
            if (line.Letters[i] is (byte)'G' or (byte)'P' || !line.HasValue[i]) continue;
            if (Own(text, line, i) > Limit(line.Letters[i])) return true;
        }
        return false;
    }

    private int Limit(byte letter) => letter switch
    {
        (byte)'F' => style.LimitF ?? 99,
        (byte)'E' or (byte)'A' or (byte)'B' => style.LimitE ?? 99,
        (byte)'X' or (byte)'Y' or (byte)'Z' => style.LimitXyz ?? 99,
        _ => 99,
    };

    private static int Own(byte[] text, ParsedLine line, int word) => LineStyle.Decimals(text, line.NumberAt[word], line.NumberEnd[word], out _, out _);

    private bool MayStay(byte[] text, int word) => Own(text, _line, word) <= Limit(_line.Letters[word]);

    private void Motion(TargetMove move, InterpreterState state, int straight)
    {
        if (rules.Commands is CommandsRule.First or CommandsRule.Last) KeepMotionOnly();
        var code = move.Arc is { } arc ? rules.ArcCode(arc.Plane, arc.Sweep < 0) : straight;
        for (var i = 0; i < _line.Count; i++)
        {
            if (_line.Letters[i] != 'G' || !_line.HasValue[i] || !(_line.Values[i] is 0 or 1 or 2 or 3)) continue;
            if (code < 0 && _line.Values[i] > 1) code = 1;
            if (code >= 0 && code != _line.Values[i]) Replace(i, code, 0);
            return;
        }
        // A line that repeats the last motion.
        if (code < 0) code = state.Modes.Motion is 0 or 1 ? state.Modes.Motion : 1;
        if (rules.ModalMotion == ModalMotionRule.Never || state.Modes.Motion != code) Insert((byte)'G', code, 0);
    }

    // Modes of the line have been stated before it; firmware that takes one command of a line gets the motion.
    private void KeepMotionOnly()
    {
        for (var i = 0; i < _line.Count; i++)
        {
            if (_line.Letters[i] != 'G' || !_line.HasValue[i] || _line.Values[i] is 0 or 1 or 2 or 3) continue;
            _edits.Add(new Edit(_line.LetterAt[i], i + 1 < _line.Count ? _line.LetterAt[i + 1] : _line.NumberEnd[i], 255, 0, 0));
        }
    }

    private void Axis(byte[] text, char letter, double target, double current, double unit, bool relative)
    {
        var word = _line.Find(letter);
        var tolerance = 0.5 * NumberFormatter.FromUnits(1, Decimals(style.DecimalsXyz, unit)) * unit;
        if (word >= 0)
        {
            var says = relative ? current + _line.Values[word] * unit : _line.Values[word] * unit;
            if (Math.Abs(says - target) <= NoChange && MayStay(text, word)) return;
            var decimals = style.LimitXyz is null ? Math.Max(Own(text, _line, word), Decimals(style.DecimalsXyz, unit)) : Decimals(style.DecimalsXyz, unit);
            Replace(word, (relative ? target - current : target) / unit, Math.Min(decimals, 12));
        }
        else if (Math.Abs(target - current) > tolerance)
        {
            Insert((byte)letter, (relative ? target - current : target) / unit, Decimals(style.DecimalsXyz, unit));
        }
    }

    // Rotary axes; where A, B and C extrude there are none.
    private void Turn(byte[] text, Vec3 target, InterpreterState state)
    {
        var (now, shift) = (state.Rotary.Written, state.Rotary.Shift);
        if (target == Vec3.Zero && now == Vec3.Zero && shift == Vec3.Zero) return;
        Axis(text, 'A', target.X - shift.X, now.X, 1, state.Modes.Relative);
        Axis(text, 'B', target.Y - shift.Y, now.Y, 1, state.Modes.Relative);
        Axis(text, 'C', target.Z - shift.Z, now.Z, 1, state.Modes.Relative);
    }

    private void Centers(TargetMove move, InterpreterState state, double unit)
    {
        if (move.Arc is not { } arc)
        {
            foreach (var letter in "IJKRP") Delete(letter);
            return;
        }
        var center = arc.Center - state.Head.Shift;
        var from = state.Modes.AbsoluteCenters ? Vec3.Zero : state.Head.Written;
        Center('I', (center.X - from.X) / unit, arc.Plane != ArcPlane.YZ, unit);
        Center('J', (center.Y - from.Y) / unit, arc.Plane != ArcPlane.ZX, unit);
        Center('K', (center.Z - from.Z) / unit, arc.Plane != ArcPlane.XY, unit);
        Delete('R');
        Turns(rules.TurnsWord(arc.Turns));
        // A full circle names its end, so that the other words cannot be misread.
        if ((_line.Find('R') >= 0 || (rules.ArcNamesEnd && _line.Find('Y') < 0)) && _line.Find('X') < 0 && arc.Plane != ArcPlane.YZ)
        {
            var x = move.X - state.Head.ShiftX;
            Insert((byte)'X', (state.Modes.Relative ? x - state.Head.X : x) / unit, style.DecimalsXyz);
        }
    }

    private void Turns(int number)
    {
        var word = _line.Find('P');
        if (number == 0) Delete('P');
        else if (word < 0) Insert((byte)'P', number, 0);
        else if (_line.Values[word] != number) Replace(word, number, 0);
    }

    private void Center(char letter, double value, bool inPlane, double unit)
    {
        var word = _line.Find(letter);
        if (!inPlane)
        {
            Delete(letter);
            return;
        }
        if (word < 0)
        {
            if (Math.Abs(value) > NoChange || _line.Find('R') >= 0) Insert((byte)letter, value, Decimals(style.DecimalsXyz + 1, unit));
        }
        else if (Math.Abs(_line.Values[word] - value) > NoChange)
        {
            Replace(word, value, Decimals(style.DecimalsXyz + 1, unit));
        }
    }

    private void Extruder(byte[] text, TargetMove move, InterpreterState state, double carried)
    {
        var unit = state.Modes.UnitOfE(rules);
        // An extruder of another letter goes.
        if (source != axis && source.FirstLetter is not 0 and var old && old != _extruder) Delete((char)old);
        if (source == ExtrusionAxis.Both) Delete('B');
        if (_extruder == 0) return;
        var word = _line.Find((char)_extruder);
        if (word < 0 && Math.Abs(move.E) < NoChange) return;
        var from = state.Modes.RelativeE ? 0 : axis == ExtrusionAxis.Both ? state.Extrusion.A : state.Extrusion.E;
        // A travel does not take what rounding has left: it stays one.
        var value = (from + move.E + (move.E != 0 ? carried : 0)) / unit;
        if (word < 0) Insert(_extruder, value, Decimals(style.DecimalsE, unit));
        else if (Math.Abs(_line.Values[word] - value) > NoChange || !MayStay(text, word)) Replace(word, value, Decimals(style.DecimalsE, unit));
    }

    private void Feed(byte[] text, TargetMove move, InterpreterState state, double unit)
    {
        if (!(move.Speed > 0)) return;
        var word = _line.Find('F');
        var feed = move.Speed * 60 / state.Feed.Factor;
        var says = word >= 0 ? _line.Values[word] * unit : state.Feed.Rate;
        if (Math.Abs(says - feed) <= 1e-9 * feed && (word < 0 || MayStay(text, word))) return;
        if (word < 0 && Math.Abs(says - feed) <= style.FeedTolerance) return;
        var decimals = Decimals(style.LimitF ?? Math.Max(style.DecimalsF, word >= 0 ? Math.Min(Own(text, _line, word), 9) : 0), unit);
        if (word >= 0) Replace(word, feed / unit, decimals);
        else Insert((byte)'F', feed / unit, decimals);
    }

    // An inch is coarser, and a cubic inch more so.
    private static int Decimals(int decimals, double unit) => unit > 1000 ? decimals + 5 : unit > 1 ? decimals + 2 : decimals;

    private void Replace(int word, double value, int decimals) => _edits.Add(new Edit(_line.NumberAt[word], _line.NumberEnd[word], 0, value, decimals));

    private void Delete(char letter)
    {
        var word = _line.Find(letter);
        if (word < 0) return;
        var from = word > 0 ? _line.NumberEnd[word - 1] : _line.LetterAt[word];
        _edits.Add(new Edit(from, _line.NumberEnd[word], 255, 0, 0));
    }

    // After the last word that comes before it in the usual order.
    private void Insert(byte letter, double value, int decimals)
    {
        var at = _line.CodeStart;
        for (var i = 0; i < _line.Count; i++)
        {
            if (Rank(_line.Letters[i]) <= Rank(letter)) at = _line.NumberEnd[i];
        }
        _edits.Add(new Edit(at, at, letter, value, decimals));
    }

    private void Apply(FileLine line)
    {
        var (text, start, end) = (line.Text, line.Start, line.End);
        _edits.Sort(static (a, b) => a.Start != b.Start ? a.Start.CompareTo(b.Start) : Order(a).CompareTo(Order(b)));
        if (_out.Length < end - start + 512) _out = new byte[(end - start + 512) * 2];
        Count = 0;
        var at = start;
        var stop = _line.ChecksumAt >= 0 ? _line.ChecksumAt : end;
        foreach (var edit in _edits)
        {
            Copy(text, at, edit.Start);
            if (edit.Letter == 255)
            {
                at = Math.Max(edit.End, at);
                continue;
            }
            if (edit.Letter != 0)
            {
                if (!style.NoSpace && Count > 0 && _out[Count - 1] > ' ') _out[Count++] = (byte)' ';
                _out[Count++] = style.LowerCase ? (byte)(edit.Letter | 0x20) : edit.Letter;
            }
            Count = style.Write(_out, Count, edit.Value, edit.Decimals);
            at = Math.Max(edit.End, at);
            // A word that is put in front of others needs a space after it.
            if (edit.Letter != 0 && !style.NoSpace && at < stop && text[at] > ' ' && text[at] != ';') _out[Count++] = (byte)' ';
        }
        Copy(text, at, stop);
        if (_line.ChecksumAt < 0) return;
        Count = SplicedText.Sum(_out, Count);
        var rest = stop + 1;
        while (rest < end && (uint)(text[rest] - '0') <= 9) rest++;
        Copy(text, rest, end);
    }

    private static int Order(Edit edit) => edit.Letter is 0 or 255 ? -1 : Rank(edit.Letter);

    private void Copy(byte[] text, int from, int to)
    {
        if (to <= from) return;
        Buffer.BlockCopy(text, from, _out, Count, to - from);
        Count += to - from;
    }

    // Letter 0 replaces a number, 255 deletes, others are inserted.
    private readonly record struct Edit(int Start, int End, byte Letter, double Value, int Decimals);
}
