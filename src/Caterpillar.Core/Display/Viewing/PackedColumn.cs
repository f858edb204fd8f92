namespace Caterpillar.Display;

/// <summary>
/// A column of whole numbers as bytes: differences from the previous number, seven bits per byte, with the sign in the lowest bit. Columns with long equal runs
/// are written as runs: a difference and the number of repetitions.
/// </summary>
internal sealed class PackedColumn(string name, bool runs = false)
{
    private readonly List<byte> _bytes = [];
    private long _last;
    private long _run;

    public string Name { get; } = name;

    public int Count { get; private set; }

    public void Add(long value)
    {
        Count++;
        if (runs && _run > 0 && value == _last)
        {
            _run++;
            return;
        }
        EndRun();
        Difference(value);
        _run = 1;
    }

    /// <summary>A number in steps of <paramref name="step"/>, rounded.</summary>
    public void Add(double value, double step)
    {
        var steps = value / step;
        Add(steps > -1e15 && steps < 1e15 ? (long)Math.Round(steps) : steps > 0 ? (long)1e15 : steps < 0 ? (long)-1e15 : 0);
    }

    public byte[] ToBytes()
    {
        EndRun();
        _run = 0;
        return _bytes.ToArray();
    }

    private void EndRun()
    {
        if (runs && _run > 0) Number((ulong)_run);
    }

    private void Difference(long value)
    {
        var change = value - _last;
        Number((ulong)((change << 1) ^ (change >> 63)));
        _last = value;
    }

    private void Number(ulong value)
    {
        for (; value >= 0x80; value >>= 7) _bytes.Add((byte)(value | 0x80));
        _bytes.Add((byte)value);
    }
}
