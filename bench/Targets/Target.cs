using System;
using System.Globalization;

namespace Caterpillar.Bench;

/// <summary>A job with the time (or amount) it may take (NaN where nothing is demanded, or other programs say), and what it took. Smaller is better.</summary>
internal sealed record Target(string Job, string Unit, double Allowed, double Measured, string Remark = "")
{
    public bool HasTarget => !double.IsNaN(Allowed);

    public bool IsMet => Measured <= Allowed;

    /// <summary>How much of what is allowed was taken.</summary>
    public double Share => Allowed > 0 ? Measured / Allowed : Measured > 0 ? 10 : 0;

    public string Text(double value)
        => value.ToString(value >= 100 ? "0" : value >= 10 ? "0.#" : value >= 1 ? "0.##" : "0.###", CultureInfo.InvariantCulture) + " " + Unit;

    public string ToRow() => $"| {Job} | {(HasTarget ? Text(Allowed) : "–")} | {Text(Measured)} | {Verdict} | {Remark} |";

    private string Verdict => !HasTarget ? "" : IsMet ? "met" : $"**{Math.Round(Share, 1).ToString(CultureInfo.InvariantCulture)} ×**";

    /// <summary>Reads a row again; null for other lines.</summary>
    public static Target? OfRow(string row)
    {
        var cells = row.Split('|');
        if (cells.Length < 5 || Number(cells[3], out var unit) is not { } measured) return null;
        return new Target(cells[1].Trim(), unit, Number(cells[2], out _) ?? double.NaN, measured);
    }

    private static double? Number(string cell, out string unit)
    {
        var words = cell.Trim().Split(' ');
        unit = words.Length == 2 ? words[1] : "";
        return words.Length == 2 && double.TryParse(words[0], NumberStyles.Float, CultureInfo.InvariantCulture, out var value) ? value : null;
    }
}
