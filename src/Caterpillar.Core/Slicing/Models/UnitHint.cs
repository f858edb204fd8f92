namespace Caterpillar.Slicing;

/// <summary>What models that are far too small or too large in mm would measure in other units.</summary>
internal static class UnitHint
{
    // mm: below it, a part is hardly printable; above it, no printer is large enough.
    private const double Small = 3, Large = 10_000;

    /// <summary>A warning <c>models.unit</c> about a size in mm, or null if it is usual.</summary>
    public static Diagnostic? Of(Vec3 size)
    {
        var longest = Math.Max(size.X, Math.Max(size.Y, size.Z));
        if (!(longest > 0) || longest is >= Small and <= Large) return null;
        var others = longest < Small
            ? $"In meters it would be {Times(size, 1000)} mm, in inches {Times(size, Units.MmPerInch)} mm, in centimeters {Times(size, 10)} mm."
            : $"In micrometers it would be {Times(size, 0.001)} mm.";
        return new Diagnostic(Severity.Warning, "models.unit",
            $"Model is {Times(size, 1)} mm. {others} Set the unit where the file is read (--unit, or Unit of Read Model), or scale the model.");
    }

    // Two decimals, or more for what is smaller.
    private static string Times(Vec3 size, double unit) => string.Join(" × ", new[] { size.X, size.Y, size.Z }.Select(s => s * unit)
        .Select(mm => NumberFormatter.Format(mm, mm < 0.1 ? 5 : 2)));
}
