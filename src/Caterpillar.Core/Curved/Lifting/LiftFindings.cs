namespace Caterpillar.Curved;

/// <summary>Reports what was noticed while paths were lifted back into the part.</summary>
internal static class LiftFindings
{
    private const string NotPrinted = " They are not printed.";

    public static void Add(LiftReport report, LiftRules rules, IEnumerable<IEnumerable<PathStep>> layers, DiagnosticList problems)
    {
        // Shorter than an extrusion is wide nothing is missed, and the checks look at every move.
        if (report.Steep.Length > rules.Settings.LineWidth)
        {
            problems.Add(rules.Partial ? Severity.Warning : Severity.Error, "curved.too_steep",
                $"{Text(report.Steep.Length, 0)} mm of paths are steeper than the {Text(rules.MaxSlope, 1)} degrees that the print head allows, up to "
                + $"{Text(report.Steep.Worst, 1)} degrees at {report.Steep.Place}." + (rules.Partial ? NotPrinted
                    : $" A head passes that is within {Text(HeadSlope.HalfAngle(report.Steep.Worst, layers, rules.TipReach), 1)} degrees of its axis up to "
                        + $"{Text(rules.Rise, 1)} mm above the tip."));
        }
        if (report.Below.Length > 0)
        {
            problems.Add(Severity.Warning, "curved.below_surface",
                $"{Text(report.Below.Length, 0)} mm of paths are below the surface that is printed on, by up to {Text(report.Below.Worst, 3)} mm at "
                + $"{report.Below.Place}." + NotPrinted);
        }
        if (report.Uncovered.Length > 0)
        {
            problems.Add(rules.Partial ? Severity.Warning : Severity.Error, "curved.outside_surface",
                $"{Text(report.Uncovered.Length, 0)} mm of paths are beyond the edge of the surface that they follow, first at {report.Uncovered.Place}."
                + (rules.Partial ? NotPrinted : ""));
        }
        if (report.Thin.Length > 0)
        {
            problems.Add(Severity.Note, "curved.merged_layers",
                $"Layers thinner than {Text(rules.MinGap, 3)} mm are printed several at once, for example at {report.Thin.Place}.");
        }
    }

    private static string Text(double value, int decimals) => NumberFormatter.Format(value, decimals);
}
