namespace Caterpillar.Geometry;

/// <summary>Which pairs of winding numbers of two operands count as inside.</summary>
internal enum InsideRule : byte
{
    NonZero,
    EvenOdd,
    Positive,
    Intersection,
    Difference,
}

internal static class InsideRules
{
    public static bool Holds(this InsideRule rule, int first, int second) => rule switch
    {
        InsideRule.NonZero => first != 0,
        InsideRule.EvenOdd => (first & 1) != 0,
        InsideRule.Positive => first > 0,
        InsideRule.Intersection => first > 0 && second > 0,
        _ => first > 0 && second <= 0,
    };
}
