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
}
