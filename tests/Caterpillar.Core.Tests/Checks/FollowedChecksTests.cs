using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>What is printed is checked block by block while the file is still being written and read.</summary>
[Category("Runtime")]
public sealed class FollowedChecksTests
{
    private static readonly PrintSetup Setup = SmallPrint.Setup(p => p with { ProgressCommands = false });

    private static IEnumerable<double> Thicknesses() => Rounds.Some([0.2, 0], 2);

    [TestCaseSource(nameof(Thicknesses))]
    public void A_print_of_several_blocks_has_the_findings_of_the_whole_file(double thickness)
    {
        var toolpath = Long(thickness);
        Assert.That(toolpath.Blocks.Count, Is.GreaterThan(1));
        var file = SmallPrint.Written(toolpath, Setup).File;
        var whole = PrintCheck.Run(file.Toolpath.With(tools: toolpath.Tools), Setup);

        var shares = new Shares();

        var written = SafeWriter.Write(toolpath, Setup, new MemoryStream(), null, shares, isDraft: true);

        Assert.That(shares.All, Is.Ordered.And.All.InRange(0, 1));
        Assert.That(shares.All[0], Is.LessThan(0.5));
        Assert.That(shares.All.Last(), Is.EqualTo(1));
        var expected = whole.Where(IsOfPrints).Select(Told).ToArray();
        Assert.That(expected.Select(d => d.Code), Does.Contain(CheckCodes.TravelHits).And.Contain(CheckCodes.Unsupported));
        Assert.That(expected.Single(d => d.Code == CheckCodes.TravelHits).Count, Is.GreaterThan(2), "in the first block and in the last");
        Assert.That(written.Diagnostics.Where(IsOfPrints).Select(Told), Is.EqualTo(expected));
    }

    // Then the heights of its extrusions make the layers: those of the plan, unless other lines print between them or begin layers.
    [TestCase("")]
    [TestCase("G1 X21 Y30 Z0.3 F600\nG1 X21 Y31 E0.05")]
    [TestCase(";LAYER:7")]
    public void A_print_without_layers_has_the_findings_of_the_whole_file(string raw)
    {
        var toolpath = Long(null);
        if (raw.Length > 0) toolpath = toolpath.Insert(toolpath.Count - 100, new RawEvent(raw));
        var file = SmallPrint.Written(toolpath, Setup).File;
        var whole = PrintCheck.Run(file.Toolpath.With(tools: toolpath.Tools), Setup);

        var written = SafeWriter.Write(toolpath, Setup, new MemoryStream(), isDraft: true);

        var expected = whole.Where(IsOfPrints).Select(Told).ToArray();
        Assert.That(expected.Select(d => d.Code), Does.Contain(CheckCodes.TravelHits).And.Contain(CheckCodes.Unsupported));
        Assert.That(written.Diagnostics.Where(IsOfPrints).Select(Told), Is.EqualTo(expected));
    }

    // Purging in start code is a layer, too, if it is printed at a height of its own.
    [Test]
    public void Blocks_of_a_file_without_layers_know_their_thickness_from_the_heights_of_the_plan()
    {
        var toolpath = Long(null);
        var text = "M83\nG1 X1 Y1 Z0.7 F600\nG1 X9 E1\n" + SmallPrint.Written(toolpath, Setup).Text;
        var blocks = new List<DecodedBlock>();
        var options = new DecodeOptions { Take = blocks.Add, Heights = FlatHeights.Of(toolpath, 3) };

        var file = GCodeDecoder.DecodeStream(new MemoryStream(Encoding.UTF8.GetBytes(text)), options).Value!;

        Assert.That(file.HasExpectedLayers);
        Assert.That(blocks, Has.Count.GreaterThan(1));
        Assert.That(blocks.Select(b => b.Thicknesses), Is.All.EqualTo(file.Toolpath.Layers.Select(l => l.Thickness)));
        var other = GCodeDecoder.DecodeStream(new MemoryStream(Encoding.UTF8.GetBytes(text)), options with { Heights = [0.2, 99] }).Value!;
        Assert.That(other.HasExpectedLayers, Is.False);
        Assert.That(other.Toolpath.Layers, Is.EqualTo(file.Toolpath.Layers));
    }

    // Only its end says how high a print is.
    [Test]
    public void A_slender_print_is_named_while_it_is_written()
    {
        var tower = new SmallPrint().Wall(50, 55, 50, 30).Build();
        var found = SafeWriter.Write(tower, Setup, new MemoryStream(), isDraft: true).Diagnostics.Single(d => d.Code == CheckCodes.FirstLayer);
        Assert.That(found.Message, Is.EqualTo(SmallPrint.Find(tower, Setup, CheckCodes.FirstLayer).Single().Message));
    }

    // While it is written, and while it is checked.
    [TestCase(0.3)]
    [TestCase(0.6)]
    public void A_long_print_is_canceled_with_the_callers_own_token(double share)
    {
        var toolpath = Long(0.2);
        using var source = new CancellationTokenSource();
        var progress = new CancelAt(share, source);

        var thrown = Assert.Catch<OperationCanceledException>(
            () => SafeWriter.Write(toolpath, Setup, new MemoryStream(), null, progress, source.Token, isDraft: true))!;

        Assert.That(thrown.CancellationToken, Is.EqualTo(source.Token));
    }

    [Test]
    public void An_overridden_draft_begins_where_the_stream_stood()
    {
        var hits = new SmallPrint().Wall(10, 60, 30, 2).Go(At, 30, 200).Go(At, 30, 1).Go(At, 60, 1).Build();
        using var stream = new MemoryStream();
        stream.Write(Encoding.ASCII.GetBytes("before\n"), 0, 7);
        using var alone = new MemoryStream();

        var written = SafeWriter.Write(hits, Setup, stream, "a test", isDraft: true);
        SafeWriter.Write(hits, Setup, alone, "a test", isDraft: true);

        Assert.That(written.Value!.Overridden, Is.GreaterThan(0));
        var text = Encoding.UTF8.GetString(stream.ToArray());
        Assert.That(text, Does.StartWith("before\n; Written despite these findings. Reason: a test\n"));
        Assert.That(text.Substring(7), Is.EqualTo(Encoding.UTF8.GetString(alone.ToArray())));
        Assert.That(written.Value.Bytes, Is.EqualTo(alone.Length));
    }

    private const double At = 35;

    // Lines of 2 mm beside each other in layers; a travel through what is printed near the beginning, twice near the end, and extrusions in the air.
    private static Toolpath Long(double? thickness)
    {
        const int Lines = 1100, Layers = 62;
        var print = new SmallPrint();
        for (var layer = 0; layer < Layers; layer++)
        {
            var z = 0.2 * (layer + 1);
            if (thickness is { } height) print.InLayer(new Layer(layer, z, height, ""));
            print.Over(20, 20, z);
            for (var i = 0; i < Lines / 2; i++)
            {
                var y = 20 + 0.2 * i;
                print.Print(i % 2 == 0 ? 22 : 20, y, z).Print(i % 2 == 0 ? 22 : 20, y + 0.2, z);
            }
            if (layer is 3 or 60 or 61) print.Over(21, 10, 0.1).Go(21, 100, 0.1);
            if (layer is 4 or 61) print.Over(100, 20, 30).Print(112, 20, 30);
        }
        return print.Go(At, At, 200).Build();
    }

    private static bool IsOfPrints(Diagnostic d)
        => d.Code.StartsWith("extrusion.", StringComparison.Ordinal) || d.Code.StartsWith("collision.", StringComparison.Ordinal);

    private static (string Code, Severity Severity, int Count, int? Line, string Message) Told(Diagnostic d)
        => (d.Code, d.Severity, d.Count, d.Source?.Line, d.Message);

    private sealed class CancelAt(double share, CancellationTokenSource source) : IProgress<double>
    {
        public void Report(double value)
        {
            if (value >= share) source.Cancel();
        }
    }
}
