using System;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.GCode;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>A file without a command says what it looks like.</summary>
public class FileKindTests
{
    [TestCase("", "is empty")]
    [TestCase(" \n\r\n\n", "blank lines")]
    [TestCase("Dear all,\nplease find the model enclosed.\n", "contains no commands")]
    [TestCase("; only a comment\n(another)\n", "contains no commands")]
    [TestCase("solid part\n  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n", "ASCII STL")]
    [TestCase("# made by hand\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "OBJ")]
    [TestCase("ply\nformat ascii 1.0\nelement vertex 3\n", "PLY")]
    [TestCase("{ \"layers\": 3,\n \"G1\": 2 }\n", "JSON")]
    [TestCase("<?xml version=\"1.0\"?>\n<svg width=\"3\"><path d=\"M 0 0\"/></svg>\n", "SVG")]
    [TestCase("<html><body>G1 X0</body></html>\n", "HTML")]
    [TestCase("PK\u0003\u0004\nG1\nx\u0000\u0001", "3MF")]
    [TestCase("\u0089PNG\r\n\u001a\n\u0000\u0000", "PNG")]
    [TestCase("%PDF-1.4\n", "PDF")]
    [TestCase("\u00ff\u00fe;\u0000\nG1 X5 E1\n", "UTF-16")]
    [TestCase("abc\u0000\u0001\u0002def\n", "binary data")]
    public void What_is_no_G_code_says_what_it_looks_like(string text, string kind)
        => Assert.That(Decode(Encoding.GetEncoding(28591).GetBytes(text)).NotGCode?.Message, Does.StartWith("The file is not G-code. It ").And.Contain(kind));

    [Test]
    public void A_binary_mesh_is_known_by_its_size()
    {
        var bytes = new byte[84 + 50 * 3];
        bytes[80] = 3;
        Assert.That(Decode(bytes).NotGCode?.Message, Does.Contain("binary STL"));
    }

    [Test]
    public void A_line_that_looks_like_a_command_makes_no_G_code_of_an_archive()
    {
        var bytes = new byte[] { (byte)'P', (byte)'K', 3, 4, (byte)'\n' }.Concat(Enumerable.Range(0, 400).SelectMany(_ => new byte[] { 200, 7, 10 }))
            .Concat(Encoding.ASCII.GetBytes("G1 X5\n")).ToArray();
        Assert.That(Decode(bytes).NotGCode, Is.Not.Null);
    }

    [TestCase("G28")]
    [TestCase("M84")]
    [TestCase("T0")]
    [TestCase("N1 G1 X5*99")]
    [TestCase("; text\n; text\n; text\nM104 S200\n")]
    [TestCase("{if x}\nG1 X5\n{endif}\nM104 S[temperature]\n")]
    public void A_command_makes_G_code(string text) => Assert.That(Decode(Encoding.ASCII.GetBytes(text)).NotGCode, Is.Null);

    [Category("Arithmetic")]
    [TestCaseSource(typeof(GCodeFiles), nameof(GCodeFiles.All))]
    public void Files_of_slicers_are_G_code(string file)
    {
        using var stream = new MemoryStream(GCodeFiles.Document(file).ToBytes());
        Assert.That(GCodeDecoder.DecodeStream(stream).Value!.NotGCode, Is.Null);
    }

    private static DecodedGCode Decode(byte[] bytes) => GCodeDecoder.Decode(bytes).Value ?? throw new InvalidOperationException("Nothing was decoded.");
}
