using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Files;
using Caterpillar.GH.Components.Slice;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Components;

[Category("Host")]
public sealed class CurvedSlicerTests
{
    private static readonly PrintSettings Quick = new() { LayerHeight = 0.5, FirstLayerHeight = 0.5, LineWidth = 0.6, WallCount = 1, SkirtLoops = 0 };

    private static Canvas<CurvedSlicerComponent> Slice(object? field, params object?[] geometry)
        => new Canvas<CurvedSlicerComponent>().Feed("Setup", Quick).Feed("Field", field).Feed("Geometry", geometry).Solve();

    private static FieldRecipe? Field(FieldKind kind, params (string Port, object?[] Values)[] ports) => Make(kind, ports).One<FieldRecipe?>("Field");

    private static Canvas<LayerFieldComponent> Make(FieldKind kind, params (string Port, object?[] Values)[] ports)
    {
        var canvas = new Canvas<LayerFieldComponent>().Feed("Kind", kind.ToString());
        if (ports.Any(p => p.Port == "Heights")) canvas.Feed("Sources", "Formula");
        if (ports.Any(p => p.Port == "Image")) canvas.Feed("Sources", "Height Map");
        foreach (var (port, values) in ports) canvas.Feed(port, values);
        return canvas.Solve();
    }

    // A slanted rectangle over the box: 0.1 mm rise per mm of x, 0 at x = 100.
    private static Rg.Mesh Slope(double from = 90, double to = 120)
    {
        var mesh = new Rg.Mesh();
        mesh.Vertices.UseDoublePrecisionVertices = true;
        foreach (var (x, y) in new[] { (from, 90.0), (to, 90.0), (to, 120.0), (from, 120.0) }) mesh.Vertices.Add(x, y, 0.1 * (x - 100));
        mesh.Faces.AddFace(0, 1, 2, 3);
        return mesh;
    }

    // How far points of one path are from a copy of the slope, mm.
    private static double Spread(PrintPath path)
    {
        var heights = path.Points.Select(p => p.Z - 0.1 * (p.X - 100)).ToArray();
        return heights.Max() - heights.Min();
    }

    private static PrintPath[] Walls(Canvas<CurvedSlicerComponent> canvas) => canvas.All("Walls").Cast<PrintPath>().ToArray();

    // The ends of a box of 2 mm height are its bottom and its top: layers are even between them, found or given by a surface and a curve.
    [TestCase(FieldKind.Harmonic, false)]
    [TestCase(FieldKind.Geodesic, false)]
    [TestCase(FieldKind.Harmonic, true)]
    public void Layers_change_evenly_between_the_ends_of_the_solid(FieldKind kind, bool given)
    {
        var box = Shapes.Box();
        var (low, high) = (box.GetBoundingBox(true).Min, box.GetBoundingBox(true).Max);
        var corners = new[] { (low.X, low.Y), (high.X, low.Y), (high.X, high.Y), (low.X, high.Y) };
        var top = new Rg.Mesh();
        foreach (var (x, y) in corners) top.Vertices.Add(x, y, high.Z);
        top.Faces.AddFace(0, 1, 2, 3);
        var edge = new Rg.PolylineCurve(corners.Append(corners[0]).Select(c => new Rg.Point3d(c.Item1, c.Item2, low.Z)));
        var field = given ? Make(kind, ("Surfaces", new object?[] { top }), ("Lower Boundaries", new object?[] { edge })) : Make(kind);
        Assert.That(field.Errors, Is.Empty);
        var curved = Slice(field.One<FieldRecipe?>("Field"), box);
        Assert.That(curved.Errors, Is.Empty);
        Assert.That(curved.Component.Message, Is.EqualTo("4 layers"));
        Assert.That(Walls(curved), Is.Not.Empty);
        foreach (var wall in Walls(curved)) Assert.That(wall.Points.Max(p => p.Z) - wall.Points.Min(p => p.Z), Is.LessThan(0.05));
    }

    // Each corner of the box is three vertices of its mesh, here those of its sides.
    [TestCase(FieldKind.Harmonic)]
    [TestCase(FieldKind.Geodesic)]
    public void The_ends_can_be_vertices_by_their_numbers_in_the_mesh(FieldKind kind)
    {
        var field = Make(kind, ("Upper Vertices", new object?[] { 10, 11, 14, 18 }), ("Lower Vertices", new object?[] { 8, 9, 13, 17 }));
        Assert.That(field.Errors, Is.Empty);
        var curved = Slice(field.One<FieldRecipe?>("Field"), Shapes.Box());
        Assert.That(curved.Errors, Is.Empty);
        Assert.That(curved.Component.Message, Is.EqualTo("4 layers"));
        foreach (var wall in Walls(curved)) Assert.That(wall.Points.Max(p => p.Z) - wall.Points.Min(p => p.Z), Is.LessThan(0.05));
    }

    [Test]
    public void Vertices_that_do_not_exist_and_several_solids_are_errors()
    {
        FieldRecipe? Recipe(params object?[] upper)
            => Make(FieldKind.Harmonic, ("Upper Vertices", upper), ("Lower Vertices", new object?[] { 0, 1 })).One<FieldRecipe?>("Field");
        Assert.That(Slice(Recipe(4, 24), Shapes.Box()).Errors, Has.One.Contains("The solid has no vertex 24."));
        Assert.That(Slice(Recipe(-1), Shapes.Box()).Errors, Has.One.Contains("The solid has no vertex -1."));
        Assert.That(Slice(Recipe(4), Shapes.Box(), Shapes.Box(130)).Errors, Has.One.Contains("need exactly one solid"));
        Assert.That(Slice(Make(FieldKind.Harmonic, ("Upper Vertices", new object?[] { 4 })).One<FieldRecipe?>("Field"), Shapes.Box()).Errors,
            Has.One.Contains("Each boundary needs vertices."));
        Assert.That(Make(FieldKind.Harmonic, ("Upper Vertices", new object?[] { 4 }), ("Surfaces", new object?[] { Shapes.Box() })).Errors,
            Has.One.Contains("Give either vertices, or surfaces and curves."));
    }

    [Test]
    public void The_ends_of_layers_have_to_touch_the_solid()
    {
        var far = Shapes.Box(160);
        var curved = Slice(Field(FieldKind.Harmonic, ("Surfaces", new object?[] { far })), Shapes.Box());
        Assert.That(curved.Errors.Single(), Does.Contain("touches no vertex"));
        Assert.That(Make(FieldKind.Harmonic, ("Lower Boundaries", new object?[] { far })).Errors.Single(), Does.Contain("Lower Boundaries need Surfaces"));
    }

    [Test]
    public void The_field_z_gives_planar_layers()
    {
        var planar = new Canvas<PlanarSlicerComponent>().Feed("Setup", Quick).Feed("Geometry", Shapes.Box()).Solve();
        var curved = Slice("z", Shapes.Box());
        Assert.That(curved.Errors, Is.Empty);
        Assert.That(curved.Paths("Print Paths"), Is.EqualTo(planar.Paths("Print Paths")));
        Assert.That(Walls(curved).Select(p => Math.Round(p.Length, 3)), Is.EqualTo(planar.All("Walls").Cast<PrintPath>().Select(p => Math.Round(p.Length, 3))));
        Assert.That(curved.Component.Message, Is.EqualTo("4 layers"));
    }

    [Test]
    public void Smooth_layers_need_nothing_but_the_solid()
    {
        var curved = Slice(Field(FieldKind.Smooth), Shapes.Box());
        Assert.That(curved.Errors, Is.Empty);
        Assert.That(curved.Component.Message, Is.EqualTo("4 layers"));
    }

    [Test]
    public void Layers_are_copies_of_a_surface_at_the_port_itself()
    {
        var canvas = Slice(Slope(), Shapes.Box(height: 3));
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(Walls(canvas), Is.Not.Empty.And.All.Matches<PrintPath>(p => Spread(p) < 0.03));
        Assert.That(Walls(canvas).Any(p => p.Bounds.Size.Z > 0.5), Is.True, "They are not level.");
    }

    [Test]
    public void A_surface_a_formula_and_an_image_make_the_same_layers()
    {
        var box = Shapes.Box(height: 3);
        var image = Path.Combine(Path.GetTempPath(), "caterpillar-slope.png");
        // Two dots: their middles are at a quarter and three quarters of the box, between them the heights rise evenly.
        File.WriteAllBytes(image, PngWriter.ToBytes(new RasterImage(2, 1, new Rgb(0, 0, 0)) { [1, 0] = new Rgb(255, 255, 255) }));
        var mesh = Walls(Slice(Field(FieldKind.Vertical, ("Surfaces", [Slope()])), box));
        var formula = Walls(Slice(Field(FieldKind.Vertical, ("Heights", ["0.1 * (x - 100)"])), box));
        var shifted = Walls(Slice(Field(FieldKind.Vertical, ("Heights", ["0.1 * x"]), ("Origin", [new Rg.Point3d(100, 0, 0)])), box));
        var map = Walls(Slice(Field(FieldKind.Vertical, ("Image", [image]), ("Low", [0.25]), ("High", [0.75])), box));
        Assert.That(formula.Sum(p => p.Length), Is.EqualTo(mesh.Sum(p => p.Length)).Within(0.5));
        Assert.That(shifted.Select(p => p.Length), Is.EqualTo(formula.Select(p => p.Length)).Within(1e-6));
        Assert.That(map.Where(p => p.Bounds.Size.Z > 0), Is.Not.Empty);
        Assert.That(map.SelectMany(p => p.Points).Where(p => p.X is > 103 and < 107).All(p => p.IsFinite), Is.True);
    }

    [Test]
    public void Between_the_bed_and_a_surface_every_place_has_as_many_layers()
    {
        var roof = Slope().DuplicateMesh();
        roof.Translate(new Rg.Vector3d(0, 0, 3));
        var solid = Shapes.Box(height: 5);
        var canvas = Slice(Field(FieldKind.Between, ("Surfaces", [roof])), solid);
        Assert.That(canvas.Errors, Is.Empty);
        var layers = Walls(canvas).Where(p => p.Role == Role.OuterWall).ToArray();
        double At(PrintPath path, double x) => path.Points.OrderBy(p => Math.Abs(p.X - x)).First().Z;
        // The roof is 3 mm high on the left and 4 mm on the right.
        Assert.That(layers[0].Bounds.Size.Z, Is.GreaterThan(0));
        Assert.That(At(layers[1], 110) / At(layers[1], 100), Is.EqualTo(4.0 / 3).Within(0.05));
    }

    [Test]
    public void Cones_offsets_overhangs_and_bent_solids_are_sliced()
    {
        var cone = Walls(Slice(Field(FieldKind.Cone, ("Angle", [20.0])), Shapes.Box(height: 4)));
        var ring = cone.First(p => p.Bounds.Size.Z > 0.1);
        var corner = ring.Points.OrderByDescending(p => Math.Abs(p.X - 105) + Math.Abs(p.Y - 105)).First();
        var middle = ring.Points.OrderBy(p => Math.Abs(p.Y - 105)).First();
        Assert.That(corner.Z, Is.LessThan(middle.Z), "Outward is down.");
        Assert.That(Slice(Field(FieldKind.Normal, ("Surfaces", [Slope()])), Shapes.Box(height: 3)).Errors, Is.Empty);
        Assert.That(Slice(Field(FieldKind.Overhangs), Shapes.Box()).Errors, Is.Empty);
        var bent = Slice(Field(FieldKind.Deformed, ("Expressions", ["x", "y", "z - 0.1 * (x - 100)"])), Shapes.Box(height: 3));
        Assert.That(bent.Errors, Is.Empty);
        Assert.That(Walls(bent), Is.Not.Empty.And.All.Matches<PrintPath>(p => Spread(p) < 0.03));
        var formula = Slice(Field(FieldKind.Formula, ("Expressions", ["z - 0.1 * (x - 100)"])), Shapes.Box(height: 3));
        Assert.That(Walls(formula), Is.Not.Empty.And.All.Matches<PrintPath>(p => Spread(p) < 0.03));
    }

    [Test]
    public void A_blend_begins_level_and_ends_parallel_to_the_surface()
    {
        var canvas = Slice(Field(FieldKind.Vertical, ("Heights", ["3 + 0.1 * (x - 105)"]), ("Blend From", [0.5]), ("Blend To", [3.0])),
            Shapes.Box(height: 3));
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(Walls(canvas)[0].Bounds.Size.Z, Is.EqualTo(0).Within(1e-6));
        Assert.That(Walls(canvas).Max(w => w.Bounds.Size.Z), Is.GreaterThan(0.3));
    }

    [Test]
    public void A_surface_that_is_too_small_is_refused_unless_a_part_will_do()
    {
        var small = Slope(90, 105);
        Assert.That(Slice(small, Shapes.Box()).Errors, Has.Some.Contains("curved.outside_plan"));
        var partial = Slice(small, Shapes.Box()).Feed("Partial", true).Solve();
        Assert.That(partial.Errors, Is.Empty);
        Assert.That(Walls(partial).SelectMany(p => p.Points).Max(p => p.X), Is.LessThanOrEqualTo(105.05));
    }

    [Test]
    public void An_object_on_the_bed_is_printed_on()
    {
        var floor = RhinoMesh.ToTriangles(Shapes.Box(90, 90, 40, 1), DocumentUnits.Current);
        var setup = new SetupGoo { Value = new PrintSetup { Settings = Quick, PrintedOn = floor } };
        var canvas = Slice("z", Shapes.Box(height: 4)).Feed("Setup", setup).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(Walls(canvas).SelectMany(p => p.Points).Min(p => p.Z), Is.GreaterThan(1));
    }

    [Test]
    public void A_surface_that_has_not_changed_is_not_sliced_again()
    {
        var canvas = Slice(Slope(), Shapes.Box(height: 3));
        var first = canvas.All("Walls")[0];
        canvas.Feed("Field", Slope()).Solve();
        Assert.That(canvas.All("Walls")[0], Is.SameAs(first));
        canvas.Feed("Field", Slope(80)).Solve();
        Assert.That(canvas.All("Walls")[0], Is.Not.SameAs(first));
    }

    [Test]
    public void Other_units_are_scaled()
    {
        using var _ = new InDocument(UnitSystem.Centimeters);
        var slope = Slope();
        slope.Scale(0.1);
        var canvas = Slice(slope, Shapes.Box(10, 10, 1, 0.3));
        Assert.That(Walls(canvas), Is.Not.Empty.And.All.Matches<PrintPath>(p => Spread(p) < 0.03));
    }

    [TestCase(FieldKind.Vertical, "needs a surface")]
    [TestCase(FieldKind.Normal, "needs a surface")]
    [TestCase(FieldKind.Between, "needs at least one surface")]
    [TestCase(FieldKind.Formula, "needs exactly one expression")]
    [TestCase(FieldKind.Cone, "needs an angle")]
    [TestCase(FieldKind.Deformed, "needs three expressions")]
    public void A_field_names_what_it_lacks(FieldKind kind, string text)
    {
        var canvas = Make(kind);
        Assert.That(canvas.Errors.Concat(canvas.Warnings), Has.One.Contains(text));
        Assert.That(canvas.One<FieldRecipe?>("Field"), Is.Null);
    }

    [Test]
    public void Wrong_formulas_angles_blends_and_files_are_errors()
    {
        Assert.That(Make(FieldKind.Formula, ("Expressions", ["z +"])).Errors, Is.Not.Empty);
        Assert.That(Make(FieldKind.Vertical, ("Heights", ["x *"])).Errors, Is.Not.Empty);
        Assert.That(Make(FieldKind.Vertical, ("Heights", ["x", "y"])).Errors, Has.One.Contains("needs exactly one surface"));
        Assert.That(Make(FieldKind.Cone, ("Angle", [89.0])).Errors, Has.One.Contains("-80 to 80"));
        Assert.That(Make(FieldKind.Vertical, ("Heights", ["x"]), ("Blend From", [2.0])).Errors, Has.One.Contains("needs Blend To"));
        Assert.That(Make(FieldKind.Vertical, ("Heights", ["x"]), ("Blend From", [2.0]), ("Blend To", [1.0])).Errors,
            Has.One.Contains("greater than Blend From"));
        Assert.That(Make(FieldKind.Vertical, ("Image", ["/nowhere.png"])).Errors, Has.One.Contains("File not found"));
        Assert.That(Make(FieldKind.Vertical, ("Image", ["/nowhere.png"]), ("Low", [3.0])).Errors, Is.Not.Empty);
        Assert.That(Slice("z + ", Shapes.Box()).Errors, Has.Some.StartsWith("Field: ").And.Some.Contains("formula."));
        var tilted = new Canvas<CurvedSlicerComponent>().Feed("Setup", Quick).Feed("Field", "z").Feed("Geometry", Shapes.Box()).Feed("Max Tilt", 91.0);
        Assert.That(tilted.Solve().Errors, Has.One.Contains("an angle from 0 to 90 degrees"));
        Assert.That(Slice("sin(x)", Shapes.Box()).Errors, Has.Some.Contains("curved."));
    }

    [Test]
    public void Recipes_from_the_same_parts_are_equal()
    {
        FieldRecipe? Of(double height) => Field(FieldKind.Vertical, ("Heights", [$"{height} + x"]));
        Assert.That(Of(1), Is.EqualTo(Of(1)).And.Not.SameAs(Of(1)));
        Assert.That(Of(1)!.GetHashCode(), Is.EqualTo(Of(1)!.GetHashCode()));
        Assert.That(Of(1), Is.Not.EqualTo(Of(2)));
        Assert.That(Of(1)!.ToString(), Is.EqualTo("Vertical"));
    }
}
