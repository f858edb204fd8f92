using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;
using Caterpillar.Traces;

namespace Caterpillar.Examples;

/// <summary>
/// The examples of Kanada's papers (2014 to 2016) as deformed and modulated traces. Values that are not in the papers are marked as chosen.
/// </summary>
public static class KanadaParts
{
    /// <summary>Area of an extrusion 0.5 mm thick, mm².</summary>
    private const double Area = 0.196;

    private const double Tolerance = 0.01;

    public static IReadOnlyList<(string Name, Func<IReadOnlyList<PrintPath>> Make)> All { get; } =
    [
        ("cup", () => Cup().ToPaths()),
        ("cup_to_plate", CupToPlate),
        ("sphere", Sphere),
        ("heart", () => Heart(0)),
        ("heart_twisted", () => Heart(90)),
        ("plate_three_cycles", () => WavyPlate(3)),
        ("plate_four_cycles", () => WavyPlate(4)),
        ("lamp_shade", LampShade),
        ("lettered_bowl", LetteredBowl),
        ("globe", Globe),
    ];

    // Chosen: radius 15, height 30, a spiral for the bottom.
    private static Trace Cup()
    {
        var cup = new Trace(Area).SetSpeed(25).Spiral(new Vec3(0, 0, 0.3), 15, 0.5);
        return cup.Helix(new Vec3(0, 0, 0.3), 15, 30, 0.4, ramp: new FlowRamp(0.2, start: false));
    }

    /// <summary>fd = (r + 1.05 z, θ, 0.3 z), fc = 0.96 c (2016, figure 6).</summary>
    private static IReadOnlyList<PrintPath> CupToPlate()
        => Shape(Cup().ToPaths(), Deformation.Cylindrical(p => new Vec3(p.X + 1.05 * p.Z, p.Y, 0.3 * p.Z), (c, _) => 0.96 * c));

    /// <summary>The program of figure 9 (2016): a helix of radius 25 becomes a sphere, then is raised and tuned.</summary>
    private static IReadOnlyList<PrintPath> Sphere() => Shape(new Trace(Area).SetSpeed(36).Helix(Vec3.Zero, 25, Math.PI / 2 * 25, 0.2).ToPaths(), SphereOf(25)
        .Then(Deformation.Cylindrical(p => p + new Vec3(0, 0, 0.4), (c, _) => 2 * c, (v, p) => 0.6 * (Math.Pow(p.X / 25, 1.5) + 0.2) * v)));

    /// <summary>
    /// x' = x + b z √(|y|/r) with b z from 0 to 12 mm (2016, section 4.1), optionally twisted over the height. Small waves make the surface
    /// glitter.
    /// </summary>
    private static IReadOnlyList<PrintPath> Heart(double twist)
    {
        const double Radius = 25, Height = 30;
        var heart = Deformation.Cartesian(p => new Vec3(p.X + 0.6 * p.Z * Math.Sqrt(Math.Abs(p.Y) / Radius), p.Y, p.Z))
            .Then(Deformation.Cylindrical(p => new Vec3(p.X, p.Y + twist * p.Z / Height, p.Z + 0.3)));
        return Shape(new Trace(Area).SetSpeed(25).Spiral(Vec3.Zero, Radius, 0.5).Helix(Vec3.Zero, Radius, Height, 0.4).ToPaths(), heart);
    }

    /// <summary>A plate with a number of waves around its wall (2016, figure 10). Chosen: an amplitude of a fifth of the height at the rim.</summary>
    private static IReadOnlyList<PrintPath> WavyPlate(int cycles)
        => Shape(Cup().ToPaths(), Deformation.Cylindrical(
            p => new Vec3(p.X + 1.05 * p.Z, p.Y, 0.3 + (0.35 + 0.12 * Angle.Sin(cycles * p.Y)) * (p.Z - 0.3)), (c, _) => 0.96 * c));

    /// <summary>A partial sphere with waves around and along its axis (2016, figure 13, left), open at the top for the lamp.</summary>
    private static IReadOnlyList<PrintPath> LampShade()
    {
        const double Radius = 40;
        var waves = Deformation.Cylindrical(p => new Vec3(p.X * (1 + 0.06 * Angle.Sin(12 * p.Y + 4 * p.Z)), p.Y, p.Z + 0.4));
        // From 15 % to 85 % of the meridian.
        var helix = new Trace(Area).SetSpeed(30).Helix(new Vec3(0, 0, 0.15 * Math.PI * Radius / 2), Radius, 0.7 * Math.PI * Radius / 2, 0.2);
        var bottom = Radius - Radius * Angle.Cos(180 * 0.15);
        return Shape(helix.ToPaths(), SphereOf(Radius, 1.05).Then(Deformation.Cartesian(p => p - new Vec3(0, 0, bottom))).Then(waves));
    }

    /// <summary>Letters around a bowl by print speed, 1 to 0.65 (2016, figure 12, right). Printed upside down.</summary>
    private static IReadOnlyList<PrintPath> LetteredBowl()
    {
        const double Radius = 30;
        var helix = new Trace(Area).SetSpeed(30).Helix(new Vec3(0, 0, Math.PI / 4 * Radius), Radius, Math.PI / 4 * Radius * 0.97, 0.2, 300);
        var bowl = Shape(helix.ToPaths(), SphereOf(Radius, 1.05).Then(Deformation.Cartesian(p => p - new Vec3(0, 0, Radius - 0.4))));
        var letters = Lettering.Draw("CATERPILLAR ");
        var field = Fields.Image(letters, ImageMappings.Cylinder(6, 16, repeats: 2));
        return Modulated(bowl, new Modulation(ModulationMode.Speed, field, 1, 0.65) { Resolution = 0.4 });
    }

    /// <summary>
    /// A globe: 150 turns of 300 strings, one for each dot of a 300 × 150 map (2016, section 3.5). Land is printed more slowly and so thicker, 1 to 0.65. Short
    /// strings near the poles are merged.
    /// </summary>
    private static IReadOnlyList<PrintPath> Globe()
    {
        const double Radius = 30, Height = Math.PI / 2 * Radius;
        var sphere = Shape(new Trace(Area).SetSpeed(30).Helix(Vec3.Zero, Radius, Height, Height / 150, 300).ToPaths(),
            SphereOf(Radius, 1.05).Then(Deformation.Cartesian(p => p + new Vec3(0, 0, 0.4))), 0);
        var map = Fields.Image(WorldMap.Draw(300, 150), ImageMappings.Globe(new Vec3(0, 0, Radius + 0.4), from: -180));
        var globe = Modulated(sphere, new Modulation(ModulationMode.Speed, map, 1, 0.65));
        return Merged(globe, 0.3);
    }

    // fd = (R sin(πz/H), θ, r − R cos(πz/H)), H = π/2·R; the meridian is twice the height, so the pitch doubles.
    private static Deformation SphereOf(double radius, double area = 0.525)
    {
        var height = Math.PI / 2 * radius;
        return Deformation.Cylindrical(
            p => new Vec3(Math.Max(0, radius * Angle.Sin(180 * p.Z / height)), p.Y, p.X - radius * Angle.Cos(180 * p.Z / height)), (c, _) => area * c);
    }

    private static IReadOnlyList<PrintPath> Shape(IReadOnlyList<PrintPath> paths, Deformation deformation, double tolerance = Tolerance)
        => deformation.Apply(paths, tolerance).Value ?? throw new InvalidOperationException("The deformation failed.");

    private static IReadOnlyList<PrintPath> Modulated(IReadOnlyList<PrintPath> paths, Modulation modulation)
        => modulation.Apply(paths).Value ?? throw new InvalidOperationException("The modulation failed.");

    private static IReadOnlyList<PrintPath> Merged(IReadOnlyList<PrintPath> paths, double minimum)
        => paths.Select(p => PathMerging.JoinShort(p, minimum)).ToArray();
}
