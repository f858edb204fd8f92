using System;
using System.IO;
using System.Text;
using Caterpillar.Files;
using Caterpillar.GCode;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Parts of a spliced file are put together and written on another thread: all of them, in order, and its problems come back.</summary>
public class SplicedOutputTests
{
    private static readonly LineStyle Style = LineStyle.Of(GCodeDocument.FromBytes(Encoding.ASCII.GetBytes("G1 X1.5 Y2\n")));

    [Test]
    public void All_bytes_arrive_in_order([Values] bool hasThread)
    {
        var random = new Random(4);
        var bytes = new byte[5_000_000];
        random.NextBytes(bytes);
        using var target = new MemoryStream();
        using var output = new SplicedOutput(target, Style, hasThread);
        for (var at = 0; at < bytes.Length;)
        {
            var end = at + Math.Min(random.Next(1_000_000), bytes.Length - at);
            output.Write(Part(output, bytes, at, end));
            at = end;
        }
        output.Finish();
        Assert.That(target.ToArray(), SameBytes.As(bytes));
    }

    [Test]
    public void Numbers_and_other_bytes_are_put_into_the_text()
    {
        var text = Encoding.ASCII.GetBytes("G1 X10 E2\n;old\nM104 S200\n");
        var own = Encoding.ASCII.GetBytes("G92 E0\nG1 F600\n");
        using var target = new MemoryStream();
        using var output = new SplicedOutput(target, Style, false);
        var chunk = Part(output, text, 0, 4);
        chunk.Replace(6, -1250, 3);
        chunk.Add(text, 6, 8);
        chunk.Replace(9, 5, 1);
        chunk.Add(text, 9, 10);
        chunk.Add(own, 0, 7);
        chunk.Add(own, 7, 15);
        chunk.Add(text, 15, 25);
        output.Write(chunk);
        output.Finish();
        Assert.That(Encoding.ASCII.GetString(target.ToArray()), Is.EqualTo("G1 X-1.25 E0.5\nG92 E0\nG1 F600\nM104 S200\n"));
    }

    [Test]
    public void Nothing_written_is_no_problem()
    {
        using var target = new MemoryStream();
        using var output = new SplicedOutput(target, Style, true);
        output.Finish();
        Assert.That(target.Length, Is.Zero);
    }

    [Test]
    public void A_full_disk_is_heard_of_and_does_not_block()
    {
        using var output = new SplicedOutput(new Full(), Style, true);
        Assert.That(() =>
        {
            for (var i = 0; i < 1000; i++) output.Write(Part(output, new byte[100_000], 0, 100_000));
            output.Finish();
        }, Throws.InstanceOf<IOException>());
    }

    [Test]
    public void Dropping_it_early_does_not_wait_for_more()
    {
        using var target = new MemoryStream();
        using (var output = new SplicedOutput(target, Style, true)) output.Write(Part(output, new byte[10], 0, 10));
        Assert.That(target.Length, Is.EqualTo(10));
    }

    private static SplicedChunk Part(SplicedOutput output, byte[] text, int start, int end)
    {
        var chunk = output.NewChunk();
        chunk.Begin(text, start);
        chunk.Add(text, start, end);
        return chunk;
    }

    private sealed class Full : WriteStream
    {
        public override void Write(byte[] buffer, int offset, int count) => throw new IOException("The disk is full.");
    }
}
