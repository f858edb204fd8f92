namespace Caterpillar.Cli;

/// <summary>Moves as comma-separated values, one row each.</summary>
internal sealed class MoveTable
{
    private const int Decimals = 6;
    private const double Printable = 9e15 / 1e6;

    private readonly byte[] _buffer = new byte[1 << 16];
    private readonly Stream _stream;
    private int _at;

    private MoveTable(Stream stream) => _stream = stream;

    /// <summary>Writes the moves of one or several toolpaths; with several, the first column names the file.</summary>
    public static void Write(Stream stream, IReadOnlyList<(string File, Toolpath Toolpath)> toolpaths, CancellationToken cancel)
    {
        var table = new MoveTable(stream);
        var several = toolpaths.Count > 1;
        var turns = toolpaths.Any(t => t.Toolpath.HasTurns);
        table.Text((several ? "file," : "")
            + "move,line,kind,x,y,z,e,deposited_e,speed_mm_s,role,layer,tool,length_mm,arc_center_x,arc_center_y,"
            + "arc_center_z,arc_sweep_deg,area_mm2,width_mm" + (turns ? ",a_deg,b_deg,c_deg,tool_x,tool_y,tool_z\n" : "\n"));
        foreach (var (file, toolpath) in toolpaths)
        {
            var prefix = several ? Quoted(file) + "," : "";
            var count = 0;
            var axes = Kinematics.Guess(toolpath);
            foreach (var move in toolpath.Moves())
            {
                if ((++count & 0xFFFF) == 0) cancel.ThrowIfCancellationRequested();
                table.Text(prefix);
                table.Row(toolpath, move);
                if (turns) table.Turns(toolpath.TurnsOf(move.Index), axes);
                table._buffer[table._at - 1] = (byte)'\n';
            }
        }
        table.Flush();
    }

    private static readonly string[] Kinds = Enum.GetNames<MoveKind>().Select(Words.Snake).ToArray();
    private static readonly string[] Roles = Enum.GetNames<Role>().Select(Words.Snake).ToArray();

    private void Row(Toolpath toolpath, in Move move)
    {
        Integer(move.Index);
        Integer(move.Source);
        Word(Kinds[(int)move.Kind]);
        Point(move.End);
        Number(move.E);
        Number(move.Deposited);
        Number(move.Speed);
        Word(Roles[(int)move.Role]);
        Integer(toolpath.NumberOfLayer(move) ?? -1);
        Integer(move.Tool);
        Number(move.Length);
        if (move.Arc is { } arc)
        {
            Point(arc.Center);
            Number(arc.Sweep);
        }
        else
        {
            Text(",,,,");
        }
        if (toolpath.BeadOf(move) is { } bead)
        {
            Number(bead.Area);
            Number(bead.Width(BeadShape.Stadium));
        }
        else
        {
            Text(",,");
        }
    }

    // The words, and where the tool points; upright where a file has none yet.
    private void Turns((double A, double B, double C)? turns, Kinematics? axes)
    {
        var (a, b, c) = turns ?? default;
        Number(a);
        Number(b);
        Number(c);
        if (axes is not null) Point(axes.Direction(new Vec3(a, b, c)));
        else Text(",,,");
    }

    private void Point(Vec3 p)
    {
        Number(p.X);
        Number(p.Y);
        Number(p.Z);
    }

    private void Number(double value)
    {
        if (!(Math.Abs(value) < Printable))
        {
            Word(double.IsFinite(value) ? NumberFormatter.Format(value, 0) : "");
            return;
        }
        Units(NumberFormatter.ToUnits(value, Decimals), Decimals);
    }

    private void Integer(int value) => Units(value, 0);

    private void Units(long units, int decimals)
    {
        EnsureSpace(32);
        _at = NumberFormatter.WriteUnits(_buffer, _at, units, decimals);
        _buffer[_at++] = (byte)',';
    }

    private void Word(string word)
    {
        Text(word);
        Text(",");
    }

    private void Text(string text)
    {
        if (text.Length * 3 > _buffer.Length)
        {
            Flush();
            _stream.Write(Encoding.UTF8.GetBytes(text));
            return;
        }
        EnsureSpace(text.Length * 3);
        _at += Encoding.UTF8.GetBytes(text, 0, text.Length, _buffer, _at);
    }

    private void EnsureSpace(int bytes)
    {
        if (_at + bytes > _buffer.Length - 64) Flush();
    }

    private void Flush()
    {
        _stream.Write(_buffer, 0, _at);
        _at = 0;
    }

    private static string Quoted(string text)
        => text.AsSpan().IndexOfAny(",\"\n\r") >= 0 ? "\"" + text.Replace("\"", "\"\"", StringComparison.Ordinal) + "\"" : text;
}
