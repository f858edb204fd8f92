namespace Caterpillar.GH.Components;

/// <summary>What a deformation changes.</summary>
public enum DeformedValue
{
    Position,
    Area,
    Speed,
}

/// <summary>The ports of a deformation: what it changes, system, formulas, tolerance, plane.</summary>
internal static class DeformationPorts
{
    // Formula of the new x, y, z, area and speed, by system.
    private static readonly string[] Cartesian = ["X", "Y", "Z", "Area", "Speed"];
    private static readonly string[] Cylindrical = ["R", "Theta", "Z", "Area", "Speed"];

    public static void Declare(InputPorts ports)
    {
        ports.Choices("Changes", "Ch", "What the formulas change: position, area of the cross-section, speed. Several are possible.", DeformedValue.Position);
        ports.Choice("System", "S",
            "Coordinates of the formulas: x, y, z in mm (Cartesian), or r in mm, theta in degrees and z in mm (Cylindrical).", DeformationSystem.Cartesian);
        ports.For("Changes", [DeformedValue.Position], () =>
        {
            ports.For("System", [DeformationSystem.Cartesian], () =>
            {
                Formula(ports, "X", "X", "of the new x. Example: x + 0.2 * z");
                Formula(ports, "Y", "Y", "of the new y. Example: y + sin(3 * x)");
            });
            ports.For("System", [DeformationSystem.Cylindrical], () =>
            {
                Formula(ports, "R", "R", "of the new r. Example: r + 1.05 * z");
                Formula(ports, "Theta", "Th", "of the new theta, in degrees. Example: theta + 3 * z");
            });
            Formula(ports, "Z", "Z", "of the new z. Example: 0.3 * z");
        });
        ports.For("Changes", [DeformedValue.Area], () =>
            Formula(ports, "Area", "A", "of the new cross-section in mm², from the old one (c) and the old coordinates. Example: 0.96 * c"));
        ports.For("Changes", [DeformedValue.Speed], () =>
            Formula(ports, "Speed", "V", "of the new speed in mm/s, from the old one (v) and the old coordinates. Example: 0.5 * v"));
        ports.Number("Tolerance", "To", "Maximum deviation, in mm. Segments are divided to stay within it. 0 = do not divide.", 0.01);
        ports.FormulaPlane();
    }

    public static Request Read(Run run)
    {
        var system = run.Choice<DeformationSystem>(run["System"]);
        var names = system == DeformationSystem.Cartesian ? Cartesian : Cylindrical;
        var changes = run.Choices<DeformedValue>(run["Changes"]) ?? [];
        bool Changes(int formula) => changes.Contains(formula < 3 ? DeformedValue.Position : formula == 3 ? DeformedValue.Area : DeformedValue.Speed);
        var formulas = names.Select((name, i) => Changes(i) ? run.Maybe<string>(run[name]) ?? "" : "").ToArray();
        return new Request(system, formulas, run.NotNegative(run["Tolerance"]), run.FrameOf(run["Plane"]));
    }

    private static void Formula(InputPorts ports, string name, string nick, string text)
        => ports.Text(name, nick, $"Formula {text}. Default: unchanged.", optional: true);

    /// <summary>The values of the ports.</summary>
    public sealed record Request(DeformationSystem System, IReadOnlyList<string> Formulas, double Tolerance, Frame Frame)
    {
        public bool HasSpeed => Formulas[4].Trim().Length > 0;

        public object?[] Key => [System, Tolerance, Frame, .. Formulas];

        public Result<Deformation> Compile() => DeformationText.Compile(Formulas[0], Formulas[1], Formulas[2], Formulas[3], Formulas[4], System);
    }
}
