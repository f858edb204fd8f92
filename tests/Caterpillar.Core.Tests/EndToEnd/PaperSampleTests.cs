using System.Linq;
using System.Text;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.EndToEnd;

/// <summary>The three lines of G-code that the Caterpillar paper (Zheng 2019) prints.</summary>
public class PaperSampleTests
{
    private const string Sample =
        "G1 X65.7029 Y67.4932 Z44.1218 E0 F2160.0000\nG1 X65.7029 Y68.4932 Z40.1287 E1.3947 F2160.0000\nG1 X66.6977 Y67.4932 Z40.2310 E1.5861 F1440.0000\n";

    [Test]
    public void By_the_rule_of_the_paper_a_move_prints_when_E_rises()
        => Assert.That(Kinds("G92 E0\n" + Sample, ExtrusionRule.Rising), Is.EqualTo(new[] { MoveKind.Travel, MoveKind.Print, MoveKind.Print }));

    [Test]
    public void By_the_balance_the_descent_after_a_retraction_only_restores()
    {
        // 1.3947 mm are retracted during the move to the first point, and restored during the descent.
        var moves = Decode("G92 E1.3947\n" + Sample, ExtrusionRule.Balance);
        Assert.That(moves.Select(m => m.Kind), Is.EqualTo(new[] { MoveKind.Wipe, MoveKind.MovingDeretract, MoveKind.Print }));
        Assert.That(moves.Sum(m => m.Deposited), Is.EqualTo(1.5861 - 1.3947).Within(1e-9));
        // 0.1353 mm of filament per mm of the third line.
        Assert.That(moves[2].Deposited / moves[2].Length, Is.EqualTo(0.1353).Within(5e-5));
        Assert.That(moves.Select(m => m.Speed), Is.EqualTo(new double[] { 36, 36, 24 }));
    }

    [Test]
    public void Without_an_earlier_retraction_both_rules_agree()
        => Assert.That(Kinds("G92 E0\n" + Sample, ExtrusionRule.Balance), Is.EqualTo(Kinds("G92 E0\n" + Sample, ExtrusionRule.Rising)));

    private static MoveKind[] Kinds(string text, ExtrusionRule rule) => Decode(text, rule).Select(m => m.Kind).ToArray();

    private static Move[] Decode(string text, ExtrusionRule rule)
        => Caterpillar.GCode.GCodeDecoder.Decode(Encoding.ASCII.GetBytes(text), new DecodeOptions { Flavor = FlavorTable.Marlin2, Rule = rule })
            .Value!.Toolpath.Moves().ToArray();
}
