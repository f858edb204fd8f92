using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>Edits of toolpaths with rotary words: what is added turns no tool.</summary>
[Category("Arithmetic")]
public class RotaryBlockTests
{
    private static readonly Vec3 Leaning = new(30, 40, 50);
    private static readonly PrintSetup Lifting = new() { Printer = new Printer { PauseLift = 2 } };

    // A whole block whose last move turns the tool, then a block of six moves without words: two in the first layer, and of the others every second is support.
    private static readonly Toolpath TwoBlocks = Printed(ToolpathBlock.Capacity + 6, i => i < ToolpathBlock.Capacity + 2 ? 0 : 1,
        i => i == ToolpathBlock.Capacity - 1 ? Leaning : null);

    private static readonly MoveFilter Support = new() { Roles = new HashSet<Role> { Role.Support } };

    private static Toolpath Printed(int count, System.Func<int, int> layer, System.Func<int, Vec3?> words)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var k = 0; k < 3; k++) builder.AddLayer(new Layer(k, 0.2 * (k + 1), 0.2));
        for (var i = 0; i < count; i++)
        {
            builder.Add(new Vec3(i % 2 * 10, i % 3, 0.2 * (layer(i) + 1)), 1, 1, 20, MoveKind.Print,
                i >= ToolpathBlock.Capacity && i % 2 == 1 ? Role.Support : Role.Infill, layer(i), 0, i);
            if (words(i) is { } turns) builder.SetRotary(turns);
        }
        return builder.Build([new ToolpathTool(2.4)]);
    }

    private static IEnumerable<Vec3> WordsFrom(Toolpath toolpath, int first)
        => Enumerable.Range(first, toolpath.Count - first).Select(toolpath.WordsAt);

    [Test]
    public void What_is_added_to_a_block_keeps_the_tool_as_the_block_before_has_left_it()
    {
        Toolpath[] edited = [TwoBlocks.PauseAtLayer(1, Lifting).Value!, TwoBlocks.Remove(Support),
            TwoBlocks.Deform(Support, p => p + Vec3.UnitY), PrintCut.At(TwoBlocks, 0.2).Value!.Lower()];
        foreach (var toolpath in edited)
        {
            Assert.That(toolpath.Blocks[0], Is.SameAs(TwoBlocks.Blocks[0]));
            Assert.That(toolpath.Blocks[1], Is.Not.SameAs(TwoBlocks.Blocks[1]));
            Assert.That(WordsFrom(toolpath, ToolpathBlock.Capacity - 1), Is.All.EqualTo(Leaning));
        }
    }

    [Test]
    public void An_upper_half_is_reached_with_the_tool_as_its_first_extrusion_begins()
    {
        var turning = Printed(9, i => i / 3, i => new Vec3(i, 10 * i, 100 * i));
        var upper = PrintCut.At(turning, 0.2).Value!.Upper();
        Assert.That(WordsFrom(upper, 0).Select(w => w.X), Is.EqualTo(new[] { 2.0, 2, 3, 4, 5, 6, 7, 8 }));
        // It begins with the second block.
        Assert.That(WordsFrom(PrintCut.At(Printed(ToolpathBlock.Capacity + 6, i => i < ToolpathBlock.Capacity ? 0 : 1,
            i => i == ToolpathBlock.Capacity - 1 ? Leaning : null), 0.2).Value!.Upper(), 0), Is.All.EqualTo(Leaning));
    }

    [Test]
    public void A_print_with_one_move_in_each_layer_can_be_cut()
    {
        var cut = PrintCut.At(Printed(2, i => i, _ => null), 0.2).OrThrow();
        Assert.That(cut.Lower().Moves().Count(m => m.Kind == MoveKind.Print), Is.EqualTo(1));
        Assert.That(cut.Upper().Moves().Count(m => m.Kind == MoveKind.Print), Is.EqualTo(1));
    }

    [Test]
    public void Without_rotary_words_none_are_made()
    {
        var plain = Printed(9, i => i / 3, _ => null);
        Assert.That(PrintCut.At(plain, 0.2).Value!.Upper().HasTurns || plain.PauseAtLayer(1, Lifting).Value!.HasTurns, Is.False);
    }
}
