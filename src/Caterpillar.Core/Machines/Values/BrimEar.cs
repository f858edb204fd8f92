namespace Caterpillar.Machines;

/// <summary>A brim ear: a disk of one layer that holds a part on the bed.</summary>
/// <param name="X">Center on the bed, mm.</param>
/// <param name="Y">Center on the bed, mm.</param>
/// <param name="Diameter">mm.</param>
public readonly record struct BrimEar(double X, double Y, double Diameter)
{
    internal static string? Problem(ValueList<BrimEar> ears) => ears.All(e => e.Diameter is > 0 and <= 1000) ? null : "must have diameters above 0, up to 1000";
}
