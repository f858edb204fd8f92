namespace Caterpillar.Curved;

/// <summary>What layers may be: layer 1 is level on the bed; above, each is as far over the one before as the settings allow.</summary>
/// <param name="First">Thickness of the first layer, mm.</param>
/// <param name="Usual">Thickness of the others where they are level, mm.</param>
/// <param name="Least">Least vertical thickness, mm.</param>
/// <param name="Most">Greatest vertical thickness, mm.</param>
/// <param name="Slope">Tangent of the steepest slope.</param>
internal sealed record LayerRules(double First, double Usual, double Least, double Most, double Slope)
{
    // Of a layer.
    private const double Rounding = 1e-6;

    /// <summary>Height of the top of a level layer, mm.</summary>
    public double Height(int layer) => layer == 0 ? 0 : First + (layer - 1) * Usual;

    /// <summary>Height that a number of layers has at most; negative for layers below.</summary>
    public double Upper(int layers) => layers * (layers > 0 ? Most : Least);

    /// <summary>Height that a number of layers has at least; negative for layers below.</summary>
    public double Lower(int layers) => layers * (layers > 0 ? Least : Most);

    /// <summary>The fewest layers that reach a height.</summary>
    public int Fewest(double height) => (int)Math.Ceiling(height / (height > 0 ? Most : Least) - Rounding);

    /// <summary>The most layers that fit into a height.</summary>
    public int MostLayers(double height) => (int)Math.Floor(height / (height > 0 ? Least : Most) + Rounding);

    /// <summary>Rules with a share of the freedom in thickness.</summary>
    public LayerRules With(double share) => this with { Least = Usual - share * (Usual - Least), Most = Usual + share * (Most - Usual) };

    /// <summary>Least thickness across a layer, mm: thinner extrusions are not laid down reliably.</summary>
    public static double LeastGap(PrintSetup setup) => setup.Settings.CurvedMinGap > 0 ? setup.Settings.CurvedMinGap
        : Math.Min(setup.Printer.NozzleDiameter * 0.15, setup.Settings.LayerHeight / 2);

    /// <summary>Greatest thickness across a layer, mm.</summary>
    public static double GreatestGap(PrintSetup setup) => setup.Settings.CurvedMaxGap > 0 ? setup.Settings.CurvedMaxGap
        : Math.Max(setup.Printer.NozzleDiameter * 0.75, setup.Settings.LargerLayerHeight);
}
