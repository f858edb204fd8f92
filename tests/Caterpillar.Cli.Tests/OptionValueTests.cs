using System;
using System.IO;
using System.Linq;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>What values of options, patterns and tables mean.</summary>
public class OptionValueTests : CliFixture
{
    private static string Failure(Action act, int code = ExitCode.Usage)
    {
        var failure = Assert.Throws<CliException>(() => act())!;
        Assert.That(failure.Code, Is.EqualTo(code), failure.Message);
        return failure.Message;
    }

    [TestCase("1,2", 1, 2, 0)]
    [TestCase(" 1 , -2.5 , 3 ", 1, -2.5, 3)]
    [TestCase("1e6,-1e6", 1e6, -1e6, 0)]
    public void A_place_has_two_or_three_coordinates(string text, double x, double y, double z)
        => Assert.That(Numbers.Vector(text, "--center"), Is.EqualTo(new Vec3(x, y, z)));

    [TestCase("1", "--center needs X,Y or X,Y,Z in mm.")]
    [TestCase("1,2,3,4", "--center needs X,Y or X,Y,Z in mm.")]
    [TestCase("1,1000001", "--center needs coordinates up to 1 km.")]
    [TestCase("-1000001,1", "--center needs coordinates up to 1 km.")]
    [TestCase("1,x", "--center needs a number, not \"x\".")]
    [TestCase("1,", "--center needs a number, not \"\".")]
    public void Other_places_are_wrong_usage(string text, string message)
        => Assert.That(Failure(() => Numbers.Vector(text, "--center")), Is.EqualTo(message));

    [TestCase("2", 2, 2, 2)]
    [TestCase("50%", 0.5, 0.5, 0.5)]
    [TestCase("1, 2 %,3", 1, 0.02, 3)]
    [TestCase("1e-6,999999,1", 1e-6, 999999, 1)]
    public void A_scale_is_a_factor_or_a_percentage_for_all_axes_or_for_each(string text, double x, double y, double z)
        => Assert.That(Numbers.Scale(text).DistanceTo(new Vec3(x, y, z)), Is.LessThan(1e-12));

    [TestCase("1,2", "--scale needs a factor, or three of them: X,Y,Z.")]
    [TestCase("0", "--scale needs a factor above 0 and below a million.")]
    [TestCase("9e-7", "--scale needs a factor above 0 and below a million.")]
    [TestCase("1e6", "--scale needs a factor above 0 and below a million.")]
    [TestCase("-1", "--scale needs a factor above 0 and below a million.")]
    public void Other_scales_are_wrong_usage(string text, string message) => Assert.That(Failure(() => Numbers.Scale(text)), Is.EqualTo(message));

    [TestCase(null, 1)]
    [TestCase("um", 0.001)]
    [TestCase("mm", 1)]
    [TestCase(" cm ", 10)]
    [TestCase("m", 1000)]
    [TestCase("in", 25.4)]
    [TestCase("ft", 304.8)]
    [TestCase("0.5", 0.5)]
    [TestCase("999999", 999999)]
    public void A_unit_has_a_name_or_a_length(string? text, double length) => Assert.That(Numbers.Unit(text), Is.EqualTo(length));

    [TestCase("0")]
    [TestCase("-1")]
    [TestCase("1e6")]
    public void A_unit_is_longer_than_nothing(string text) => Assert.That(Failure(() => Numbers.Unit(text)), Does.StartWith("--unit needs um, mm, cm"));

    [TestCase("0.7", 0.7)]
    [TestCase("70%", 0.7)]
    [TestCase("0", 0)]
    [TestCase("10", 10)]
    [TestCase("1000%", 10)]
    public void Speed_and_flow_are_ratios(string text, double ratio) => Assert.That(Numbers.Ratio(text, "--flow", 0), Is.EqualTo(ratio).Within(1e-12));

    [TestCase("70", "--flow needs a factor up to 10, or a percentage such as 70%.")]
    [TestCase("-0.1", "--flow needs a factor from 0 to a million.")]
    public void Other_ratios_are_wrong_usage(string text, string message)
        => Assert.That(Failure(() => Numbers.Ratio(text, "--flow", 0)), Is.EqualTo(message));

    [Test]
    public void Amounts_are_numbers_or_shares_of_a_whole()
    {
        double? Amount(string? text) => Numbers.MaybeAmount(text, "--width", 0.4);
        Assert.That(Amount(null), Is.Null);
        Assert.That(new[] { Amount(" 0.6 "), Amount("150 %") }, Is.EqualTo(new[] { 0.6, 0.6 }).Within(1e-12));
        Assert.That(Failure(() => Amount("-1%")), Is.EqualTo("--width needs a number of 0 or more, not \"-1\"."));
        Assert.That(Failure(() => Numbers.AtLeast("-3", "--z", -2)), Is.EqualTo("--z needs a number, not \"-3\"."));
        Assert.That((Numbers.AtLeast("-2", "--z", -2), Numbers.Diameter(0.01, "--d"), Numbers.Diameter(1000, "--d")), Is.EqualTo((-2.0, 0.01, 1000.0)));
        Assert.That(Failure(() => Numbers.Diameter(0.009, "--d")) + Failure(() => Numbers.Diameter(1000.1, "--d")), Does.Contain("0.01 to 1000 mm"));
        Assert.That(Numbers.Pair("-3=a=b", "--gcode-at-layer"), Is.EqualTo((-3, "a=b")));
        foreach (var text in new[] { "=a", "a=b", "1.5=b", "3" }) Assert.That(Failure(() => Numbers.Pair(text, "--x")), Does.StartWith("--x needs N=…"));
    }

    [TestCase("0%")]
    [TestCase("100%")]
    [TestCase("90")]
    [TestCase("1h")]
    [TestCase("1h2m3.5s")]
    [TestCase("LINE:1")]
    [TestCase("move:0")]
    [TestCase("layer:0")]
    [TestCase("z:-1")]
    public void A_moment_is_a_share_a_time_or_a_place(string text) => Assert.That(() => Moment.Parse(text), Throws.Nothing);

    [TestCase("-1%")]
    [TestCase("100.1%")]
    [TestCase("line:1.5")]
    [TestCase("move:-1")]
    [TestCase("layer:-1")]
    [TestCase("z:")]
    [TestCase("-5")]
    [TestCase("m")]
    [TestCase("1m2h")]
    [TestCase("-1m")]
    public void Nothing_else_is_a_moment(string text) => Assert.That(Failure(() => Moment.Parse(text)), Does.Contain($"not \"{text}\""));

    [TestCase("*.txt", "a.txt b.txt")]
    [TestCase("?.txt", "a.txt b.txt")]
    [TestCase("**/*.txt", "a.txt b.txt sub/c.txt sub/deep/d.txt")]
    [TestCase("*/*.txt", "sub/c.txt")]
    [TestCase("sub/**/?.txt", "sub/c.txt sub/deep/d.txt")]
    [TestCase("s*/d??p/*", "sub/deep/d.txt")]
    [TestCase(".*", ".hidden.txt")]
    [TestCase(".dot/*.txt", ".dot/e.txt")]
    [TestCase("./sub/*", "./sub/c.txt")]
    [TestCase("sub\\*.txt", "sub/c.txt")]
    public void Patterns_find_files_but_no_hidden_ones(string pattern, string files)
    {
        Directory.CreateDirectory("sub/deep");
        Directory.CreateDirectory(".dot");
        string[] all = ["b.txt", "a.txt", ".hidden.txt", "sub/c.txt", "sub/deep/d.txt", ".dot/e.txt", "aXtxt", "a.txt.gz"];
        foreach (var file in all) File.WriteAllText(file, "");
        Assert.That(FilePattern.Files([pattern]), Is.EqualTo(files.Split(' ')));
        Assert.That(FilePattern.Files(["./a.txt", pattern, "a.txt"]).Count(f => f.EndsWith("a.txt", StringComparison.Ordinal)), Is.EqualTo(1));
    }

    [TestCase(null, "part_01.gcode")]
    [TestCase("out/", "out/part_01.gcode")]
    [TestCase("{folder}/{name}-{row}-{size}.gcode", "models/part-01-a_b_c.gcode")]
    [TestCase("{other}/x", "_/x")]
    public void Outputs_are_named_after_inputs_and_rows(string? given, string name)
    {
        var rows = string.Concat(Enumerable.Repeat("a/b:c,..\n", 12));
        var table = CsvTable.Parse("size,other\n" + rows, "t.csv");
        Assert.That(new OutputPattern(given, ".gcode", table).For("models/part.stl.GZ", 1, table), Is.EqualTo(name));
        Assert.That(new OutputPattern(null, ".gcode", null).For("part.3mf", 1, null), Is.EqualTo("part.gcode"));
        Assert.That(new OutputPattern("{folder}", ".gcode", null).For("part.3mf", 1, null), Is.EqualTo("."));
    }

    [TestCase("a,b\n\n# c\n\"1\n2\",3\n1,2,3", "t.csv:6: 3 cells for 2 columns.")]
    [TestCase("# x\na,b,a", "t.csv:2: there are two columns \"a\".")]
    [TestCase("a,,b", "t.csv:1: a column has no name.")]
    [TestCase("a\n1\n\"2\n3", "t.csv:3: a quote is not closed.")]
    [TestCase(" # a\n\n", "t.csv: the table is empty. Its first row must name the columns.")]
    public void Bad_tables_are_told_with_their_line(string text, string message)
        => Assert.That(Failure(() => CsvTable.Parse(text, "t.csv"), ExitCode.BadInput), Is.EqualTo(message));

    [TestCase("a,b\n1, 2 \n3", "1|2/3|")]
    [TestCase(" # x,y,z,w,v\na;b\n1,5;2\n", "1,5|2")]
    [TestCase("\uFEFFa\tb\r\n\" 1\" \t\"2 \"\"x\"\"\"\r\n", " 1|2 \"x\"")]
    [TestCase("a,b\n,\n\"\",x\n", "|x")]
    [TestCase("a,b\n\"1\"2,3\"4\n", "12|3\"4")]
    public void Tables_have_commas_semicolons_or_tabs_and_quotes(string text, string cells)
        => Assert.That(string.Join("/", CsvTable.Parse(text, "t.csv").Rows.Select(r => string.Join("|", r))), Is.EqualTo(cells));

    [Test]
    public void Cells_are_quoted_where_they_must_be_and_read_again()
    {
        string[] cells = ["a", "b,c", "d\"e", " f", "", "g\nh", "i "];
        var line = CsvTable.Line(cells);
        Assert.That(line, Is.EqualTo("a,\"b,c\",\"d\"\"e\",\" f\",,\"g\nh\",\"i \""));
        Assert.That(CsvTable.Parse("1,2,3,4,5,6,7\n" + line, "t.csv").Rows.Single(), Is.EqualTo(cells));
    }

    [Test]
    public void Columns_are_as_wide_as_their_widest_cell()
    {
        using var text = new StringWriter { NewLine = "\n" };
        TextTable.Write(text, [["a", "bbb", "c"], [], ["dddd", "e"]]);
        Assert.That(text.ToString(), Is.EqualTo("a     bbb  c\n\ndddd  e\n"));
    }
}
