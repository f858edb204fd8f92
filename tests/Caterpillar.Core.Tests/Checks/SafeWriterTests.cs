using System;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

[Category("Runtime")]
public class SafeWriterTests
{
    private string _folder = "";

    [SetUp]
    public void MakeFolder()
    {
        _folder = Path.Combine(Path.GetTempPath(), "caterpillar-" + Path.GetRandomFileName());
        Directory.CreateDirectory(_folder);
    }

    [TearDown]
    public void RemoveFolder() => Directory.Delete(_folder, true);

    [Test]
    public void A_valid_print_is_written_and_replaces_an_older_file()
    {
        var file = Path.Combine(_folder, "part.gcode");
        File.WriteAllText(file, "old");
        var written = SafeWriter.WriteFile(Line(50), new PrintSetup(), file).Value!;
        Assert.That(new FileInfo(file).Length, Is.EqualTo(written.Bytes));
        Assert.That(File.ReadAllLines(file), Has.Length.EqualTo(written.Lines).And.Some.StartsWith("G1 X50 "));
        Assert.That(Directory.GetFiles(_folder), Has.Length.EqualTo(1));
    }

    [Test]
    public void A_name_that_ends_in_bgcode_requests_binary_code()
    {
        var file = Path.Combine(_folder, "part.bgcode");
        Assert.That(SafeWriter.WriteFile(Line(50), new PrintSetup(), file).Value, Is.Not.Null);
        Assert.That(File.ReadAllBytes(file)[0], Is.EqualTo((byte)'G'));
        var text = SafeWriter.ToDocument(Line(50), new PrintSetup()).Value!;
        var code = GCodeDocument.ReadFile(file).Value!.Lines(1, 10_000).Where(l => l.Length > 0 && l[0] != ';');
        Assert.That(code, Is.EqualTo(text.Lines(1, 10_000).Where(l => l.Length > 0 && l[0] != ';')));
    }

    [Test]
    public void What_would_leave_the_bed_is_refused_and_leaves_the_older_file_alone()
    {
        var file = Path.Combine(_folder, "part.gcode");
        File.WriteAllText(file, "old");
        var refused = SafeWriter.WriteFile(Line(500), new PrintSetup(), file);
        Assert.That(refused.Value, Is.Null);
        Assert.That(refused.Diagnostics.Select(d => d.Code), Is.SupersetOf(new[] { "bed.outside", SafeWriter.Refused }));
        Assert.That(File.ReadAllText(file), Is.EqualTo("old"));
        Assert.That(Directory.GetFiles(_folder), Has.Length.EqualTo(1));
    }

    // Also where a file is written twice, and where it is edited.
    [Test]
    public void Progress_ascends_from_0_to_1()
    {
        var setup = new PrintSetup();
        var decoding = GCodeDecoder.Decode(SafeWriter.ToDocument(Line(50), setup).Value!).Value!;
        Action<IProgress<double>>[] all =
        [
            p => SafeWriter.Write(Line(50), setup, new MemoryStream(), null, p), p => SafeWriter.Write(Line(500), setup, new MemoryStream(), "a test", p),
            p => SafeWriter.Write(Line(50), setup, new MemoryStream(), null, p, isDraft: true),
            p => SafeWriter.Write(Line(500), setup, new MemoryStream(), "a test", p, isDraft: true),
            p => SafeWriter.ToDocument(decoding, decoding.Toolpath, setup, null, null, p),
            p => SafeWriter.ToDocument(decoding, decoding.Toolpath.Transform(Affine.Move(new(500, 0))), setup, "a test", null, p),
        ];
        foreach (var write in all)
        {
            var shares = new Shares();
            write(shares);
            Assert.That(shares.All, Is.Ordered.And.All.InRange(0, 1));
            Assert.That(shares.All.Last(), Is.EqualTo(1));
        }
    }

    private static readonly double[] NoNumbers = [double.NaN, double.PositiveInfinity, double.NegativeInfinity, 1e300, -1e9];

    [TestCaseSource(nameof(NoNumbers))]
    public void Numbers_that_cannot_be_written_are_refused_whatever_the_reason(double value)
    {
        Toolpath Moves(double x, double e, double speed, PrinterEvent? what = null)
        {
            var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(0, 0, 10));
            builder.Add(new Vec3(50, 50, 0.2), 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
            if (what is not null) builder.AddEvent(what);
            builder.Add(new Vec3(x, 50, 0.2), e, e, speed, MoveKind.Print, Role.Unspecified, -1, 0, 0);
            return builder.Build([new ToolpathTool(2.4)]);
        }
        Toolpath[] all =
        [
            Moves(value, 1, 20), Moves(60, value, 20), Moves(60, 1, value), Moves(60, 1, 20, new NozzleTemperatureEvent(value)),
            Moves(60, 1, 20, new BedTemperatureEvent(value)), Moves(60, 1, 20, new AccelerationEvent(value)), Moves(60, 1, 20, new DwellEvent(value)),
            Moves(60, 1, 20, new FanEvent(value)), Moves(60, 1, 20, new LimitEvent(MotionLimit.SpeedX, value)),
        ];
        for (var i = 0; i < all.Length; i++)
        {
            var refused = SafeWriter.ToDocument(all[i], new PrintSetup(), "A good reason");
            Assert.That(refused.Value, Is.Null, $"number {i}");
            Assert.That(refused.Diagnostics.Where(d => d.Severity == Severity.Error).Select(d => d.Code), Has.Some.EqualTo(SafeWriter.Refused), $"number {i}");
        }
    }

    [TestCase(null, "Nothing was written.")]
    [TestCase("", "An override needs a reason in words.")]
    [TestCase("   ", "An override needs a reason in words.")]
    [TestCase("1", "An override needs a reason in words.")]
    public void An_override_needs_a_reason(string? reason, string message)
    {
        var refused = SafeWriter.ToDocument(Line(500), new PrintSetup(), reason);
        Assert.That(refused.Value, Is.Null);
        Assert.That(refused.Diagnostics.Single(d => d.Code == SafeWriter.Refused).Message, Is.EqualTo(message));
    }

    // A draft is written while it is checked, whether its stream can go back or not; only with a reason it has to.
    [TestCase(null, true, true, true)]
    [TestCase(null, true, false, true)]
    [TestCase("1", true, false, true)]
    [TestCase(null, false, true, false)]
    [TestCase(null, false, false, false)]
    public void What_is_refused_is_in_drafts_only(string? reason, bool isDraft, bool canSeek, bool written)
    {
        using var stream = new PlainStream(canSeek);
        var refused = isDraft ? SafeWriter.Write(Line(500), new PrintSetup(), stream, reason, isDraft: true)
            : SafeWriter.Write(Line(500), new PrintSetup(), stream, reason);
        Assert.That((refused.Value is null, stream.Length > 0), Is.EqualTo((true, written)));
    }

    [Test]
    public void An_override_to_a_stream_that_cannot_go_back_is_written_once([Values] bool isDraft, [Values] bool canSeek)
    {
        using var stream = new PlainStream(canSeek);
        var written = isDraft ? SafeWriter.Write(Line(500), new PrintSetup(), stream, "a test", isDraft: true)
            : SafeWriter.Write(Line(500), new PrintSetup(), stream, "a test");
        Assert.That(stream.ToArray(), SameBytes.As(SafeWriter.ToDocument(Line(500), new PrintSetup(), "a test").Value!.ToBytes()));
        Assert.That((written.Value!.Bytes, written.Value.Overridden), Is.EqualTo((stream.Length, 1)));
    }

    [Test]
    public void A_reason_overrides_and_stays_in_the_file()
    {
        var written = SafeWriter.ToDocument(Line(500), new PrintSetup(), "The bed was\nlengthened");
        var text = Encoding.ASCII.GetString(written.Value!.ToBytes());
        Assert.That(text, Does.Contain("Reason: The bed was lengthened\n").And.Contain("bed.outside"));
        Assert.That(text.Split('\n').Where(l => l.Length > 0 && !l.StartsWith(";", StringComparison.Ordinal)).First(), Does.StartWith("G"));
        Assert.That(written.Diagnostics.Single(d => d.Code == "bed.outside").Severity, Is.EqualTo(Severity.Warning));
    }

    [Test]
    public void A_missing_folder_is_an_error_of_the_disk()
        => Assert.That(() => SafeWriter.WriteFile(Line(50), new PrintSetup(), Path.Combine(_folder, "no", "part.gcode")), Throws.InstanceOf<IOException>());

    [Test]
    public void Canceling_leaves_no_files()
    {
        using var cancel = new System.Threading.CancellationTokenSource();
        cancel.Cancel();
        Assert.That(() => SafeWriter.WriteFile(Line(50), new PrintSetup(), Path.Combine(_folder, "part.gcode"), cancel: cancel.Token),
            Throws.InstanceOf<OperationCanceledException>());
        Assert.That(Directory.GetFiles(_folder), Is.Empty);
    }

    private static Toolpath Line(double to)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 0.2));
        builder.Add(new Vec3(to, 10, 0.2), 0.5, 0.5, 20, MoveKind.Print, Role.OuterWall, -1, 0, 0);
        return builder.Build([new ToolpathTool(new PrintSetup().Extrusion.VolumePerE)]);
    }

    private sealed class PlainStream(bool canSeek) : MemoryStream
    {
        public override bool CanSeek => canSeek;
    }
}
