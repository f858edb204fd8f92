namespace Caterpillar.Cli;

/// <summary>Text for a terminal: control characters of names in files are written as <c>\u001B</c>, which is also valid in JSON.</summary>
internal sealed class VisibleText : TextWriter
{
    private readonly TextWriter _inner;

    public VisibleText(TextWriter inner)
        : base(CultureInfo.InvariantCulture)
        => (_inner, CoreNewLine) = (inner, inner.NewLine.ToCharArray());

    public override Encoding Encoding => _inner.Encoding;

    public override void Write(char value) => _inner.Write(LongWords.Visible(value.ToString()));

    public override void Write(char[] buffer, int index, int count) => _inner.Write(LongWords.Visible(new string(buffer, index, count)));

    public override void Write(string? value) => _inner.Write(value is null ? null : LongWords.Visible(value));

    public override void Flush() => _inner.Flush();
}
