using Caterpillar.Basics;
using NUnit.Framework;

namespace Caterpillar.Tests.Basics;

public class SourceLocationTests
{
    [Test]
    public void Sources_are_written_from_file_to_move()
    {
        Assert.That(new SourceLocation { Line = 3, Column = 4 }.ToString(), Is.EqualTo("line 3:4"));
        Assert.That(new SourceLocation { Key = "speed", Step = 1, Move = 76 }.ToString(), Is.EqualTo("speed, step 1, move 76"));
        Assert.That(new SourceLocation { Step = 1 }.ToString(), Is.EqualTo("step 1"));
        Assert.That(new SourceLocation { Move = 2 }.ToString(), Is.EqualTo("move 2"));
        Assert.That(new SourceLocation { File = "a.gcode", Line = 3 }.ToString(), Is.EqualTo("a.gcode:3"));
    }

    [Test]
    public void Names_in_files_cannot_control_a_terminal()
    {
        const string Name = "a\u001B[2J\u009B31m\u202Etxt.b";
        const string Shown = @"a\u001B[2J\u009B31m\u202Etxt.b";
        var finding = new Diagnostic(Severity.Note, "a.b", $"The object {Name} is\ttoo large.", new SourceLocation(Name + "\r\nc", Key: Name));
        Assert.That(finding.Message, Is.EqualTo($"The object {Shown} is\ttoo large."));
        Assert.That(finding.ToString(), Does.StartWith(Shown + @"\r\nc: " + Shown));
        Assert.That(new Diagnostic(Severity.Note, "a.b", "Größe 3 µm, 日本 🙂").Message, Is.EqualTo("Größe 3 µm, 日本 🙂"));
    }
}
