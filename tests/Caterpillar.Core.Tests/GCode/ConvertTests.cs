using System.Text;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>A converted file makes the same print.</summary>
public class ConvertTests
{
    [Test]
    public void Lines_that_mean_the_same_stay()
    {
        const string Text = "; head\nG21\nG90\nM82 ; absolute\nG92 E0\nG1 X1 Y1 Z.2 F1800\nG1 X5 E.5 ; a\nG1 X9 E1\nM106 S255\n";
        Assert.That(ConvertText(Text, new ConvertOptions { RelativeE = true }, "slicer"), Is.EqualTo(
            "; head\nG21\nG90\nG92 E0\nG1 X1 Y1 Z.2 F1800\nM83\nG1 X5 E.5 ; a\nG1 X9 E.5\nM106 S255\n"));
    }

    [Test]
    public void An_A_axis_becomes_E()
    {
        const string Text = "G21\nG90\nG1 X1 Y1 Z.2 F1800\nG1 X5 A.5\nG92 A0\nG1 X9 A1\n";
        Assert.That(ConvertText(Text, new ConvertOptions { Flavor = FlavorTable.Marlin2, RelativeE = false }, "cnc"), Is.EqualTo(
            "; Flavor marlin2\nG21\nG90\nG1 X1 Y1 Z.2 F1800\nG1 X5 E.5\nG92 E0\nG1 X9 E1\n"));
    }

    [Test]
    public void Volumes_become_lengths()
    {
        const string Text = "M83\nG1 X1 Y1 Z.2 F1800\nG1 X5 E2.40528\n; use_volumetric_e = 1\n";
        Assert.That(ConvertText(Text, new ConvertOptions { Volumetric = false, FilamentDiameter = 1.75 }, "slicer"), Does.Contain("G1 X5 E1\n"));
    }

    [Test]
    public void Dwells_pauses_tools_and_bare_G92_are_translated()
    {
        const string Text = "M83\nG28\nG1 X10 Y0 Z1 F600\nG4 P1500\nM0\nT1\nG92\nG1 X5 E1\n";
        Assert.That(ConvertText(Text, new ConvertOptions { Flavor = FlavorTable.Find("reprapfirmware")! }, "klipper"), Does.Contain("G92 X0 Y0 Z0 E0\n"));
        Assert.That(ConvertText(Text, new ConvertOptions { Flavor = FlavorTable.Find("cnc")! }, "marlin2"), Does.Contain("G4 P1.5\n").And.Contain("M6 T1\n"));
        Assert.That(ConvertText(Text, new ConvertOptions { Flavor = FlavorTable.Find("reprapfirmware")! }, "slicer"), Does.Contain("M226\n"),
            "M0 would end the print");
        Assert.That(ConvertText(Text, new ConvertOptions { Flavor = FlavorTable.Klipper }, "slicer"), Does.Contain("PAUSE\n"));
    }

    [Test]
    public void Arcs_and_inches_are_expanded_where_the_target_has_none()
    {
        const string Text = "G20\nG90\nM83\nG1 X1 Y0 Z0.1 F60\nG3 X0 Y1 I-1 J0 E0.1\nG2 X1 Y0 R1 E0.1\nG91\nG3 X-1 Y1 I-1 J0 E0.1\n";
        var text = ConvertText(Text, new ConvertOptions { Flavor = FlavorTable.Klipper }, "slicer");
        Assert.That(text, Does.Not.Contain("G20").And.Not.Contain("R1"));
        var expected = Decode(GCodeDocument.FromText(Text), FlavorTable.Slicer).Report;
        var back = Decode(GCodeDocument.FromText(text), FlavorTable.Klipper).Report;
        Assert.That(back.PrintLength, Is.EqualTo(expected.PrintLength).Within(0.05));
        Assert.That(back.EUsed, Is.EqualTo(expected.EUsed).Within(1e-4));
    }

    [Test]
    public void Firmware_retraction_becomes_a_length()
    {
        const string Text = "M83\nG1 X1 Y1 Z.2 F1800\nG1 X5 E1\nG10\nG1 X9\nG11\nG1 X12 E1\n";
        var text = ConvertText(Text, new ConvertOptions { Flavor = FlavorTable.Find("sailfish")!, RetractionLength = 1.5, RetractionSpeed = 40 }, "slicer");
        Assert.That(text, Does.Contain("G1 E-1.5 F2400\n").And.Contain("G1 E1.5 F2400\n"));
        Assert.That(Decode(GCodeDocument.FromText(text), FlavorTable.Find("sailfish")!).Report.EUsed, Is.EqualTo(2).Within(1e-6));
    }

    private static GCodeDocument Convert(DecodedGCode decoding, ConvertOptions options)
    {
        var result = GCodeConverter.ToDocument(decoding, options);
        Assert.That(result.Value, Is.Not.Null, string.Join("\n", result.Diagnostics));
        return result.Value!;
    }

    private static string ConvertText(string text, ConvertOptions options, string flavor)
        => Encoding.ASCII.GetString(Convert(Decode(GCodeDocument.FromText(text), FlavorTable.Find(flavor)!), options).ToBytes());

    private static DecodedGCode Decode(GCodeDocument document, FlavorRules flavor)
        => GCodeDecoder.Decode(document, new DecodeOptions { Flavor = flavor }).Value!;
}
