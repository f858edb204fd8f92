using System;
using Caterpillar.Basics;
using NUnit.Framework;

namespace Caterpillar.Tests.Basics;

public class MemoryLimitTests
{
    [Test]
    public void What_fits_is_no_problem()
    {
        var limit = new MemoryLimit(1000);
        Assert.That(limit.Refuse(1000, "It"), Is.Null);
        Assert.That(() => limit.Check(1000, "It"), Throws.Nothing);
    }

    [TestCase(1001, "It would take about 1 KB of memory. The limit is 1 KB.")]
    [TestCase(1536 * 1024 * 1024.0, "It would take about 1.5 GB of memory. The limit is 1 KB.")]
    [TestCase(double.PositiveInfinity, "It would take more than a million TB of memory. The limit is 1 KB.")]
    [TestCase(double.NaN, "It would take more than a million TB of memory. The limit is 1 KB.")]
    public void What_does_not_fit_is_an_error_that_says_how_much(double bytes, string message)
    {
        var error = new MemoryLimit(1000).Refuse(bytes, "It");
        Assert.That(error, Is.EqualTo(new Diagnostic(Severity.Error, MemoryLimit.Code, message)));
        Assert.That(() => new MemoryLimit(1000).Check(bytes, "It"), Throws.TypeOf<DiagnosticException>());
    }

    [TestCase(15.4 * 1024 * 1024 * 1024, "15 GB")]
    [TestCase(999.0, "999 bytes")]
    [TestCase(1000.0, "1 KB")]
    public void Sizes_are_in_powers_of_1024_and_have_a_decimal_below_10_only(double bytes, string text)
        => Assert.That(MemoryLimit.Text(bytes), Is.EqualTo(text));

    [Test]
    public void The_remedy_follows()
        => Assert.That(new MemoryLimit(64).Refuse(65, "It", remedy: "Use less.")!.Message,
            Is.EqualTo("It would take about 65 bytes of memory. The limit is 64 bytes. Use less."));

    [Test]
    public void Half_of_the_machine_is_the_default()
    {
        Assert.That(MemoryLimit.Default.Bytes, Is.InRange(32L << 20, 1L << 50));
        Assert.That(() => new MemoryLimit(0), Throws.TypeOf<ArgumentOutOfRangeException>());
    }
}
