namespace Caterpillar.Shaping;

/// <summary>Fields from text formulas.</summary>
public static class FieldText
{
    private static readonly string[] Variables = ["x", "y", "z", "r", "theta", "s", "u", "path", "θ"];

    /// <summary>
    /// Compiles a field with the variables <c>x</c>, <c>y</c>, <c>z</c> (mm), <c>r</c> (mm) and <c>theta</c> (or <c>θ</c>, degrees, −180 to 180) about a
    /// vertical axis, <c>s</c> (length along the path, mm), <c>u</c> (the same from 0 to 1) and <c>path</c> (index of the path, from 0).
    /// For example <c>0.5 + 0.5 * sin(6 * theta + 20 * z)</c>.
    /// </summary>
    /// <param name="text">Formula with values from 0 to 1, for modulations.</param>
    /// <param name="axis">Position of the vertical axis, mm.</param>
    /// <param name="source">Source of the text, for messages.</param>
    /// <returns>The field, or an error with the formula and the column.</returns>
    public static Result<Field> Compile(string text, Vec3 axis = default, SourceLocation? source = null)
    {
        if (text is null) throw new ArgumentNullException(nameof(text));
        var set = new FormulaSet(Variables, source);
        var formula = set.Compile(text, "field");
        if (formula is null) return new Result<Field>(null, set.Problems);
        return new Result<Field>(
            place =>
            {
                var context = set.Context;
                var values = context.Values;
                var d = place.Position - axis;
                values[0] = place.Position.X;
                values[1] = place.Position.Y;
                values[2] = place.Position.Z;
                values[3] = d.LengthXY;
                values[4] = values[8] = Angle.Atan2(d.Y, d.X);
                values[5] = place.Distance;
                values[6] = place.Length > 0 ? place.Distance / place.Length : 0;
                values[7] = place.Path;
                return formula.Evaluate(context);
            },
            set.Problems);
    }
}
