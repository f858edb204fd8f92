namespace Caterpillar.GCode;

/// <summary>A line of the file.</summary>
/// <param name="Text">Bytes of which it is a part; shared and never changed.</param>
/// <param name="Start">Where it begins.</param>
/// <param name="End">Where its line end begins.</param>
/// <param name="Next">Where the next line begins.</param>
internal readonly record struct FileLine(byte[] Text, int Start, int End, int Next);
