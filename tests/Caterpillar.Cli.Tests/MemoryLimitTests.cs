using System;
using System.IO;
using Caterpillar.Basics;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

public class MemoryLimitTests : CliFixture
{
    [TestCase("64MB", 64L << 20)]
    [TestCase("1.5 gb", 3L << 29)]
    [TestCase("1TB", 1L << 40)]
    public void A_limit_is_a_number_with_a_unit(string text, long bytes) => Assert.That(GeneralOptions.Limit(text).Bytes, Is.EqualTo(bytes));

    [Test]
    public void Half_of_the_machine_is_50_percent()
        => Assert.That(GeneralOptions.Limit("50%").Bytes, Is.EqualTo(MemoryLimit.Default.Bytes));

    [TestCase("")]
    [TestCase("1MB")]
    [TestCase("1000000000")]
    [TestCase("-1GB")]
    [TestCase("nanGB")]
    [TestCase("1e300TB")]
    [TestCase("101%")]
    public void Other_words_are_wrong_usage(string text)
    {
        File.WriteAllText("a.stl", Box(6, 5, 1));
        var run = Run("slice", "a.stl", "--memory-limit", text);
        Assert.That((run.Code, Files()), Is.EqualTo((2, new[] { "a.stl" })), run.Messages);
        Assert.That(run.Messages, Does.Contain("--memory-limit"));
    }

    [Test]
    public void What_takes_more_is_refused_with_advice_and_writes_nothing()
    {
        File.WriteAllText("a.svg", "<svg width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 100\"><circle cx=\"50\" cy=\"50\" r=\"40\"/></svg>");
        string[] words = ["curves", "a.svg", "--distance", "5e-4", "--memory-limit", "64MB"];
        var run = Run(words);
        Assert.That((run.Code, Files()), Is.EqualTo((1, new[] { "a.svg" })), run.Messages);
        Assert.That(run.Messages, Does.Contain("memory.limit").And.Contain("about ").And.Contain("64 MB").And.Contain("--memory-limit 8GB"));
    }

    [Test]
    public void An_image_that_takes_more_is_refused_before_it_is_drawn()
    {
        File.WriteAllText("a.gcode", "G28\nM83\nG1 X10 Y10 Z0.2 F600\nG1 X60 Y10 E2\n");
        var run = Run("image", "a.gcode", "-o", "a.png", "--width", "8000", "--memory-limit", "64MB");
        Assert.That((run.Code, Files()), Is.EqualTo((1, new[] { "a.gcode" })), run.Messages);
        Assert.That(run.Messages, Does.Contain("memory.limit").And.Contain("8000 × 6000 pixels"));
    }

    [Test]
    public void The_runtime_keeps_the_limit_where_estimates_fail()
    {
        MemoryLimit? kept = null;
        using var messages = new StringWriter();
        var session = new Session(() => Stream.Null, () => throw new OutOfMemoryException(), messages) { EnforceMemory = limit => kept = limit };
        Assert.That(App.Run(["printers", "--memory-limit", "100MB"], session), Is.EqualTo(1));
        Assert.That(kept, Is.EqualTo(new MemoryLimit(100 << 20)));
        Assert.That(messages.ToString(), Does.Contain("100 MB").And.Contain("Nothing was written"));
    }
}
