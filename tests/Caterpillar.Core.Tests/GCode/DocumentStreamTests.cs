using System;
using System.Linq;
using Caterpillar.GCode;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Text written piece by piece is a document with the same bytes and lines.</summary>
public class DocumentStreamTests
{
    [TestCase(0, 10)]
    [TestCase(1000, 17)]
    [TestCase(200_000, 999)]
    [TestCase(3_000_000, 70_001)]
    public void Pieces_of_any_size_make_the_document(int length, int piece)
    {
        var random = new Random(length);
        var ends = new byte[] { (byte)'\n', (byte)'\r', (byte)'a', (byte)'b', (byte)'c', (byte)'G', (byte)'1' };
        var bytes = Enumerable.Range(0, length).Select(i => i > length / 2 && i < length / 2 + 150_000 ? (byte)'x' : ends[random.Next(ends.Length)]).ToArray();
        using var stream = new DocumentStream();
        for (var at = 0; at < length; at += piece) stream.Write(bytes, at, Math.Min(piece, length - at));
        var document = stream.ToDocument("a.gcode");
        var plain = GCodeDocument.FromBytes(bytes);
        Assert.That(document.ToBytes(), Is.EqualTo(bytes));
        Assert.That((document.LineCount, document.Name), Is.EqualTo((plain.LineCount, "a.gcode")));
        foreach (var number in Enumerable.Range(1, document.LineCount).Where(n => n % 997 == 1))
            Assert.That(document.Line(number).Text, Is.EqualTo(plain.Line(number).Text));
    }
}
