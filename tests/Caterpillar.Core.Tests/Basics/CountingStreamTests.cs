using System;
using System.IO;
using Caterpillar.Files;
using Caterpillar.GCode;
using NUnit.Framework;

namespace Caterpillar.Tests.Basics;

/// <summary>Lines are counted while they are written, as a document counts them.</summary>
public class CountingStreamTests
{
    [Test]
    public void Any_mixture_of_line_ends_is_counted_in_any_pieces()
    {
        var random = new Random(2);
        for (var round = 0; round < 2000; round++)
        {
            var bytes = new byte[random.Next(40)];
            for (var i = 0; i < bytes.Length; i++) bytes[i] = (byte)"\n\r\nG"[random.Next(4)];
            using var inner = new MemoryStream();
            using var counted = new CountingStream(inner);
            for (var at = 0; at < bytes.Length;)
            {
                var count = Math.Min(random.Next(1, 6), bytes.Length - at);
                counted.Write(bytes, at, count);
                at += count;
            }
            Assert.That(inner.ToArray(), Is.EqualTo(bytes));
            Assert.That((counted.Lines, counted.Bytes), Is.EqualTo((GCodeDocument.FromBytes(bytes).LineCount, (long)bytes.Length)),
                () => BitConverter.ToString(bytes));
        }
    }
}
