using System;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.EndToEnd;

/// <summary>Input of sizes that nobody expects takes neither long nor much memory, and can be canceled.</summary>
public class OddInputTests
{
    [Test]
    public void A_package_that_grows_a_thousandfold_is_refused_before_it_is_read()
    {
        using var memory = new MemoryStream();
        using (var zip = new ZipArchive(memory, ZipArchiveMode.Create, true))
        {
            using var model = zip.CreateEntry("3D/box.model").Open();
            var spaces = Encoding.ASCII.GetBytes(new string(' ', 1 << 20));
            for (var i = 0; i < 65; i++) model.Write(spaces, 0, spaces.Length);
        }
        var read = MeshReader.Read(memory.ToArray(), "bomb.3mf");
        Assert.That(read.Value, Is.Null);
        Assert.That(read.Diagnostics.Single().ToString(),
            Is.EqualTo("bomb.3mf: 3D/box.model: error mesh.compression: It decompresses to more than 250 times its size."));
    }

    [Test]
    public void A_line_of_more_words_than_any_firmware_reads_is_not_understood()
    {
        var lines = "G1 X1 Y1\nG1 " + string.Concat(Enumerable.Repeat("X2 y1 ", 20_000)) + "\nG1 X3\n";
        var toolpath = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(lines)).OrThrow().Toolpath;
        Assert.That(toolpath.Moves().Select(m => m.End.X), Is.EqualTo(new[] { 1.0, 3.0 }));
    }

    [Test]
    public void Arcs_larger_than_any_printer_have_few_pieces_and_the_same_time()
    {
        const double Radius = 1e6;
        var toolpath = GCodeDecoder.Decode(Encoding.ASCII.GetBytes("G90\nG1 X0 Y0 F6000\nG2 X0 Y0 I1000000\n")).OrThrow().Toolpath;
        var timeline = Timeline.Of(toolpath, new PrintSetup());
        Assert.That(timeline.Trapezoids().Count(), Is.LessThan(20_000));
        Assert.That(timeline.Duration, Is.EqualTo(2 * Math.PI * Radius / 100).Within(0.1).Percent);
    }

    [Test]
    public void Checking_stops_within_one_long_move()
    {
        var setup = new PrintSetup();
        var toolpath = GCodeDecoder.Decode(Encoding.ASCII.GetBytes("M83\nG1 X50 Y50 Z0.2\nG2 I5 P90000 E5000\n")).OrThrow().Toolpath;
        var last = toolpath.Moves().Last();
        var move = new CheckedMove { Start = last.Start, End = last.End, StartKnown = true, Arc = last.Arc, Kind = last.Kind, Length = last.Length };
        var check = new DepositCheck(setup, new Findings(setup.Printer, toolpath), new CancellationToken(true));
        Assert.That(move.Arc, Is.Not.Null);
        Assert.That(() => check.Move(move), Throws.InstanceOf<OperationCanceledException>());
    }
}
