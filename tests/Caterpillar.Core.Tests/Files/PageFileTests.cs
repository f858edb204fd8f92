using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Caterpillar.Files;
using NUnit.Framework;

namespace Caterpillar.Tests.Files;

/// <summary>Parts are read again as they were added, whatever the memory.</summary>
public class PageFileTests
{
    [TestCase(0)]
    [TestCase(1000)]
    [TestCase(1_000_000)]
    public void Parts_stay_as_they_are_in_any_order(long memory)
    {
        var random = new Random(3);
        var file = File(memory);
        var (parts, pages) = (new List<byte[]>(), new List<Page<byte[]>>());
        for (var i = 0; i < 2000; i++)
        {
            if (parts.Count == 0 || random.Next(3) == 0)
            {
                parts.Add(Bytes(random));
                pages.Add(file.Add(parts[parts.Count - 1]));
            }
            var at = random.Next(parts.Count);
            Assert.That(pages[at].Value, Is.EqualTo(parts[at]));
        }
    }

    [Test]
    public void Threads_read_at_the_same_time()
    {
        var random = new Random(4);
        var file = File(500);
        byte[][] parts = [.. Enumerable.Range(0, 100).Select(_ => Bytes(random))];
        Page<byte[]>[] pages = [.. parts.Select(file.Add)];
        Parallel.For(0, 4, thread =>
        {
            for (var i = 0; i < 500; i++)
            {
                var at = (i * (thread + 3)) % parts.Length;
                Assert.That(pages[at].Value, Is.EqualTo(parts[at]));
            }
        });
    }

    [Test]
    public void What_fits_into_memory_is_not_read_again()
    {
        var file = new PageFile<byte[]>(100, b => b.Length, (_, _) => Assert.Fail(), _ => throw new InvalidOperationException());
        Page<byte[]>[] pages = [.. Enumerable.Range(0, 10).Select(_ => file.Add(new byte[10]))];
        foreach (var page in pages) Assert.That(page.Value, Has.Length.EqualTo(10));
    }

    private static byte[] Bytes(Random random)
    {
        var bytes = new byte[random.Next(200)];
        random.NextBytes(bytes);
        return bytes;
    }

    private static PageFile<byte[]> File(long memory) => new(memory, b => b.Length, Write, r => r.ReadBytes(r.ReadInt32()));

    private static void Write(BinaryWriter writer, byte[] bytes)
    {
        writer.Write(bytes.Length);
        writer.Write(bytes);
    }
}
