using Caterpillar.Basics;
using Caterpillar.Expressions;
using Caterpillar.Geometry;

namespace Caterpillar.Shaping;

/// <summary>The coordinates in which the formulas of a deformation are written.</summary>
public enum DeformationSystem
{
    /// <summary><c>x</c>, <c>y</c>, <c>z</c> in mm.</summary>
    Cartesian,

    /// <summary><c>r</c> in mm, <c>theta</c> (or <c>θ</c>) in degrees, <c>z</c> in mm, about a vertical axis.</summary>
    Cylindrical,
}

/// <summary>
/// Deformations as formulas in text (Kanada 2016, section 3.4). Position formulas see the coordinates; the area formula also sees <c>c</c> (mm²), the speed
/// formula <c>v</c> (mm/s), both with the coordinates of the middle of the segment before the mapping. <see cref="Formula"/> describes formulas.
/// </summary>
public static class DeformationText
{
    /// <summary>
    /// Compiles a deformation, for example <c>r + 1.05 * z, theta, 0.3 * z</c> with the area <c>0.96 * c</c>. A coordinate whose formula is empty stays as it
    /// is, as do area and speed.
    /// </summary>
    /// <param name="position">Three formulas with commas between them, or an empty text.</param>
    /// <param name="area">New area of a segment in mm² over <c>c</c> and the coordinates, or null.</param>
    /// <param name="speed">New speed of a segment in mm/s over <c>v</c> and the coordinates, or null; <c>v</c> is 0 where the path uses the speed of the
    /// settings.</param>
    /// <param name="system">The coordinates of the formulas.</param>
    /// <param name="axis">Position of the vertical axis of cylindrical coordinates, mm.</param>
    /// <param name="source">File of the text, for messages; its key becomes that of the formula (<c>position.r</c>, <c>area</c>, <c>speed</c>).</param>
    /// <returns>The deformation; none with an error for each wrong formula, with the formula and the column.</returns>
    public static Result<Deformation> Compile(
        string position, string? area = null, string? speed = null, DeformationSystem system = DeformationSystem.Cartesian, Vec3 axis = default,
            SourceLocation? source = null)
    {
        if (position is null) throw new ArgumentNullException(nameof(position));
        if (position.Trim().Length == 0) return Compile("", "", "", area, speed, system, axis, source);
        var parts = Split(position);
        if (parts.Count == 3) return Compile(parts[0], parts[1], parts[2], area, speed, system, axis, source);
        var names = Names(system);
        return new Result<Deformation>(null,
        [
            new Diagnostic(
                Severity.Error, "shape.position_formulas",
                $"\"{position.Trim()}\" has {NumberFormatter.Format(parts.Count)} formulas. A position needs three: {names[0]}, {names[1]} and {names[2]}.",
                (source ?? new SourceLocation()) with { Key = "position" }),
        ]);
    }

    /// <summary>The same with a text for each coordinate.</summary>
    public static Result<Deformation> Compile(
        string first, string second, string third, string? area, string? speed, DeformationSystem system = DeformationSystem.Cartesian, Vec3 axis = default,
        SourceLocation? source = null)
    {
        var names = Names(system);
        var coordinates = new FormulaSet(Variables(system), source);
        var x = Coordinate(coordinates, first, names[0]);
        var y = Coordinate(coordinates, second, names[1]);
        var z = Coordinate(coordinates, third, names[2]);
        PositionMap? map = x is null && y is null && z is null
            ? null
            : p => new Vec3(x is null ? p.X : Evaluate(x, coordinates, p), y is null ? p.Y : Evaluate(y, coordinates, p), z is null ? p.Z
                : Evaluate(z, coordinates, p));
        var problems = new List<Diagnostic>(coordinates.Problems);
        var areas = Value(area, "c", "area", system, source, problems);
        var speeds = Value(speed, "v", "speed", system, source, problems);
        if (problems.Count > 0) return new Result<Deformation>(null, problems);
        var deformation = system == DeformationSystem.Cartesian ? Deformation.Cartesian(map, areas, speeds) : Deformation.Cylindrical(map, areas, speeds, axis);
        return new Result<Deformation>(deformation, []);
    }

    /// <summary>
    /// Parts of a text at the commas outside of brackets. Each part is padded with leading spaces, so that columns refer to the whole text.
    /// </summary>
    internal static IReadOnlyList<string> Split(string text)
    {
        var parts = new List<string>();
        int depth = 0, from = 0;
        for (var i = 0; i <= text.Length; i++)
        {
            var c = i < text.Length ? text[i] : ',';
            if (c is '(' or '[') depth++;
            else if (c is ')' or ']') depth--;
            if (i < text.Length && (c != ',' || depth > 0)) continue;
            parts.Add(new string(' ', from) + text.Substring(from, i - from));
            from = i + 1;
        }
        return parts;
    }

    private static string[] Names(DeformationSystem system) => system == DeformationSystem.Cartesian ? ["x", "y", "z"] : ["r", "theta", "z"];

    // θ is another name for theta; its slot is filled too. A space cannot be named.
    private static string[] Variables(DeformationSystem system, params string[] more)
        => [.. Names(system), system == DeformationSystem.Cylindrical ? "θ" : " ", .. more];

    private static Formula? Coordinate(FormulaSet set, string text, string name) => text.Trim().Length == 0 ? null : set.Compile(text, "position." + name);

    private static double Evaluate(Formula formula, FormulaSet set, Vec3 p)
    {
        var context = set.Rent();
        Fill(context.Values, p);
        return set.Evaluate(formula, context);
    }

    private static void Fill(double[] values, Vec3 p)
    {
        values[0] = p.X;
        values[1] = p.Y;
        values[2] = p.Z;
        values[3] = p.Y;
    }

    private static ValueMap? Value(string? text, string name, string purpose, DeformationSystem system, SourceLocation? source, List<Diagnostic> problems)
    {
        if (text is null || text.Trim().Length == 0) return null;
        var set = new FormulaSet(Variables(system, name), source);
        var formula = set.Compile(text, purpose);
        problems.AddRange(set.Problems);
        if (formula is null) return null;
        return (value, p) =>
        {
            var context = set.Rent();
            Fill(context.Values, p);
            context.Values[4] = value;
            return set.Evaluate(formula, context);
        };
    }
}
