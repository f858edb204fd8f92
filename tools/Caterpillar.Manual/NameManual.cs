using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Machines;

namespace Caterpillar.Manual;

/// <summary>The page of the manual on names in other slicers (<c>docs/names.md</c>), made from <see cref="SlicerName"/>.</summary>
internal static class NameManual
{
    /// <summary>The page as Markdown.</summary>
    public static string Write()
    {
        var text = new StringBuilder();
        text.Append(
            """
            # Names in other slicers

            <!-- Made from the table of names: CATERPILLAR_RENEW=1 ./test.sh rewrites it. -->

            You know a setting from PrusaSlicer, OrcaSlicer or Cura, and look for its key. Keys end in their unit. You can also just try your name,
            with `--set`, in a profile or at a port: the error tells you the key and the converted value. For `--set fill_density=15%` it is
            "fill_density (PrusaSlicer) is infill_density_percent here: infill_density_percent=15."

            A name after ≈ has the same purpose, but another unit or other values. [Profiles](profiles.md) describes all keys and their ranges.

            """);
        Table(text, "Printer", ProfileKeys.Of<Printer>());
        Table(text, "Material", ProfileKeys.Of<Material>());
        Table(text, "Settings", ProfileKeys.Of<PrintSettings>());
        return text.ToString();
    }

    private static void Table(StringBuilder text, string title, IEnumerable<ProfileKey> keys)
    {
        string[] slicers = ["PrusaSlicer", "OrcaSlicer", "Cura"];
        text.Append("\n## ").Append(title).Append("\n\n| key | ").Append(string.Join(" | ", slicers)).Append(" |\n|---|---|---|---|\n");
        foreach (var key in keys)
        {
            var names = SlicerName.All.Where(n => n.Key == key).ToArray();
            if (names.Length == 0) continue;
            text.Append("| `").Append(key.Name).Append("` |");
            foreach (var slicer in slicers) text.Append(' ').Append(string.Join(", ", names.Where(n => n.Slicer == slicer).Select(Shown))).Append(" |");
            text.Append('\n');
        }
    }

    private static string Shown(SlicerName name)
        => (name.Conversion == "?" && name.Name != name.Key.Name ? "≈ `" : "`") + name.Name + "`" + Conversion(name.Conversion);

    private static string Conversion(string text) => text switch
    {
        "90-" => " (90 − value)",
        var factor when factor.StartsWith("*", StringComparison.Ordinal) && factor.IndexOf('=', 0) < 0 => " (× " + factor.Substring(1).Replace('-', '−') + ")",
        var divisor when divisor.StartsWith("/", StringComparison.Ordinal) => " (÷ " + divisor.Substring(1) + ")",
        _ => "",
    };
}
