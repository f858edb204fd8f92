using System;
using System.IO;
using System.Text;
using Caterpillar.Files;
using Caterpillar.GCode;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>The text of a spliced file is put together and written on another thread: all of it, in order, and its problems come back.</summary>
public class SplicedTextTests
{
    private static readonly LineStyle Style = LineStyle.Of(GCodeDocument.FromBytes(Encoding.ASCII.GetBytes("G1 X1.5 Y2\n")));

    [Test]
    public void All_bytes_arrive_in_order([Values] bool hasThread, [Values] bool isOfText)
    {
        var random = new Random(4);
        var bytes = new byte[5_000_000];
        random.NextBytes(bytes);
        using var target = new MemoryStream();
        using var text = new SplicedText(target, Style, hasThread);
        if (isOfText) text.Begin(bytes, 0);
        for (var at = 0; at < bytes.Length;)
        {
            var end = at + Math.Min(random.Next(1_000_000), bytes.Length - at);
            text.Copy(bytes, at, end);
            at = end;
        }
        text.Finish();
        Assert.That(target.ToArray(), SameBytes.As(bytes));
    }

    [Test]
    public void Numbers_and_other_bytes_are_put_into_the_text([Values] bool isLong)
    {
        var rest = isLong ? new string('-', 700_000) : "";
        var text = Encoding.ASCII.GetBytes("G1 X10 E2\n;old\nM104 S200\n;" + rest);
        var own = Encoding.ASCII.GetBytes("G92 E0\nG1 F600\n");
        using var target = new MemoryStream();
        using var spliced = new SplicedText(target, Style, false);
        spliced.Begin(text, 0);
        spliced.Copy(text, 0, 4);
        spliced.Replace(6, -1250, 3);
        spliced.Copy(text, 6, 8);
        spliced.Replace(9, 5, 1);
        spliced.Copy(text, 9, 10);
        spliced.Copy(own, 0, 7);
        spliced.Copy(own, 7, 15);
        spliced.Copy(text, 15, 25);
        spliced.Copy(text, 25, text.Length);
        spliced.Finish();
        Assert.That(Encoding.ASCII.GetString(target.ToArray()), Is.EqualTo("G1 X-1.25 E0.5\nG92 E0\nG1 F600\nM104 S200\n;" + rest));
    }

    [Test]
    public void Nothing_written_is_no_problem()
    {
        using var target = new MemoryStream();
        using var text = new SplicedText(target, Style, true);
        text.Finish();
        Assert.That(target.Length, Is.Zero);
    }

    [Test]
    public void A_full_disk_is_heard_of_and_does_not_block()
    {
        using var text = new SplicedText(new Full(), Style, true);
        Assert.That(() =>
        {
            for (var i = 0; i < 1000; i++) text.Copy(new byte[100_000], 0, 100_000);
            text.Finish();
        }, Throws.InstanceOf<IOException>());
    }

    [Test]
    public void Dropping_it_early_writes_no_more_than_full_parts()
    {
        using var target = new MemoryStream();
        using (var text = new SplicedText(target, Style, true))
        {
            for (var i = 0; i < 10; i++) text.Copy(new byte[100_000], 0, 100_000);
        }
        Assert.That(target.Length, Is.GreaterThan(0).And.LessThan(1_000_000));
    }

    private sealed class Full : WriteStream
    {
        public override void Write(byte[] buffer, int offset, int count) => throw new IOException("The disk is full.");
    }
}
