using System.IO;
using System.Linq;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

public class ModelOptionTests : CliFixture
{
    private static readonly string[] Walls =
    [
        "--set", "start_gcode=", "--set", "end_gcode=", "--set", "wall_count=1", "--set", "infill_density_percent=0", "--set", "top_layers=0",
        "--set", "bottom_layers=0",
    ];

    [SetUp]
    public void WriteModel() => File.WriteAllText("part.stl", Box(20, 10, 2));

    // The line of a wall of 0.45 mm lies 0.225 mm inside.
    [TestCase("100.225 105.225", "119.775 114.775")]
    [TestCase("90.225 100.225", "129.775 119.775", "--scale", "2")]
    [TestCase("105.225 107.725", "114.775 112.275", "--scale", "50%")]
    [TestCase("100.225 95.225", "119.775 124.775", "--scale", "1,3,1")]
    [TestCase("95.225 102.725", "124.775 117.275", "--scale", "30mm")]
    [TestCase("105.225 105.225", "114.775 114.775", "--scale", "10,10,4mm")]
    [TestCase("105.225 100.225", "114.775 119.775", "--rotate", "90")]
    [TestCase("100.225 109.225", "119.775 110.775", "--rotate", "90,0,0")]
    [TestCase("100.225 105.225", "119.775 114.775", "--rotate", "90,0,0", "--lay-flat")]
    [TestCase("20.225 35.225", "39.775 44.775", "--center", "30,40")]
    [TestCase("100.225 105.225", "119.775 114.775")]
    [TestCase("100.225 105.225", "119.775 114.775", "--arrange")]
    public void Options_place_the_model(string least, string most, params string[] options)
    {
        // Extrusions go all around, up to the corners in which they begin.
        var run = Run(["slice", "part.stl", .. options, .. Walls, "--set", "seam_gap_mm=0"]);
        Assert.That(run.Code, Is.Zero, run.Messages);
        var numbers = File.ReadLines("part.gcode").Where(l => l.StartsWith("G1 ", System.StringComparison.Ordinal) && l.Contains('E')).ToArray();
        string Range(char axis, bool low)
        {
            var values = numbers.SelectMany(l => l.Split(' ')).Where(w => w[0] == axis)
                .Select(w => decimal.Parse(w[1..], System.Globalization.CultureInfo.InvariantCulture));
            return (low ? values.Min() : values.Max()).ToString(System.Globalization.CultureInfo.InvariantCulture);
        }
        Assert.That(($"{Range('X', true)} {Range('Y', true)}", $"{Range('X', false)} {Range('Y', false)}"), Is.EqualTo((least, most)));
    }

    [TestCase("--scale", "0")]
    [TestCase("--scale", "1,2")]
    [TestCase("--scale", "-5mm")]
    [TestCase("--rotate", "1,2")]
    [TestCase("--rotate", "x")]
    [TestCase("--center", "5")]
    [TestCase("--copies", "0")]
    [TestCase("--copies", "2", "--center", "5,5")]
    [TestCase("--arrange", "--keep-position")]
    [TestCase("--keep-position", "--center", "5,5")]
    [TestCase("--spacing", "-1")]
    [TestCase("--arrange", "--for", "part.stl:model_type=modifier")]
    [TestCase("--lay-flat", "--for", "part.stl:model_type=support_blocker")]
    [TestCase("--for", "part.stl")]
    [TestCase("--for", "lid.stl:wall_count=2")]
    [TestCase("--for", "part.stl:wall_count=many")]
    [TestCase("--for", "part.stl:nozzle_diameter_mm=1")]
    public void Wrong_options_are_wrong_usage(params string[] options)
    {
        var run = Run(["slice", "part.stl", .. options]);
        Assert.That((run.Code, Files().Length), Is.EqualTo((2, 1)), run.Messages);
        Assert.That(run.Messages, Does.Contain(options[0]).Or.Contain("wall_count"));
    }

    [Test]
    public void Copies_are_arranged_and_too_many_are_refused()
    {
        Assert.That(Run(["slice", "part.stl", "--copies", "6", .. Walls]).Code, Is.Zero);
        var run = Run("slice", "part.stl", "--scale", "5", "--copies", "9", "-o", "nine.gcode");
        Assert.That((run.Code, File.Exists("nine.gcode")), Is.EqualTo((3, false)));
        Assert.That(run.Messages, Does.Contain("models.no_space").And.Contain("of 9 models fit"));
    }

    [Test]
    public void One_of_several_models_has_settings_of_its_own()
    {
        File.WriteAllText("lid.stl", Box(20, 10, 2));
        var plain = Run(["slice", "part.stl", "lid.stl", "--arrange", "--json", .. Walls]);
        var own = Run(["slice", "part.stl", "lid.stl", "--arrange", "--json", "--for", "lid.stl:layer_height_mm=0.1,first_layer_height_mm=0.1", .. Walls]);
        Assert.That(Layers(plain), Is.EqualTo(20));
        Assert.That(Layers(own), Is.EqualTo(30), own.Messages);
        // A value may hold commas.
        var ears = Run(["slice", "part.stl", "lid.stl", "--arrange", "--json", "--for", "lid.stl:brim_ears_mm=90,90,15,layer_height_mm=0.1", .. Walls]);
        Assert.That((ears.Code, Layers(ears)), Is.EqualTo((0, 29)), ears.Messages);
    }

    [Test]
    public void Models_too_near_to_each_other_for_the_head_are_refused_one_after_the_other()
    {
        File.WriteAllText("lid.stl", Box(20, 10, 30));
        File.WriteAllText("both.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
        var run = Run("slice", "lid.stl", "both.obj", "--keep-position", "--set", "print_sequence=by_object", "-o", "x.gcode");
        Assert.That((run.Code, File.Exists("x.gcode")), Is.EqualTo((3, false)));
        Assert.That(run.Messages, Does.Contain("models.no_clearance"));
        Assert.That(Run("slice", "lid.stl", "both.obj", "--arrange", "--set", "print_sequence=by_object", "-o", "x.gcode").Code, Is.Zero);
    }

    private static int Layers(CliRun run) => System.Text.Json.JsonDocument.Parse(run.Output).RootElement.GetProperty("layers").GetInt32();

    [Test]
    public void Modifiers_move_along_with_the_part_and_are_not_printed()
    {
        File.WriteAllText("big.stl", Box(60, 60, 40));
        var run = Run(["slice", "part.stl", "big.stl", "--center", "30,40", "--for", "big.stl:model_type=modifier,wall_count=3", .. Walls]);
        Assert.That(run.Code, Is.Zero, run.Messages);
        var lines = File.ReadAllLines("part.gcode");
        Assert.That(lines.Count(l => l.StartsWith(";LAYER_CHANGE", System.StringComparison.Ordinal)), Is.EqualTo(10), "only the part is printed");
        Assert.That(lines, Has.Some.Contains(" Y35.225"), "in the middle is the part");
        Assert.That(lines, Has.Some.EqualTo(";TYPE:Perimeter"), "inner walls, which only the modifier asks for");
    }

    [Test]
    public void Curves_of_a_file_are_the_infill_where_the_model_stands()
    {
        File.WriteAllText("web.csv", "x,y\n-100,3\n100,3\n");
        var run = Run(["slice", "part.stl", "--infill-curves", "web.csv", "--center", "30,40", .. Walls, "--set", "infill_density_percent=20"]);
        Assert.That(run.Code, Is.Zero, run.Messages);
        var lines = File.ReadAllLines("part.gcode");
        Assert.That(lines.Count(l => l == ";TYPE:Internal infill"), Is.EqualTo(10));
        Assert.That(lines, Has.Some.Contains(" Y38 "), "3 mm above the lower edge, which is at 35 mm");
    }
}
