using Caterpillar.Basics;

namespace Caterpillar.Curved;

/// <summary>Tells what was noticed while paths were brought back.</summary>
internal static class LiftFindings
{
    public static void Add(LiftReport report, LiftRules rules, DiagnosticList problems)
    {
        if (report.Steep.Length > 0)
        {
            problems.Add(rules.Partial ? Severity.Warning : Severity.Error, "curved.too_steep",
                $"Layers are steeper than the {Text(rules.MaxSlope, 1)} degrees that the head allows, up to {Text(report.Steep.Worst, 1)} degrees at "
                + $"{report.Steep.Place}, over {Text(report.Steep.Length, 0)} mm of paths" + (rules.Partial ? ", which are not printed." : "."));
        }
        if (report.Below.Length > 0)
        {
            problems.Add(Severity.Warning, "curved.below_surface",
                $"Paths of {Text(report.Below.Length, 0)} mm lie below the surface that is printed on, first by {Text(report.Below.Worst, 3)} mm at "
                + $"{report.Below.Place}; they are not printed.");
        }
        if (report.Uncovered.Length > 0)
        {
            problems.Add(rules.Partial ? Severity.Warning : Severity.Error, "curved.outside_surface",
                $"Paths of {Text(report.Uncovered.Length, 0)} mm lie beyond the surface that they follow, first at {report.Uncovered.Place}"
                + (rules.Partial ? "; they are not printed." : "."));
        }
        if (report.Thin.Length > 0)
        {
            problems.Add(Severity.Note, "curved.merged_layers",
                $"Where layers are thinner than {Text(rules.MinGap, 3)} mm several are printed at once, for example at {report.Thin.Place}.");
        }
    }

    private static string Text(double value, int decimals) => NumberFormatter.Format(value, decimals);
}
