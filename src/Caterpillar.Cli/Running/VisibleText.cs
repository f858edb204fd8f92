using System.Diagnostics.CodeAnalysis;

namespace Caterpillar.Cli;

/// <summary>Text for a terminal: control characters of names in files are written as <c>\u001B</c>, which is also valid in JSON.</summary>
internal sealed class VisibleText(TextWriter inner) : TextWriter(CultureInfo.InvariantCulture)
{
    public override Encoding Encoding => inner.Encoding;

    [AllowNull]
    public override string NewLine
    {
        get => inner.NewLine;
        set => inner.NewLine = value;
    }

    public override void Write(char value) => inner.Write(LongWords.Visible(value.ToString()));

    public override void Write(char[] buffer, int index, int count) => inner.Write(LongWords.Visible(new string(buffer, index, count)));

    public override void Write(string? value) => inner.Write(value is null ? null : LongWords.Visible(value));

    public override void WriteLine() => inner.WriteLine();

    public override void WriteLine(string? value)
    {
        Write(value);
        inner.WriteLine();
    }

    public override void Flush() => inner.Flush();
}
