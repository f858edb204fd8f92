using System.Collections.Generic;
using Caterpillar.Basics;
using K = Caterpillar.Machines.Keys<Caterpillar.Machines.PrintSettings>;

namespace Caterpillar.Machines;

/// <summary>Keys of print settings: what fills the inside of a part.</summary>
internal static class InfillKeys
{
    /// <summary>Patterns that close an area.</summary>
    public static readonly (string Word, InfillPattern Value)[] SolidPatterns =
    [
        ("monotonic", Machines.InfillPattern.Monotonic), ("lines", Machines.InfillPattern.Lines), ("concentric", Machines.InfillPattern.Concentric),
        ("hilbert", Machines.InfillPattern.Hilbert),
    ];

    private static readonly (string Word, InfillPattern Value)[] Patterns =
    [
        ("lines", Machines.InfillPattern.Lines), ("monotonic", Machines.InfillPattern.Monotonic), ("grid", Machines.InfillPattern.Grid),
        ("triangles", Machines.InfillPattern.Triangles), ("cubic", Machines.InfillPattern.Cubic),
        ("gyroid", Machines.InfillPattern.Gyroid), ("honeycomb", Machines.InfillPattern.Honeycomb), ("concentric", Machines.InfillPattern.Concentric),
        ("hilbert", Machines.InfillPattern.Hilbert), ("lightning", Machines.InfillPattern.Lightning), ("formula", Machines.InfillPattern.Formula),
        ("curves", Machines.InfillPattern.Curves),
    ];

    private static readonly string[] FormulaVariables = ["x", "y", "z", "layer", "spacing", "width"];

    public static readonly ProfileKey<PrintSettings, InfillPattern> InfillPattern = K.Choice(
        "infill_pattern", s => s.InfillPattern, (s, v) => s with { InfillPattern = v },
        "What the lines of the infill look like.", Patterns);

    public static readonly ProfileKey<PrintSettings, double> InfillTurn = K.Number(
        "infill_turn_deg", -360, 360, s => s.InfillTurn, (s, v) => s with { InfillTurn = v },
        "By how much the direction of the infill turns from layer to layer.");

    public static readonly ProfileKey<PrintSettings, string> InfillFormula = new(
        "infill_formula", new FormulaFormat(FormulaVariables), s => s.InfillFormula, (s, v) => s with { InfillFormula = v },
        "For the pattern formula: the strands run where this formula in x, y, z (mm), layer, spacing and width is zero.");

    public static readonly ProfileKey<PrintSettings, ValueList<InfillPoint>> InfillCurves = new(
        "infill_curves_mm",
        new RowsFormat<InfillPoint>(["curve", "x", "y"], 0, 1_000_000, -100_000, 100_000, InfillPoint.Of, p => [p.Curve, p.X, p.Y]),
        s => s.InfillCurves, (s, v) => s with { InfillCurves = v },
        "For the pattern curves: the strands of each layer, cut at its walls; a list of points [curve, x, y] of the bed. slice --infill-curves reads them "
            + "from a file.");

    public static readonly ProfileKey<PrintSettings, int> InfillEvery = K.Integer(
        "infill_every_layers", 1, 1000, s => s.InfillEvery, (s, v) => s with { InfillEvery = v },
        "The infill of so many layers is printed at once, as thick as all of them.");

    public static readonly ProfileKey<PrintSettings, bool> InfillFirst = K.Boolean(
        "infill_before_walls", s => s.InfillFirst, (s, v) => s with { InfillFirst = v },
        "The infill of an island is printed before its walls.");

    public static readonly IReadOnlyList<ProfileKey<PrintSettings>> All =
    [
        InfillPattern, InfillTurn, InfillFormula, InfillCurves, InfillEvery, InfillFirst,
    ];
}
