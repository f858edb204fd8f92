using System;
using System.IO;
using Caterpillar.Files;
using NUnit.Framework;

namespace Caterpillar.Tests.Basics;

/// <summary>Bytes are written on another thread: all of them, in order, and its problems come back.</summary>
public class QueuedStreamTests
{
    [Test]
    public void All_bytes_arrive_in_order()
    {
        var random = new Random(4);
        var bytes = new byte[5_000_000];
        random.NextBytes(bytes);
        using var target = new MemoryStream();
        using var queue = new QueuedStream(target);
        for (var at = 0; at < bytes.Length;)
        {
            var count = Math.Min(random.Next(1_000_000), bytes.Length - at);
            queue.Write(bytes, at, count);
            at += count;
        }
        queue.Finish();
        Assert.That(target.ToArray(), SameBytes.As(bytes));
    }

    [Test]
    public void Nothing_written_is_no_problem()
    {
        using var target = new MemoryStream();
        using var queue = new QueuedStream(target);
        queue.Finish();
        Assert.That(target.Length, Is.Zero);
    }

    [Test]
    public void A_full_disk_is_heard_of_and_does_not_block()
    {
        using var queue = new QueuedStream(new Full());
        Assert.That(() =>
        {
            for (var i = 0; i < 1000; i++) queue.Write(new byte[100_000], 0, 100_000);
            queue.Finish();
        }, Throws.InstanceOf<IOException>());
    }

    [Test]
    public void Dropping_it_early_does_not_wait_for_more()
    {
        using var target = new MemoryStream();
        using (var queue = new QueuedStream(target)) queue.Write(new byte[10], 0, 10);
        Assert.That(target.Length, Is.EqualTo(10));
    }

    private sealed class Full : WriteStream
    {
        public override void Write(byte[] buffer, int offset, int count) => throw new IOException("The disk is full.");
    }
}
