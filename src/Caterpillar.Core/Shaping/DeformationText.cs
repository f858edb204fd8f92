namespace Caterpillar.Shaping;

/// <summary>Coordinate system of the formulas of a deformation.</summary>
public enum DeformationSystem
{
    /// <summary><c>x</c>, <c>y</c>, <c>z</c> in mm.</summary>
    Cartesian,

    /// <summary><c>r</c> in mm, <c>theta</c> (or <c>θ</c>) in degrees, <c>z</c> in mm, about a vertical axis.</summary>
    Cylindrical,
}

/// <summary>
/// Deformations from text formulas (Kanada 2016, section 3.4). The variables are the coordinates. The area formula also has <c>c</c> (mm²), the speed
/// formula <c>v</c> (mm/s), both at the midpoint of the segment before the position map. See <see cref="Formula"/> for the syntax.
/// </summary>
public static class DeformationText
{
    /// <summary>
    /// Compiles a deformation, for example <c>r + 1.05 * z, theta, 0.3 * z</c> with the area <c>0.96 * c</c>. A coordinate, area or speed whose formula is
    /// empty stays unchanged.
    /// </summary>
    /// <param name="position">Three formulas separated by commas, or empty.</param>
    /// <param name="area">Formula for the new area of a segment in mm², with <c>c</c> and the coordinates, or null.</param>
    /// <param name="speed">Formula for the new speed of a segment in mm/s, with <c>v</c> and the coordinates, or null. <c>v</c> is 0 if the path has no
    /// speed of its own.</param>
    /// <param name="system">Coordinate system of the formulas.</param>
    /// <param name="axis">Position of the vertical axis of cylindrical coordinates, mm.</param>
    /// <param name="source">Source of the text, for messages. Its key becomes the name of the formula (<c>position.r</c>, <c>area</c>, <c>speed</c>).</param>
    /// <returns>The deformation, or one error for each wrong formula, with the formula and the column.</returns>
    public static Result<Deformation> Compile(
        string position, string? area = null, string? speed = null, DeformationSystem system = DeformationSystem.Cartesian, Vec3 axis = default,
            SourceLocation? source = null)
    {
        if (position is null) throw new ArgumentNullException(nameof(position));
        if (position.Trim().Length == 0) return Compile("", "", "", area, speed, system, axis, source);
        var parts = Split(position);
        if (parts.Count == 3) return Compile(parts[0], parts[1], parts[2], area, speed, system, axis, source);
        var names = Names(system);
        return new Result<Deformation>("shape.position_formulas",
            $"\"{position.Trim()}\" has {NumberFormatter.Format(parts.Count)} formulas. A position needs three: {names[0]}, {names[1]} and {names[2]}.",
            (source ?? new SourceLocation()) with { Key = "position" });
    }

    /// <summary>Compiles a deformation from one formula per coordinate.</summary>
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

    /// <summary>The parts of a text from a place on, at its commas outside of brackets. Leading spaces keep the columns of the whole text.</summary>
    internal static IReadOnlyList<string> Split(string text, int from = 0)
    {
        var parts = new List<string>();
        var depth = 0;
        for (var i = from; i <= text.Length; i++)
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
        var context = set.Context;
        Fill(context.Values, p);
        return formula.Evaluate(context);
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
            var context = set.Context;
            Fill(context.Values, p);
            context.Values[4] = value;
            return formula.Evaluate(context);
        };
    }
}
