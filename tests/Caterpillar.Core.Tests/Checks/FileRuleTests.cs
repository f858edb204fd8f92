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

/// <summary>Rules of whole files, of heat, of speeds, and the places of what is found.</summary>
public class FileRuleTests
{
    private static readonly PrintSetup Setup = SmallPrint.Setup();

    [Test]
    public void The_first_move_of_a_file_may_extrude_and_counts()
    {
        var found = InFile("M83\nG1 X20 Y20 Z0.2 E0.5 F600\n", "file.");
        Assert.That(found.Select(d => (d.Code, d.Source!.Move)), Is.EquivalentTo(new[] { (CheckCodes.NoHoming, 0), (CheckCodes.NoHeating, (int?)0) }));
    }

    [TestCase("G1 X10 Y10 Z0.2\n", null)]
    [TestCase("G1 X10 Y10\n", "The file prints before the position in Z is known. Home first, or move in Z.")]
    [TestCase("G1 Z0.2\n", "The file prints before the position in Y is known. Home first, or move in Y.")]
    [TestCase("", "The file prints before the position in Y, Z is known. Home first, or move in Y, Z.")]
    [TestCase("G1 Y10 Z1\n", null)]
    public void Each_axis_is_known_once_it_has_moved(string text, string? message)
        => Assert.That(InFile("M109 S200\nM83\n" + text + "G1 X20 E0.5 F600\nM104 S0\n", CheckCodes.UnknownPosition).Select(d => d.Message),
            Is.EqualTo(message is null ? [] : new[] { message }));

    // Moves of half a millimeter; 12 of 36 pull E back.
    [Test]
    public void Short_moves_count_for_the_mode_of_E_and_shares_are_whole_percents()
    {
        var text = new StringBuilder("G28\nM109 S200\nG90\nM83\nG1 X10 Y10 Z0.2 F3000\n");
        for (var i = 1; i <= 36; i++) text.Append("G1 X").Append(10 + i / 2).Append(i % 2 == 0 ? "" : ".5").Append(i % 3 == 0 ? " E-0.01\n" : " E0.01\n");
        Assert.That(InFile(text + "M104 S0\n", CheckCodes.ExtrusionMode).Single().Message, Does.StartWith("33 % of the moves with E retract."));
    }

    [Test]
    public void Where_the_start_is_not_known_no_speed_is_judged()
    {
        Assert.That(InFile("M83\nG1 X10 Y10 Z100 F6000\n", CheckCodes.TravelSpeed), Is.Empty);
        Assert.That(InFile("M83\nG1 X10 Y10 Z1 F600\nG1 Z100 F60000\n", CheckCodes.TravelSpeed).Single().Source!.Move, Is.EqualTo(1));
    }

    // F with two decimals: a unit is 0.000167 mm/s.
    [TestCase(40.000165, 0)]
    [TestCase(40.000168, 1)]
    public void The_last_digit_of_F_is_a_sixtieth_of_its_unit(double speed, int found)
    {
        var setup = SmallPrint.Setup(p => p with { MaxSpeed = new(40, 40, 40, 40), DecimalsF = 2 });
        Assert.That(SmallPrint.Find(new SmallPrint().Print(30, 10, 0.2, speed: speed).Build(), setup, CheckCodes.Speed).Length, Is.EqualTo(found));
    }

    // 0.08 mm² at half a millimeter per second are 0.04 mm³/s; Z moves by 0.25 mm/s.
    [Test]
    public void Slow_moves_are_judged_as_well()
    {
        var setup = SmallPrint.Setup(p => p with { MaxFlow = 0.03, MaxSpeed = new(500, 500, 0.25, 500) });
        var print = new SmallPrint().Print(30, 10, 0.2, speed: 0.5).Print(30, 10, 0.4, speed: 0.5).Build();
        Assert.That(SmallPrint.Find(print, setup, CheckCodes.Flow).Single().Source!.Move, Is.Zero);
        Assert.That(SmallPrint.Find(print, setup, CheckCodes.Speed).Single().Source!.Move, Is.EqualTo(1));
    }

    // Z at twice its speed, then X at three times its own, and the other way round.
    [TestCase(false, true)]
    [TestCase(true, false)]
    public void The_worst_speed_is_the_one_that_is_most_above_its_limit(bool turned, bool worse)
    {
        var setup = SmallPrint.Setup(p => p with { MaxSpeed = new(100, 100, 10, 100) });
        var print = new SmallPrint();
        for (var i = 0; i < 2; i++)
        {
            if ((i == 0) != turned) print.Print(print.At.X, 10, print.At.Z + 5, speed: 20);
            else print.Print(print.At.X + 20, 10, print.At.Z, speed: 300);
        }
        var found = SmallPrint.Find(print.Build(), setup, CheckCodes.Speed).Single();
        Assert.That((found.Count, found.Worst?.Message.StartsWith("A move has a speed of 300 ", StringComparison.Ordinal) ?? false), Is.EqualTo((2, worse)));
    }

    [Test]
    public void Material_in_place_may_be_exactly_the_limit()
    {
        var setup = SmallPrint.Setup(p => p with { MaxStationaryVolume = 10 });
        Assert.That(SmallPrint.Find(new SmallPrint().Prime(10).Build(), setup, CheckCodes.Stationary), Is.Empty);
        Assert.That(SmallPrint.Find(new SmallPrint().Prime(10.00001).Build(), setup, CheckCodes.Stationary), Has.Exactly(1).Items);
        var half = new SmallPrint().Prime(5).Prime(5);
        Assert.That(SmallPrint.Find(half.Build(), setup, CheckCodes.Stationary), Is.Empty, "in two moves");
        Assert.That(SmallPrint.Find(new SmallPrint().Prime(9).Go(20, 10, 0.2).Prime(10).Build(), setup, CheckCodes.Stationary), Is.Empty, "at two places");
        Assert.That(SmallPrint.Find(half.Prime(0.01).Build(), setup, CheckCodes.Stationary).Single().Source!.Move, Is.EqualTo(2));
    }

    [Test]
    public void Temperatures_are_told_with_a_decimal_and_what_comes_after_the_last_move_is_at_none()
    {
        var print = new SmallPrint().Print(30, 10, 0.2).Event(new NozzleTemperatureEvent(400.26)).Build();
        var found = SmallPrint.Find(print, Setup, CheckCodes.NozzleTemperature).Single();
        Assert.That((found.Source!.Move, found.Source.Step), Is.EqualTo(((int?)null, (int?)1)));
        Assert.That(found.Message, Is.EqualTo("The nozzle temperature is 400.3 °C, but Generic printer allows only 300 °C. Lower the temperature."));
    }

    [Test]
    public void What_the_first_step_of_a_design_does_is_found_there()
    {
        var print = new SmallPrint().Event(new NozzleTemperatureEvent(400)).Print(30, 10, 0.2).Build();
        var found = SafeWriter.ToDocument(print, Setup).Diagnostics.Single(d => d.Code == CheckCodes.NozzleTemperature).Source!;
        Assert.That((found.Step, found.Line is > 0), Is.EqualTo(((int?)0, true)));
    }

    // A pellet of clay in a file that says nothing of its filament: the material does.
    [TestCase(ExtrusionUnit.Mm, 1)]
    [TestCase(ExtrusionUnit.None, 0)]
    public void Where_a_file_does_not_state_its_filament_that_of_the_material_counts(ExtrusionUnit unit, int found)
    {
        var setup = SmallPrint.Setup(p => p with { MaxFlow = 1, ExtrusionUnit = unit });
        var file = GCodeDecoder.Decode(Encoding.ASCII.GetBytes("G28\nM83\nG1 X10 Y10 Z0.2 F600\nG1 X20 E1\n"), new DecodeOptions()).Value!;
        Assert.That(file.Toolpath.VolumePerE(0), Is.Null, "unknown as decoded");
        Assert.That(PrintCheck.Run(file, setup).Count(d => d.Code == CheckCodes.Flow), Is.EqualTo(found));
        Assert.That(PrintCheck.WithVolumes(file.Toolpath, setup).VolumePerE(0) is null, Is.EqualTo(unit == ExtrusionUnit.None));
    }

    [Test]
    public void An_edited_file_that_heats_itself_is_checked_from_cold()
    {
        var plain = new SmallPrint().Print(30, 10, 0.2).Build();
        Assert.That(PrintCheck.SetupForFile(Setup, plain), Is.SameAs(Setup));
        var heated = new SmallPrint().Print(30, 10, 0.2).Event(new NozzleTemperatureEvent(200)).Print(60, 10, 0.2).Build();
        Assert.That(PrintCheck.SetupForFile(Setup, heated).Material.NozzleTemperature, Is.Zero);
        Assert.That(() => PrintCheck.SetupForFile(null!, plain), Throws.ArgumentNullException);
        Assert.That(() => PrintCheck.SetupForFile(Setup, null!), Throws.ArgumentNullException);
    }

    [Test]
    public void Refusals_and_notes_say_what_else_was_noticed()
    {
        var other = new Diagnostic(Severity.Note, "other", "Something else.");
        var error = new Diagnostic(Severity.Error, CheckCodes.Outside, "Out.", new SourceLocation(Line: 7));
        Assert.That(new WriteGuard([error], null).Refusal([other]).Select(d => d.Code), Is.EqualTo(new[] { CheckCodes.Outside, "other", SafeWriter.Refused }));
        var notes = new WriteGuard([error], "the bed is longer").Notes([other]);
        Assert.That(notes.Select(d => (d.Code, d.Severity)), Is.EqualTo(new[] { (CheckCodes.Outside, Severity.Warning), ("other", Severity.Note) }));
        Assert.That(notes[0].Source!.Line, Is.EqualTo(9), "after two lines of comments");
        Assert.That(new WriteGuard([other with { Source = new SourceLocation(Line: 7) }], null).Notes([])[0].Source!.Line, Is.EqualTo(7));
    }

    [Test]
    public void A_draft_is_written_while_it_is_checked_and_else_nothing_that_is_refused()
    {
        var print = new SmallPrint().Go(500, 10, 0.2).Build();
        using var draft = new MemoryStream();
        using var file = new MemoryStream();
        Assert.That(SafeWriter.Write(print, Setup, draft, isDraft: true).Value, Is.Null);
        Assert.That(SafeWriter.Write(print, Setup, file).Value, Is.Null);
        Assert.That((draft.Length > 0, file.Length), Is.EqualTo((true, 0L)));
    }

    // The last of 70,000 moves, in the second block.
    [Test]
    public void Every_move_of_a_long_edited_file_is_compared()
    {
        var text = new StringBuilder("G28\nM109 S200\nG90\nM83\nG1 X10 Y10 Z0.2 F3000\n");
        for (var i = 1; i <= 70_000; i++) text.Append("G1 X").Append(i % 2 == 0 ? "20" : "20.5").Append(" E0.01\n");
        var file = SmallPrint.Decode(Encoding.ASCII.GetBytes(text + "G1 Z5\nM104 S0\n"), Setup);
        Assert.That(file.Toolpath.Blocks.Count, Is.GreaterThan(1));
        var found = EditCheck.Run(file, file.Toolpath, GCodeDocument.FromText(text + "G1 Z6\nM104 S0\n"), Setup, null, default);
        Assert.That(found.Where(d => d.Code.StartsWith("file.p", StringComparison.Ordinal)).Select(d => d.Source!.Line), Is.EqualTo(new int?[] { 70_006 }));
        var same = EditCheck.Run(file, file.Toolpath, GCodeDocument.FromText(text + "G1 Z5\nM104 S0\n"), Setup, null, default);
        Assert.That(same.Where(d => d.Code is CheckCodes.FilePosition or CheckCodes.FileExtrusion), Is.Empty);
    }

    // Other start code of an edited file.
    [TestCase("M104 S900", CheckCodes.NozzleTemperature, 1)]
    [TestCase("G28\nG1 X900 F6000", CheckCodes.Outside, 2)]
    public void New_start_code_of_an_edited_file_is_checked(string start, string code, int line)
    {
        const string File = "G28\nM109 S200\nG90\nM83\n;LAYER:0\nG1 X10 Y10 Z0.2 F3000\nG1 X30 E0.5\nG1 X60 E0.8\nM104 S0\n";
        var file = SmallPrint.Decode(Encoding.ASCII.GetBytes(File), Setup);
        var edit = new EditOptions { Start = start.Split('\n') };
        var refused = SafeWriter.ToDocument(file, file.Toolpath, Setup, null, edit);
        Assert.That(refused.Value, Is.Null);
        Assert.That(refused.Diagnostics.First(d => d.Code == code).Source!.Line, Is.EqualTo(line));
        var fine = SafeWriter.ToDocument(file, file.Toolpath, Setup, null, edit with { Start = ["G28", "M109 S210", "G90", "M83"] });
        Assert.That(Encoding.ASCII.GetString(fine.Value!.ToBytes()), Does.Contain("M109 S210").And.Not.Contain("M109 S200"));
    }

    private static Diagnostic[] InFile(string text, string code)
        => PrintCheck.Run(SmallPrint.Decode(Encoding.ASCII.GetBytes(text), Setup), Setup)
            .Where(d => d.Code.StartsWith(code, StringComparison.Ordinal)).ToArray();
}
