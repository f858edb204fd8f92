using System;
using System.Collections.Generic;
using System.Linq;
using GH_IO.Serialization;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Parameters;
using Grasshopper.Kernel.Types;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Host;

/// <summary>The stand-in behaves like Grasshopper where the components rely on it.</summary>
[Category("Host")]
public sealed class HostTests
{
    /// <summary>Adds two numbers; throws on 13.</summary>
    public sealed class Adder : GH_Component
    {
        public Adder() : base("Adder", "Add", "Adds.", "Test", "Test")
        {
        }

        public int Runs { get; private set; }

        public override Guid ComponentGuid => new("9ad7f9a3-9a55-4b7c-b1c5-1f1c5d5e7f10");

        protected override void RegisterInputParams(GH_InputParamManager pManager)
        {
            pManager.AddParameter(new Param_Number(), "A", "A", "A.", GH_ParamAccess.item);
            var b = new Param_Number();
            b.SetPersistentData(1.0);
            pManager.AddParameter(b, "B", "B", "B.", GH_ParamAccess.item);
            pManager.AddParameter(new Param_Number { Optional = true }, "C", "C", "C.", GH_ParamAccess.list);
        }

        protected override void RegisterOutputParams(GH_OutputParamManager pManager)
        {
            pManager.AddParameter(new Param_Number(), "Sum", "S", "Sum.", GH_ParamAccess.item);
            pManager.AddParameter(new Param_Number(), "Both", "L", "Both.", GH_ParamAccess.list);
        }

        protected override void SolveInstance(IGH_DataAccess DA)
        {
            Runs++;
            double a = 0, b = 0;
            if (!DA.GetData(0, ref a) || !DA.GetData(1, ref b)) return;
            if (a == 13) throw new InvalidOperationException("Unlucky.");
            var more = new List<double>();
            DA.GetDataList(2, more);
            DA.SetData(0, a + b + more.Sum());
            DA.SetDataList(1, new[] { a, b });
        }
    }

    [Test]
    public void A_default_stands_in_for_a_missing_wire()
        => Assert.That(new Canvas<Adder>().Feed("A", 2.0).Solve().All("Sum"), Is.EqualTo(new object[] { 3.0 }));

    [Test]
    public void A_missing_input_is_a_warning_and_nothing_runs()
    {
        var canvas = new Canvas<Adder>().Solve();
        Assert.That(canvas.Warnings, Is.EqualTo(new[] { "Input parameter A failed to collect data" }));
        Assert.That(canvas.Component.Runs, Is.Zero);
    }

    [Test]
    public void The_last_item_of_the_shorter_list_repeats()
        => Assert.That(new Canvas<Adder>().Feed("A", 1, 2, 3).Feed("B", 10, 20).Solve().All("Sum"), Is.EqualTo(new object[] { 11.0, 22.0, 23.0 }));

    [Test]
    public void The_last_branch_of_the_smaller_tree_repeats_and_outputs_follow_the_larger()
    {
        var canvas = new Canvas<Adder>().FeedTree("A", [1, 2], [3], [4]).FeedTree("B", [10], [20]).Solve();
        Assert.That(canvas.Paths("Sum"), Is.EqualTo(new[] { "{0}", "{1}", "{2}" }));
        Assert.That(canvas.All("Sum"), Is.EqualTo(new object[] { 11.0, 12.0, 23.0, 24.0 }));
        Assert.That(canvas.Paths("Both"), Is.EqualTo(new[] { "{0;0}", "{0;1}", "{1;0}", "{2;0}" }));
    }

    [Test]
    public void A_list_takes_part_once_per_branch()
        => Assert.That(new Canvas<Adder>().Feed("A", 1, 2).Feed("C", 100, 200).Solve().All("Sum"), Is.EqualTo(new object[] { 302.0, 303.0 }));

    [Test]
    public void A_null_leaves_a_gap_and_text_that_is_a_number_is_one()
        => Assert.That(new Canvas<Adder>().Feed("A", "5", null, 7).Solve().All("Sum"), Is.EqualTo(new object?[] { 6.0, null, 8.0 }));

    [Test]
    public void A_failed_conversion_is_an_error_of_the_parameter_and_a_null()
    {
        var canvas = new Canvas<Adder>().Feed("A", "five", 1).Solve();
        Assert.That(canvas.Errors, Is.EqualTo(new[] { "Data conversion failed from Text to Number" }));
        Assert.That(canvas.All("Sum"), Is.EqualTo(new object?[] { null, 2.0 }));
    }

    [Test]
    public void An_exception_ends_the_component()
        => Assert.That(new Canvas<Adder>().Feed("A", 13, 1).Solve().Errors, Is.EqualTo(new[] { "Unlucky." }));

    [Test]
    public void Wires_pass_results_on_and_only_expired_objects_solve_again()
    {
        var canvas = new Canvas<Adder>().Feed("A", 1);
        var second = new Adder();
        canvas.Document.AddObject(second, false, 0);
        second.Params.Input[0].AddSource(canvas.Output("Sum"));
        canvas.Solve().Solve();
        Assert.That(((GH_Number)second.Params.Output[0].VolatileData.get_Branch(0)[0]!).Value, Is.EqualTo(3));
        Assert.That((canvas.Component.Runs, second.Runs), Is.EqualTo((1, 1)));
        canvas.Feed("B", 5).Solve();
        Assert.That(((GH_Number)second.Params.Output[0].VolatileData.get_Branch(0)[0]!).Value, Is.EqualTo(7));
        Assert.That((canvas.Component.Runs, second.Runs), Is.EqualTo((2, 2)));
    }

    [Test]
    public void Scheduled_work_runs_after_the_solution()
    {
        var document = new GH_Document();
        var calls = 0;
        document.ScheduleSolution(10, _ => calls++);
        Assert.That(calls, Is.Zero);
        Assert.That(document.RunSchedule(), Is.True);
        Assert.That((calls, document.SolutionCount, document.RunSchedule()), Is.EqualTo((1, 1, false)));
    }

    [Test]
    public void An_archive_has_the_form_of_a_ghx_file_and_reads_back()
    {
        var param = new Param_Number { NickName = "Höhe" };
        param.SetPersistentData(0.1, 1e-7, -3.0);
        var archive = new GH_Archive();
        archive.AppendObject(param, "Container");
        var text = archive.Serialize_Xml();
        Assert.That(text, Does.StartWith("<?xml version=\"1.0\" encoding=\"utf-8\" standalone=\"yes\"?>\n<Archive name=\"Root\">\n  <!--Grasshopper "
            + "archive-->\n  <!--Grasshopper and GH_IO.dll are copyrighted by Robert McNeel & Associates-->\n  <!--Archive generated by GH_IO.dll file utility "
            + "library {0.2.0002}-->\n  <items count=\"1\">\n"
            + "    <item name=\"ArchiveVersion\" type_name=\"gh_version\" type_code=\"80\">\n      <Major>0</Major>\n"));
        Assert.That(text, Does.Contain("<chunk name=\"Branch\" index=\"0\">")
            .And.Contain("<item name=\"number\" type_name=\"gh_double\" type_code=\"6\">0.1</item>"));
        var read = new GH_Archive();
        Assert.That(read.Deserialize_Xml(text), Is.True);
        var copy = new Param_Number();
        Assert.That(read.ExtractObject(copy, "Container"), Is.True);
        Assert.That(copy.NickName, Is.EqualTo("Höhe"));
        Assert.That(copy.InstanceGuid, Is.EqualTo(param.InstanceGuid));
        Assert.That(copy.PersistentData.Branches[0].Select(n => n.Value), Is.EqualTo(new[] { 0.1, 1e-7, -3.0 }));
    }

    [Test]
    public void Rational_curves_run_along_their_circle()
    {
        var arc = new Rg.ArcCurve(new Rg.Circle(new Rg.Point3d(1, 2, 3), 5));
        var nurbs = arc.ToNurbsCurve();
        Assert.That((nurbs.Degree, nurbs.Points.Count, nurbs.Knots.Count), Is.EqualTo((2, 9, 10)));
        for (var i = 0; i <= 40; i++)
        {
            var p = nurbs.PointAt(nurbs.Domain.ParameterAt(i / 40.0));
            Assert.That(p.DistanceTo(new Rg.Point3d(1, 2, 3)), Is.EqualTo(5).Within(1e-12));
        }
        Assert.That(nurbs.GetLength(), Is.EqualTo(2 * Math.PI * 5).Within(1e-6));
        Assert.That(nurbs.IsClosed, Is.True);
    }

    [Test]
    public void Planes_map_onto_each_other()
    {
        var from = new Rg.Plane(new Rg.Point3d(1, 2, 3), new Rg.Vector3d(0, 0, 1));
        var to = new Rg.Plane(new Rg.Point3d(-4, 0, 7), new Rg.Vector3d(1, 2, 0), new Rg.Vector3d(0, 0, 1));
        var map = Rg.Transform.PlaneToPlane(from, to);
        Assert.That((map * from.PointAt(3, 4, 5)).DistanceTo(to.PointAt(3, 4, 5)), Is.LessThan(1e-12));
    }
}
