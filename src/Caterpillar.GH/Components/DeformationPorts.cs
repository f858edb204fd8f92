using Caterpillar.GH.Base;
using Caterpillar.Shaping;

namespace Caterpillar.GH.Components;

/// <summary>The ports of a deformation: system, five formulas, tolerance.</summary>
internal static class DeformationPorts
{
    public const int Count = 7;

    public static void Declare(InputPorts ports)
    {
        ports.Choice("System", "S",
            "Coordinates of the formulas: x, y, z in mm (Cartesian), or r in mm, theta in degrees and z in mm (Cylindrical).", DeformationSystem.Cartesian);
        ports.Text("X", "X", "Formula of the new x, or of the new r if cylindrical. Example: r + 1.05 * z. Default: unchanged.", optional: true);
        ports.Text("Y", "Y",
            "Formula of the new y, or of the new theta in degrees if cylindrical. Example: theta + 3 * z. Default: unchanged.", optional: true);
        ports.Text("Z", "Z", "Formula of the new z. Example: 0.3 * z. Default: unchanged.", optional: true);
        ports.Text("Area", "A",
            "Formula of the new cross-section in mm², from the old one (c) and the old coordinates. Example: 0.96 * c. Default: unchanged.", optional: true);
        ports.Text("Speed", "V",
            "Formula of the new speed in mm/s, from the old one (v) and the old coordinates. Example: 0.5 * v. Default: unchanged.", optional: true);
        ports.Number("Tolerance", "To", "Maximum deviation, in mm. Segments are divided to stay within it. 0 = do not divide.", 0.01);
    }

    public static Request Read(Run run, int first)
    {
        return new Request(run.Choice<DeformationSystem>(first), Enumerable.Range(first + 1, 5).Select(i => run.Maybe<string>(i) ?? "").ToArray(),
            run.NotNegative(first + 6));
    }

    /// <summary>The values of the ports.</summary>
    public sealed record Request(DeformationSystem System, IReadOnlyList<string> Formulas, double Tolerance)
    {
        public bool HasSpeed => Formulas[4].Trim().Length > 0;

        public object?[] Key => [System, Tolerance, .. Formulas];

        public Result<Deformation> Compile() => DeformationText.Compile(Formulas[0], Formulas[1], Formulas[2], Formulas[3], Formulas[4], System);
    }
}
