namespace Caterpillar.Files;

/// <summary>A stream that can only be written, from beginning to end.</summary>
internal abstract class WriteStream : OneWayStream
{
    public override bool CanRead => false;

    public override bool CanWrite => true;

    public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();
}
