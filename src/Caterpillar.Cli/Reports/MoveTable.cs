namespace Caterpillar.Cli;

/// <summary>Moves as comma-separated values, one row each.</summary>
internal sealed class MoveTable(Stream stream)
{
    private const int Decimals = 6;
    private const double Printable = 9e15 / 1e6;

    private readonly byte[] _number = new byte[64];

    /// <summary>Writes the moves of one or several toolpaths; with several, the first column names the file.</summary>
    public static void Write(Stream stream, IReadOnlyList<(string File, Toolpath Toolpath)> toolpaths, CancellationToken cancel)
    {
        var buffer = new BufferedStream(stream, 1 << 16);
        var table = new MoveTable(buffer);
        var several = toolpaths.Count > 1;
        var turns = toolpaths.Any(t => t.Toolpath.HasTurns);
        table.Text((several ? "file," : "")
            + "move,line,kind,x,y,z,e,deposited_e,speed_mm_s,role,layer,tool,length_mm,arc_center_x,arc_center_y,"
            + "arc_center_z,arc_sweep_deg,area_mm2,width_mm" + (turns ? ",a_deg,b_deg,c_deg,tool_x,tool_y,tool_z" : ""));
        foreach (var (file, toolpath) in toolpaths)
        {
            var prefix = several ? "\n" + Quoted(file) + "," : "\n";
            var count = 0;
            var axes = Kinematics.Guess(toolpath);
            foreach (var move in toolpath.Moves())
            {
                if ((++count & 0xFFFF) == 0) cancel.ThrowIfCancellationRequested();
                table.Text(prefix);
                table.Row(toolpath, move);
                if (turns) table.Turns(toolpath.WordsAt(move.Index), axes);
            }
        }
        table.Text("\n");
        buffer.Flush();
    }

    private static readonly string[] Kinds = Enum.GetNames<MoveKind>().Select(name => "," + Words.Snake(name)).ToArray();
    private static readonly string[] Roles = Enum.GetNames<Role>().Select(name => "," + Words.Snake(name)).ToArray();

    private void Row(Toolpath toolpath, in Move move)
    {
        Text(NumberFormatter.Format(move.Index));
        Integer(move.Source);
        Text(Kinds[(int)move.Kind]);
        Point(move.End);
        Number(move.E);
        Number(move.Deposited);
        Number(move.Speed);
        Text(Roles[(int)move.Role]);
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
    private void Turns(Vec3 words, Kinematics? axes)
    {
        Point(words);
        if (axes is not null) Point(axes.Direction(words));
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
            Text("," + (double.IsFinite(value) ? NumberFormatter.Format(value, 0) : ""));
            return;
        }
        Units(NumberFormatter.ToUnits(value, Decimals), Decimals);
    }

    private void Integer(int value) => Units(value, 0);

    private void Units(long units, int decimals)
    {
        _number[0] = (byte)',';
        stream.Write(_number, 0, NumberFormatter.WriteUnits(_number, 1, units, decimals));
    }

    private void Text(string text) => stream.Write(Encoding.UTF8.GetBytes(text));

    private static string Quoted(string text)
        => text.AsSpan().IndexOfAny(",\"\n\r") >= 0 ? "\"" + text.Replace("\"", "\"\"", StringComparison.Ordinal) + "\"" : text;
}
