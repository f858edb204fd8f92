using System;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Drawings;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Curves;

public class CurveReaderTests
{
    internal static Result<System.Collections.Generic.IReadOnlyList<UserCurve>> Read(string text, string name, CurveReadOptions? options = null)
        => CurveReader.Read(Encoding.UTF8.GetBytes(text), name, options);

    [TestCase("0,0,0\n10,0,0\n10,5,1\n\n1,1\n", "a.csv")]
    public void A_row_of_another_width_is_an_error(string text, string name)
    {
        var problem = Read(text, name).Diagnostics[0];
        Assert.That(problem.ToString(), Is.EqualTo("a.csv:5:1: error curves.csv: The row has 2 cells instead of 3."));
    }

    [TestCase("0,0,0\n10,0,0.5\n\n0,0\t\n")]
    [TestCase("x,y,z\n0,0,0\n10,0,0.5\n")]
    [TestCase("0 0 0\n10 0 0.5\n")]
    [TestCase("  0   0  0 \r\n 10 0 0.5\r\n\r\n")]
    [TestCase("X;Y;Z\r\n0;0;0\r\n10,0;0;0,5\r\n")]
    [TestCase("# points\n\"x\"\t\"y\"\t\"z\"\n0\t0\t0\n10\t0\t5e-1\n")]
    [TestCase("\ufeffz,y,x\n0,0,0\n.5,+0,10.\n")]
    [TestCase("0,0,0\r10,0,0.5\r")]
    public void Points_are_read_in_all_notations(string text)
    {
        if (text.EndsWith("\t\n", StringComparison.Ordinal)) text = text.Substring(0, text.Length - 5);
        var curve = Read(text, "p.csv").Value!.Single().Curve;
        Assert.That(((PolylineCurve)curve).Polyline.Points, Is.EqualTo(new Vec3[] { new(0, 0), new(10, 0, 0.5) }));
    }

    [Test]
    public void Columns_carry_curves_and_settings()
    {
        var curves = Read("curve,x,y,z,width,speed,tool\na,0,0,0,0.4,50%,0\na,1,0,0,0.8,50%,0\nb,5,5,0,1,10,1\nb,6,5,0,1,10,1\n"
                + "b,6,6,0,1,10,1\nb,5,5,0,1,10,1\n", "c.csv",
            new CurveReadOptions { SpeedReference = 60 }).Value!;
        Assert.That(curves.Select(c => c.Name), Is.EqualTo(new[] { "a", "b" }));
        Assert.That(curves[0].Along!.Widths, Is.EqualTo(new[] { 0.4, 0.8 }));
        Assert.That(curves[0].Along!.Speeds, Is.Null);
        Assert.That(curves[0].Speed, Is.EqualTo(30));
        Assert.That(curves[1].Along, Is.Null);
        Assert.That((curves[1].Width, curves[1].Speed, curves[1].Tool), Is.EqualTo((1.0, 10.0, 1)));
        Assert.That(curves[1].Curve.IsClosed, Is.True);
        Assert.That(curves[1].Source!.Line, Is.EqualTo(4));
    }

    [TestCase("150%", 1.5)]
    [TestCase("1.5", 1.5)]
    [TestCase("50 %", 0.5)]
    public void The_flow_may_be_a_percentage(string text, double flow)
    {
        var curve = Read($"x,y,flow\n0,0,{text}\n5,0,{text}\n", "c.csv").Value!.Single();
        Assert.That((curve.Flow, curve.Curve.Start, curve.Curve.End), Is.EqualTo((flow, Vec3.Zero, new Vec3(5, 0))), "Without heights a drawing is flat.");
    }

    [Test]
    public void Values_that_change_on_a_closed_curve_lose_the_repeated_end()
    {
        var curve = Read("x,y,area\n0,0,.1\n5,0,.2\n5,5,.3\n0,0,.1\n", "c.csv").Value!.Single();
        Assert.That(curve.Along!.Areas, Is.EqualTo(new[] { .1, .2, .3 }));
        Assert.That(CurvePaths.ToPaths([curve]).Value!.Single().IsClosed, Is.True);
    }

    // Longer than the room for few points, and more than one curve.
    [TestCase("\n", true)]
    [TestCase("\n", false)]
    [TestCase("\r\n", true)]
    [TestCase("\r", false)]
    public void Long_curves_keep_all_points_whatever_ends_their_lines(string lineEnd, bool endsLast)
    {
        int[] counts = [3000, 1, 1500, 2];
        var rows = counts.Select((count, n) => Enumerable.Range(0, count).Select(i => new Vec3(i, n + 0.5 * (i % 2), -0.25 * i)).ToArray()).ToArray();
        static string Row(Vec3 p)
            => $"{NumberFormatter.Format(p.X, 2)},{NumberFormatter.Format(p.Y, 2)},{NumberFormatter.Format(p.Z, 2)}{(p.X == 7 ? " " : "")}";
        var text = string.Join(lineEnd + lineEnd, rows.Select(row => string.Join(lineEnd, row.Select(Row))));

        var read = Read("x,y,z" + lineEnd + text + (endsLast ? lineEnd : ""), "long.csv");

        Assert.That(read.Diagnostics.Select(d => d.Code), Is.EqualTo(new[] { "curves.too_short" }));
        var lines = read.Value!.Select(c => ((PolylineCurve)c.Curve).Polyline.Points);
        Assert.That(lines, Is.EqualTo(rows.Where(row => row.Length > 1)));
        Assert.That(read.Value!.Select(c => c.Source!.Line), Is.EqualTo(new[] { 2, 3005, 4506 }));
    }

    [TestCase("x,y\n1,2\n1,nan\n", "3:3: error curves.not_finite")]
    [TestCase("x,y\n1,2\n1,1e999\n", "3:3: error curves.not_finite")]
    [TestCase("x,y\n1,2\n1,two\n", "3:3: error curves.number")]
    [TestCase("x,y,area\n1,2,1\n1,3,-1\n", "3:5: error curves.bead")]
    [TestCase("x,y,speed\n1,2,50%\n", "2:5: error curves.percent")]
    [TestCase("x,z\n1,2\n", "1:1: error curves.csv")]
    [TestCase("1,2,3,4\n", "1:1: error curves.csv")]
    [TestCase("x,y,x\n", "1:5: error curves.csv")]
    [TestCase("", " error curves.empty")]
    [TestCase("1,2,3\n", " error curves.empty")]
    public void Bad_points_are_reported_with_their_place(string text, string expected)
    {
        var read = Read(text, "bad.csv");
        Assert.That(read.Value, Is.Null);
        Assert.That(read.Diagnostics.Select(d => d.ToString()), Has.Some.StartsWith("bad.csv:" + expected));
    }

    [Test]
    public void Unknown_columns_and_single_points_are_ignored_with_a_warning()
    {
        var read = Read("x,y,colour\n0,0,7\n1,0,8\n\n3,3,9\n", "c.csv");
        Assert.That(read.Value, Has.Count.EqualTo(1));
        Assert.That(read.Diagnostics.Select(d => d.Code), Is.EqualTo(new[] { "curves.ignored", "curves.too_short" }));
    }

    [Test]
    public void Json_can_contain_all_kinds_of_curves()
    {
        const string Text = """
            {"units": "cm", "speed": 20, "curves": [
              [[0,0],[1,0],[1,1,0.5]],
              {"points": [[0,0],[1,0],[1,1]], "closed": true, "name": "ring", "width": "150%", "speed": 5},
              {"points": [{"x":0,"y":0,"area":0.1},{"x":1,"y":0,"area":0.3}]},
              {"degree": 3, "points": [[0,0],[1,0],[1,1],[0,1]]},
              {"degree": 2, "points": [[1,0],[1,1],[0,1]], "weights": [1,0.70710678118654757,1], "knots": [0,0,0,1,1,1]},
              {"center": [2,3,0.1], "radius": 1, "start": 90, "sweep": -180},
              {"pieces": [[[0,0],[1,0]], {"center": [1,1], "radius": 1, "start": -90, "sweep": 90}], "layer": 2}
            ]}
            """;
        var curves = Read(Text, "c.json", new CurveReadOptions { WidthReference = 0.4 }).Value!;
        Assert.That(curves, Has.Count.EqualTo(7));
        Assert.That(curves[0].Curve.End, Is.EqualTo(new Vec3(10, 10, 5)));
        Assert.That(curves[0].Speed, Is.EqualTo(20));
        Assert.That((curves[1].Name, curves[1].Speed), Is.EqualTo(("ring", 5.0)));
        Assert.That(curves[1].Width, Is.EqualTo(0.6).Within(1e-15));
        Assert.That(curves[1].Curve.IsClosed, Is.True);
        Assert.That(curves[2].Along!.Areas, Is.EqualTo(new[] { 0.1, 0.3 }));
        Assert.That(curves[3].Curve, Is.InstanceOf<NurbsCurve>());
        Assert.That(curves[4].Curve.Length, Is.EqualTo(5 * Math.PI).Within(1e-9));
        Assert.That(curves[5].Curve.End.DistanceTo(new Vec3(20, 20, 1)), Is.LessThan(1e-12));
        Assert.That(curves[6].Curve, Is.InstanceOf<PolyCurve>());
        Assert.That(curves[6].Layer!.Index, Is.EqualTo(2));
        Assert.That(Read("[[0,0],[3,4]]", "c.json").Value!.Single().Curve.Length, Is.EqualTo(5));
        Assert.That(Read("[[[0,0],[3,4]],[[1,1],[2,2]]]", "unnamed").Value, Has.Count.EqualTo(2));
    }

    [TestCase("{\"curves\": [\n[[0,0],[1,]]\n]}", "2:")]
    [TestCase("{\"curves\": [\n[[0,0],[1,\"a\"]]\n]}", "2:")]
    [TestCase("{\"points\": [[0,0],[1,1]], \"area\": -1}", "1:")]
    [TestCase("{\"degree\": 3, \"points\": [[0,0],[1,1]]}", "1:")]
    [TestCase("{\"center\": [0,0], \"radius\": -1}", "1:")]
    [TestCase("{\"points\": [[0,0],{\"x\":1,\"y\":2,\"area\":1}]}", "1:")]
    [TestCase("[[0,0],[1,NaN]]", "1:")]
    [TestCase("[[0,0],[1e400,1]]", "1:")]
    [TestCase("12", "1:")]
    [TestCase("{\"units\": \"parsec\", \"points\": [[0,0],[1,1]]}", "1:")]
    [TestCase("[[0,0],[1,1]] 5", "1:")]
    public void Bad_json_is_reported_with_its_place(string text, string place)
    {
        var read = Read(text, "bad.json");
        Assert.That(read.Value, Is.Null);
        Assert.That(read.Diagnostics[0].ToString(), Does.StartWith("bad.json:" + place));
    }

    [Test]
    public void Lines_of_obj_are_read_and_faces_ignored()
    {
        var read = Read("# lines\nv 0 0 0\nv 1 0 0\nv 1 1 0.5\no first\nl 1 2 3\nf 1 2 3\ng second one\nl -1/1 \\\n -3/2\nl 1 2 3 1\n", "a.obj");
        var curves = read.Value!;
        Assert.That(curves.Select(c => c.Name), Is.EqualTo(new[] { "first", "second one", "second one" }));
        Assert.That(((PolylineCurve)curves[0].Curve).Polyline.Points, Is.EqualTo(new Vec3[] { new(0, 0), new(1, 0), new(1, 1, 0.5) }));
        Assert.That(curves[1].Curve.Start, Is.EqualTo(new Vec3(1, 1, 0.5)));
        Assert.That(curves[2].Curve.IsClosed, Is.True);
        Assert.That(read.Diagnostics.Single().Code, Is.EqualTo("curves.faces"));
        var free = Read("v 0 0 0\nv 1 0 0\ncstype bezier\ns off\nl 1 2\n", "a.obj");
        Assert.That(free.Diagnostics.Select(d => (d.Code, d.Source!.Line)), Is.EqualTo(new[] { ("curves.unsupported", 3) }));
    }

    [TestCase("v 0 0 0\nv 1 0 0\nl 1 3\n", "3:5: error curves.obj")]
    [TestCase("v 0 0\n", "1:6: error curves.obj")]
    [TestCase("v 0 0 0\nl 1 x\n", "2:5: error curves.obj")]
    [TestCase("v 0 0 0\nv nan 0 0\nl 1 2\n", "3:5: error curves.not_finite")]
    public void Bad_obj_is_reported_with_its_place(string text, string expected)
        => Assert.That(Read(text, "bad.obj").Diagnostics[0].ToString(), Does.StartWith("bad.obj:" + expected));

    [Test]
    public void Packed_files_are_unpacked()
    {
        using var memory = new MemoryStream();
        using (var packed = new GZipStream(memory, CompressionMode.Compress, true)) packed.Write(Encoding.ASCII.GetBytes("0,0\n3,4\n"), 0, 8);
        Assert.That(CurveReader.Read(memory.ToArray(), "p.csv.gz").Value!.Single().Curve.Length, Is.EqualTo(5));
        Assert.That(CurveReader.Read([0x1F, 0x8B, 8, 0, 1, 2], "p.csv.gz").Diagnostics[0].Code, Is.EqualTo("curves.compression"));
    }

    [Test]
    public void No_bytes_make_a_reader_throw()
    {
        string[] seeds =
        [
            "curve,x,y,z,width\na,0,0,0,50%\na,1,0,0,\"2\"\n\nb;1;2,3\n",
                "{\"curves\": [{\"points\": [[0,0],[1,1.5e3]], \"degree\": 1, \"knots\": [0,0,1,1]}, {\"center\": [1,2], \"radius\": 2}]}",
            "v 0 0 0\nv 1 0 0\nl 1 2\ng x\nl -1 -2\n",
            "<svg width=\"10mm\" viewBox=\"0 0 10 10\"><g transform=\"rotate(5) skewX(3)\"><path d=\"M0 0C1 2 3 4 5 6s1 1 2 2q1 1 2 2t3 3a1 2 30 0 1 4 4z\" "
                + "data-width=\"1\"/><rect width=\"3\" height=\"2\" rx=\"1\"/></g></svg>",
        ];
        string[] names = ["a.csv", "a.json", "a.obj", "a.svg", "a"];
        var random = new Random(51);
        for (var n = 0; n < 4000; n++)
        {
            var bytes = Encoding.UTF8.GetBytes(seeds[random.Next(seeds.Length)]).ToList();
            for (var edits = random.Next(1, 6); edits > 0; edits--)
            {
                var at = random.Next(bytes.Count);
                switch (random.Next(4))
                {
                    case 0:
                        bytes[at] = (byte)random.Next(256);
                        break;
                    case 1:
                        bytes.RemoveAt(at);
                        break;
                    case 2:
                        bytes.Insert(at, (byte)"0123456789.,-e\"<>/%{}[]& \n"[random.Next(25)]);
                        break;
                    default:
                        bytes.RemoveRange(at, Math.Min(bytes.Count - at, random.Next(8)));
                        break;
                }
                if (bytes.Count == 0) bytes.Add(0);
            }
            var read = CurveReader.Read(bytes.ToArray(), names[random.Next(names.Length)]);
            Assert.That(read.Value is null, Is.EqualTo(read.HasErrors));
            if (read.Value is not null) Assert.That(() => CurvePaths.ToPaths(read.Value, new CurveOptions { Subdivision = SubdivisionOptions.ByTolerance(10) }),
                Throws.Nothing);
        }
    }
}
