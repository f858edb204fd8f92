namespace Caterpillar.Checks;

/// <summary>
/// A stream of G-code with a number of 64 bits for its lines, without those about progress: files that have the same are the same text. Lines are written
/// whole. Only for one run of a program.
/// </summary>
/// <param name="target">Receives the text; null = none.</param>
internal sealed class TextDigest(Stream? target) : WriteStream
{
    // Odd, with bits all over: multiplying by it and turning spreads every bit over all others.
    private const ulong Factor = 0x9E3779B97F4A7C15;

    /// <summary>The number so far.</summary>
    public ulong Sum { get; private set; }

    public override void Write(byte[] buffer, int offset, int count)
    {
        target?.Write(buffer, offset, count);
        var (sum, end) = (Sum, offset + count);
        while (offset < end)
        {
            var next = Array.IndexOf(buffer, (byte)'\n', offset, end - offset) + 1;
            if (next == 0) next = end;
            if (!TellsProgress(buffer, offset, next)) sum = Mix(buffer, offset, next, sum);
            offset = next;
        }
        Sum = sum;
    }

    public override void Flush() => target?.Flush();

    private static bool TellsProgress(byte[] line, int at, int end)
        => end - at > 6 && line[at] == 'M' && line[at + 1] == '7' && line[at + 2] == '3' && line[at + 3] == ' ';

    private static ulong Mix(byte[] line, int at, int end, ulong sum)
    {
        for (; at + 8 <= end; at += 8) sum = Mix(sum, BitConverter.ToUInt64(line, at));
        var rest = (ulong)(end - at);
        for (; at < end; at++) rest = (rest << 8) | line[at];
        return Mix(sum, rest);
    }

    private static ulong Mix(ulong sum, ulong value)
    {
        sum = (sum ^ value) * Factor;
        return sum ^ (sum >> 29);
    }
}
