using System;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;
using Caterpillar.Traces;
using NUnit.Framework;

namespace Caterpillar.Tests.Shaping;

/// <summary>Deformations and fields as text.</summary>
public class ShapingTextTests
{
    private static readonly PrintPath Line = new([new Vec3(1, 2, 3), new Vec3(5, 2, 3), new Vec3(5, 6, 7)], new Bead(0.2, 0, 30));

    [Test]
    public void Cartesian_formulas_map_points_areas_and_speeds()
    {
        var path = Only(DeformationText.Compile("x + 1, 2*y, z - x", "c * (1 + x)", "v / z"));
        Assert.That(path.Points, Is.EqualTo(new[] { new Vec3(2, 4, 2), new Vec3(6, 4, -2), new Vec3(6, 12, 2) }));
        // Middles before the mapping: x 3 and 5, z 3 and 5.
        Assert.That(path.BeadOf(0).Area, Is.EqualTo(0.8).Within(1e-15));
        Assert.That(path.BeadOf(1).Speed, Is.EqualTo(6).Within(1e-15));
    }

    [Test]
    public void The_cup_of_the_paper_becomes_the_same_plate_by_text_and_by_code()
    {
        var cup = new Trace(0.196).SetSpeed(25).Spiral(new Vec3(10, 5, 0.3), 5, 0.5).Helix(new Vec3(10, 5, 0.3), 5, 3, 0.4).ToPaths();
        var axis = new Vec3(10, 5);
        var byCode = Deformation.Cylindrical(p => new Vec3(p.X + 1.05 * p.Z, p.Y, 0.3 * p.Z), (c, _) => 0.96 * c, axis: axis).Apply(cup, 0.05).Value!;
        foreach (var text in new[] { "r + 1.05*z, theta, 0.3*z", "r + 1.05*z, θ, 0.3*z", "r + 1.05*z, , 0.3*z" })
        {
            var byText = DeformationText.Compile(text, "0.96*c", system: DeformationSystem.Cylindrical, axis: axis).Value!.Apply(cup, 0.05).Value!;
            Assert.That(byText.Single().Points, Is.EqualTo(byCode.Single().Points));
            Assert.That(byText.Single().BeadOf(100), Is.EqualTo(byCode.Single().BeadOf(100)));
        }
    }

    [Test]
    public void The_formulas_of_the_manual_work()
    {
        var rows = File.ReadLines(Path.Combine(TestData.Repository, "docs", "traces.md"))
            .Select(l => l.Split('|').Select(c => c.Trim(' ', '`')).ToArray()).Where(c => c.Length == 7 && c[2] is "cylindrical" or "Cartesian").ToArray();
        Assert.That(rows, Has.Length.EqualTo(3));
        var helix = new Trace(0.196).SetSpeed(25).Helix(Vec3.Zero, 25, 20, 0.4, 36).ToPaths();
        foreach (var row in rows)
        {
            var system = row[2] == "Cartesian" ? DeformationSystem.Cartesian : DeformationSystem.Cylindrical;
            var deformation = DeformationText.Compile(row[3], row[4], row[5], system);
            Assert.That(deformation.Diagnostics, Is.Empty, row[1]);
            Assert.That(deformation.Value!.Apply(helix).Diagnostics, Is.Empty, row[1]);
        }
    }

    [Test]
    public void Values_without_a_formula_stay()
    {
        var path = Only(DeformationText.Compile("", null, ""));
        Assert.That(path.Points, Is.EqualTo(Line.Points));
        Assert.That(path.BeadOf(1), Is.EqualTo(Line.BeadOf(1)));
        Assert.That(Only(DeformationText.Compile("", "", "z + 1", null, "2 * v")).Points[1], Is.EqualTo(new Vec3(5, 2, 4)));
    }

    [Test]
    public void Commas_of_functions_do_not_split_a_position()
        => Assert.That(Only(DeformationText.Compile("max(x, 4), atan2(y, (x)), min(1, 2, z)")).Points[0], Is.EqualTo(new Vec3(4, Angle.Atan2(2, 1), 1)));

    [TestCase("x, y", "shape.position_formulas", "position", null)]
    [TestCase("x, y, z, z", "shape.position_formulas", "position", null)]
    [TestCase("x, y, r", "formula.unknown", "position.z", 7)]
    [TestCase("x, y +, z", "formula.", "position.y", null)]
    [TestCase("x, random(), z", "formula.random", "position.y", null)]
    [TestCase("x, sin(y, 4", "shape.position_formulas", "position", null)]
    public void Errors_in_positions_name_the_formula_and_the_column(string text, string code, string key, int? column)
    {
        var problem = DeformationText.Compile(text);
        Assert.That(problem.Value, Is.Null);
        Assert.That(problem.Diagnostics[0].Code, Does.StartWith(code));
        Assert.That(problem.Diagnostics[0].Source!.Key, Is.EqualTo(key));
        if (column is not null) Assert.That(problem.Diagnostics[0].Source!.Column, Is.EqualTo(column));
    }

    [Test]
    public void Errors_in_area_and_speed_name_the_formula()
    {
        var problems = DeformationText.Compile("x, y, z", "2 * v", "c +", source: new SourceLocation("part.txt")).Diagnostics;
        Assert.That(problems.Select(p => p.Source!.Key), Is.EqualTo(new[] { "area", "speed" }));
        Assert.That(problems[0].Message, Does.Contain("2 * v"));
        Assert.That(problems[0].ToString(), Does.StartWith("part.txt:1:5: area: error"));
        Assert.That(DeformationText.Compile("x, θ, z").Value, Is.Null, "θ belongs to cylindrical coordinates");
    }

    [Test]
    public void Values_that_are_not_finite_are_errors_of_the_path()
    {
        Assert.That(DeformationText.Compile("1/(x - 5), y, z").Value!.Apply([Line]).Diagnostics.Single().Code, Is.EqualTo("shape.position"));
        Assert.That(DeformationText.Compile("", "c - 1").Value!.Apply([Line]).Diagnostics.Single().Code, Is.EqualTo("shape.value"));
    }

    [TestCase("x", 4)]
    [TestCase("y", 6)]
    [TestCase("z", 9)]
    [TestCase("r", 5)]
    [TestCase("theta - atan2(4, 3)", 0)]
    [TestCase("θ - theta", 0)]
    [TestCase("s", 25)]
    [TestCase("u", 0.25)]
    [TestCase("path", 2)]
    [TestCase("0.5 + 0.5 * cos(720 * u)", 0)]
    public void Fields_see_the_position(string text, double expected)
        => Assert.That(Field(text)(new PathSample(new Vec3(4, 6, 9), 25, 100, 2, Role.Unspecified)), Is.EqualTo(expected).Within(1e-12));

    [TestCase("", "formula.empty")]
    [TestCase("  ", "formula.empty")]
    [TestCase("x +", "formula.")]
    [TestCase("random()", "formula.random")]
    [TestCase("c", "formula.unknown")]
    public void Bad_fields_are_errors(string text, string code)
    {
        var field = FieldText.Compile(text);
        Assert.That(field.Value, Is.Null);
        Assert.That(field.Diagnostics.Single().Code, Does.StartWith(code));
        Assert.That(field.Diagnostics.Single().Source!.Key, Is.EqualTo("field"));
    }

    [Test]
    public void A_field_without_a_value_is_an_error_of_the_modulation()
        => Assert.That(new Modulation(ModulationMode.Flow, Field("sqrt(x - 4)"), 1, 2).Apply([Line]).Diagnostics.Single().Code, Is.EqualTo("shape.field"));

    [Test]
    public void Fields_work_on_any_thread()
    {
        var field = Field("x * 2 + s");
        Parallel.For(0, 1000, i => Assert.That(field(new PathSample(new Vec3(i, 0, 0), i, 1000, 0, Role.Unspecified)), Is.EqualTo(3.0 * i)));
    }

    private static Field Field(string text) => FieldText.Compile(text, new Vec3(1, 2)).Value!;

    private static PrintPath Only(Result<Deformation> deformation)
    {
        Assert.That(deformation.Diagnostics, Is.Empty);
        return deformation.Value!.Apply([Line]).Value!.Single();
    }
}
