using System;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using Caterpillar.Basics;
using Caterpillar.Expressions;
using Caterpillar.Files;
using NUnit.Framework;

namespace Caterpillar.Tests.Basics;

/// <summary>Helpers of a few lines.</summary>
public class SmallHelperTests
{
    [Test]
    public void The_message_of_an_exception_comes_without_its_parameter()
    {
        Assert.That(Messages.Clean(new ArgumentException("It is too long.", "length")), Is.EqualTo("It is too long."));
        Assert.That(Messages.Clean(new InvalidOperationException("It is too long.")), Is.EqualTo("It is too long."));
        Assert.That(Messages.Clean(new InvalidOperationException("It is too long.\r\nParameter name: length")), Is.EqualTo("It is too long."));
        Assert.That(Messages.Clean(new InvalidOperationException(" (Parameter 'length')")), Is.Empty);
    }

    [Test]
    public void Work_on_its_own_thread_gives_its_result_or_its_own_exception()
    {
        Assert.That(OwnThread.Join(OwnThread.Run(() => 7)), Is.EqualTo(7));
        var failed = OwnThread.Run<int>(() => throw new FormatException("own"));
        Assert.That(() => OwnThread.Join(failed), Throws.InstanceOf<FormatException>().With.Message.EqualTo("own"));
        var depth = 0;
        OwnThread.Run(() => depth = 1, 1 << 20);
        Assert.That(depth, Is.EqualTo(1));
        Assert.That(() => OwnThread.Run(() => throw new FormatException("own"), 1 << 20), Throws.InstanceOf<FormatException>());
    }

    [Test]
    public void Waiting_ends_with_the_work_or_when_it_is_canceled()
    {
        var work = OwnThread.Run(() => Thread.Sleep(20));
        OwnThread.WaitOr(work, default);
        Assert.That(work.IsCompleted, Is.True);
        var never = new TaskCompletionSource<int>();
        Assert.That(() => OwnThread.WaitOr(never.Task, new CancellationToken(true)), Throws.InstanceOf<OperationCanceledException>());
        Assert.That(() => OwnThread.WaitOr(Task.FromResult(1), new CancellationToken(true)), Throws.Nothing);
        Assert.That(() => OwnThread.WaitOr(Task.FromException(new FormatException()), CancellationToken.None), Throws.Nothing);
    }

    [TestCase(1, "1 bytes")]
    [TestCase(999, "999 bytes")]
    [TestCase(1000, "1 KB")]
    [TestCase(1536, "1.5 KB")]
    [TestCase(10_240, "10 KB")]
    [TestCase(10_650, "10 KB")]
    [TestCase(1_610_612_736, "1.5 GB")]
    [TestCase(2e18, "1818989 TB")]
    public void Memory_is_stated_in_powers_of_1024(double bytes, string text) => Assert.That(MemoryLimit.Text(bytes), Is.EqualTo(text));

    [Test]
    public void What_exceeds_a_limit_is_refused_with_its_need_and_the_remedy()
    {
        var limit = new MemoryLimit(1000);
        Assert.That(limit.Refuse(1000, "A list"), Is.Null);
        Assert.That(limit.Refuse(1001, "A list")!.Message, Is.EqualTo("A list would take about 1 KB of memory. The limit is 1 KB."));
        Assert.That(limit.Refuse(double.PositiveInfinity, "A list", remedy: "Make it shorter.")!.Message,
            Is.EqualTo("A list would take more than a million TB of memory. The limit is 1 KB. Make it shorter."));
        Assert.That(() => limit.Check(1001, "A list"), Throws.InstanceOf<DiagnosticException>());
        Assert.That(() => limit.Check(1000, "A list"), Throws.Nothing);
        Assert.That(() => new MemoryLimit(0), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(MemoryLimit.Default.Bytes, Is.GreaterThan(1L << 27));
    }

    [TestCase(-1)]
    [TestCase(99)]
    public void Numbers_cannot_have_so_many_decimals(int decimals)
        => Assert.That(() => NumberFormatter.Format(1.5, decimals), Throws.InstanceOf<ArgumentOutOfRangeException>());

    [TestCase("1\u007f", false)]
    [TestCase("1\u0080", false)]
    [TestCase("1\u0131", false)]
    [TestCase("\u0661", false)]
    [TestCase("1e2", true)]
    public void Only_ASCII_is_a_number(string text, bool isNumber) => Assert.That(NumberReader.TryParse(text, out _), Is.EqualTo(isNumber));

    [TestCase(30, 0.5, 0.8660254037844386)]
    [TestCase(-30, -0.5, 0.8660254037844386)]
    [TestCase(45, 0.7071067811865476, 0.7071067811865476)]
    [TestCase(-45, -0.7071067811865476, 0.7071067811865476)]
    [TestCase(135, 0.7071067811865476, -0.7071067811865476)]
    [TestCase(225, -0.7071067811865476, -0.7071067811865476)]
    public void Sines_of_even_angles_are_the_nearest_numbers(double degrees, double sin, double cos)
        => Assert.That(Angle.SinCos(degrees), Is.EqualTo((sin, cos)));

    [Test]
    public void Random_numbers_of_zero_do_not_depend_on_its_sign()
    {
        Assert.That(SeededRandom.Of(-0.0), Is.EqualTo(SeededRandom.Of(0)));
        Assert.That(SeededRandom.Of(1), Is.Not.EqualTo(SeededRandom.Of(0)));
        var random = new SeededRandom(3);
        Assert.That(() => random.NextInteger(3, 2), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(random.NextInteger(5, 5), Is.EqualTo(5));
        var counts = new int[3];
        for (var i = 0; i < 3000; i++) counts[random.NextInteger(-1, 1) + 1]++;
        Assert.That(counts, Is.All.EqualTo(1000).Within(100));
    }

    [TestCase("tau", 6.283185307179586)]
    [TestCase("pi", 3.141592653589793)]
    [TestCase("2e1", 20)]
    [TestCase("2e+1", 20)]
    [TestCase("20e-1", 2)]
    [TestCase(".5e1", 5)]
    public void Numbers_of_formulas_may_have_an_exponent(string text, double value)
        => Assert.That(Formula.Compile(text, []).OrThrow().Evaluate([]), Is.EqualTo(value).Within(1e-15));

    [TestCase("2e")]
    [TestCase("2e+")]
    [TestCase("2e-x")]
    public void An_exponent_without_digits_is_an_unknown_name(string text) => Assert.That(Formula.Compile(text, []).HasErrors, Is.True);

    [TestCase("nan 2", true)]
    [TestCase("-INF 2", true)]
    [TestCase("+inf 2", true)]
    [TestCase("inx 2", false)]
    [TestCase("nax 2", false)]
    [TestCase("xnan 2", false)]
    [TestCase("in", false)]
    public void Words_for_no_number_are_read_as_numbers(string text, bool isNumber)
    {
        var cursor = new TextCursor(Encoding.ASCII.GetBytes(text), 0, text.Length);
        Assert.That(cursor.ReadNumber(out var value), Is.EqualTo(isNumber));
        if (isNumber) Assert.That((double.IsNaN(value), cursor.At), Is.EqualTo((true, text.Length - 2)));
    }
}
