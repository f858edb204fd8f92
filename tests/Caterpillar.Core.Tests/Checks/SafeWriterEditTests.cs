using System.Linq;
using System.Text;
using Caterpillar.Checks;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

public sealed class SafeWriterEditTests
{
    private const string File = "; mine\nM104 S210\nM109 S210\nG90\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 Y10 E0.5 F1200 ; one\nG1 X20 Y20 E0.5\n; end\n";

    private static DecodedGCode Decoded(string text = File)
        => Caterpillar.GCode.GCodeDecoder.Decode(GCodeDocument.FromText(text), new DecodeOptions { Flavor = FlavorTable.Marlin2 }).Value!;

    private static string Text(GCodeDocument document) => Encoding.UTF8.GetString(document.ToBytes());

    [Test]
    public void An_unedited_file_stays_as_it_is()
    {
        var decoding = Decoded();
        Assert.That(Text(SafeWriter.ToDocument(decoding, decoding.Toolpath, new PrintSetup()).Value!), Is.EqualTo(File));
    }

    [Test]
    public void Only_edited_lines_differ()
    {
        var decoding = Decoded();
        var edited = decoding.Toolpath.ScaleSpeed(MoveFilter.Prints, 0.5);
        var lines = Text(SafeWriter.ToDocument(decoding, edited, new PrintSetup()).Value!).Split('\n');
        Assert.That(lines.Take(6), Is.EqualTo(File.Split('\n').Take(6)));
        Assert.That(lines, Has.Member("G1 X20 Y10 E0.5 F600 ; one").And.Member("; end"));
    }

    [Test]
    public void An_edit_off_the_bed_is_refused_and_only_a_reason_overrides_it()
    {
        var decoding = Decoded();
        var edited = decoding.Toolpath.Transform(Caterpillar.Geometry.Affine.Move(new(500, 0)));
        var refused = SafeWriter.ToDocument(decoding, edited, new PrintSetup());
        Assert.That(refused.Value, Is.Null);
        Assert.That(refused.Diagnostics.Select(d => d.Code), Has.Member("bed.outside").And.Member(SafeWriter.Refused));
        Assert.That(SafeWriter.ToDocument(decoding, edited, new PrintSetup(), "!!!").Value, Is.Null);
        var overridden = SafeWriter.ToDocument(decoding, edited, new PrintSetup(), "the table moves");
        Assert.That(Text(overridden.Value!), Does.Contain("Reason: the table moves"));
        Assert.That(overridden.HasErrors, Is.False);
    }

    // Of two extrusions one leaves the bed.
    [Test]
    public void A_single_finding_is_overridden_with_its_comment_too()
    {
        var decoding = GCodeDecoder.Decode(Encoding.ASCII.GetBytes("G28\nM109 S200\nG90\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 E0.5\nG1 X300 E5\nM104 S0\n"))
            .Value!;
        var overridden = SafeWriter.ToDocument(decoding, decoding.Toolpath, new PrintSetup(), "the table moves");
        Assert.That(overridden.Diagnostics.Single(d => d.Code == CheckCodes.Outside).Count, Is.EqualTo(1));
        var lines = Text(overridden.Value!).Split('\n');
        Assert.That(lines.Skip(4).Take(2), Is.EqualTo(new[]
        {
            "; Written despite these findings. Reason: the table moves",
            "; layer 0 -> line 9, move 2: error bed.outside: A move goes to (300, 10, 0.2), outside the build volume of Generic printer: (0, 0, 0) to (220, "
                + "220, 250). Move or scale the print.",
        }));
        Assert.That(lines[8], Is.EqualTo("G1 X300 E5"));
    }

    // The file has 0.006 mm where the edit has none.
    [Test]
    public void An_edit_may_differ_by_six_thousandths()
    {
        var document = GCodeDocument.FromText("G28\nM109 S210\nG90\nM83\nG1 X0.006 Y0.006 Z0.006 F3000\nG1 X20 E0.006 F1200\nM104 S0\n");
        var decoding = GCodeDecoder.Decode(document).Value!;
        Assert.That(decoding.Toolpath[1].E, Is.EqualTo(0.006));
        var edited = new ToolpathBuilder(MoveSource.Lines, null);
        edited.Add(Vec3.Zero, 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 0, 5);
        edited.Add(new Vec3(20, 0.006, 0.006), 0, 0, 20, MoveKind.Print, Role.Unspecified, -1, 0, 6);
        var findings = EditCheck.Run(decoding, edited.Build(decoding.Toolpath.Tools), document, new PrintSetup(), null, default);
        Assert.That(findings.Where(d => d.Code is CheckCodes.FilePosition or CheckCodes.FileExtrusion), Is.Empty);
    }

    // An extrusion of 2 mm with 0.1 mm of filament that the edit divides: a tenth of a percent and 0.006 mm of each sum may be lost.
    [TestCase(0, 0, null)]
    [TestCase(0.0078, 0, null)]
    [TestCase(0.0082, 0, CheckCodes.FilePosition)]
    [TestCase(-0.0082, 0, CheckCodes.FilePosition)]
    [TestCase(0, 0.006, null)]
    [TestCase(0, 0.0063, CheckCodes.FileExtrusion)]
    [TestCase(0, -0.0063, CheckCodes.FileExtrusion)]
    public void Sums_are_compared_where_an_edit_divides_moves(double length, double e, string? code)
    {
        var document = GCodeDocument.FromText("G28\nM109 S210\nG90\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X12 E0.1 F1200\nM104 S0\n");
        var decoding = GCodeDecoder.Decode(document).Value!;
        var edited = new ToolpathBuilder(MoveSource.Lines, null);
        edited.Add(new Vec3(10, 10, 0.2), 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 0, 5);
        edited.Add(new Vec3(11, 10, 0.2), 0.05, 0.05, 20, MoveKind.Print, Role.Unspecified, -1, 0, 6);
        edited.Add(new Vec3(12 + length, 10, 0.2), 0.05 + e, 0.05 + e, 20, MoveKind.Print, Role.Unspecified, -1, 0, 6);
        var findings = EditCheck.Run(decoding, edited.Build(decoding.Toolpath.Tools), document, new PrintSetup(), null, default);
        var found = findings.Select(d => d.Code).Where(c => c is CheckCodes.FilePosition or CheckCodes.FileExtrusion);
        Assert.That(found, Is.EqualTo(code is null ? [] : new[] { code }));
    }
}
