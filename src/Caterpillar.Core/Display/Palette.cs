namespace Caterpillar.Display;

/// <summary>The colors of roles and scales, the same in images, web pages and on the canvas.</summary>
public static class Palette
{
    private static readonly Rgb[] Scale =
        [new(68, 1, 84), new(59, 82, 139), new(33, 145, 140), new(94, 201, 98), new(253, 231, 37)];

    /// <summary>The color of travel moves.</summary>
    public static Rgb Travel { get; } = new(150, 160, 180);

    /// <summary>The color of a role.</summary>
    public static Rgb Of(Role role) => role switch
    {
        Role.OuterWall => new Rgb(240, 136, 62),
        Role.InnerWall => new Rgb(247, 199, 90),
        Role.OverhangWall => new Rgb(80, 110, 220),
        Role.Infill => new Rgb(190, 70, 60),
        Role.SolidInfill => new Rgb(160, 90, 190),
        Role.TopSurface => new Rgb(225, 80, 100),
        Role.BottomSurface => new Rgb(110, 150, 110),
        Role.Bridge => new Rgb(90, 140, 220),
        Role.GapFill => new Rgb(240, 240, 240),
        Role.Ironing => new Rgb(230, 150, 160),
        Role.Skirt or Role.Brim => new Rgb(60, 150, 120),
        Role.Raft or Role.Support => new Rgb(90, 190, 90),
        Role.SupportInterface => new Rgb(50, 140, 60),
        Role.PrimeTower or Role.Purge => new Rgb(150, 190, 170),
        _ => new Rgb(98, 160, 74),
    };

    /// <summary>A color of the scale from dark violet (0) to yellow (1).</summary>
    public static Rgb At(double value)
    {
        if (!(value > 0)) return Scale[0];
        if (value >= 1) return Scale[Scale.Length - 1];
        var place = value * (Scale.Length - 1);
        var band = (int)place;
        return Rgb.Mix(Scale[band], Scale[band + 1], place - band);
    }
}
