namespace Caterpillar.GH.Preview;

/// <summary>Something that is drawn in part if it is too much.</summary>
internal interface IThinned
{
    /// <inheritdoc cref="Thinning.Note"/>
    string? Note { get; }
}

/// <summary>What is drawn of too many lines: whole layers, every n-th of them, or where there are few layers every n-th line.</summary>
internal readonly record struct Thinning(int Every, bool ByLayer)
{
    /// <summary>Maximum number of lines of one preview.</summary>
    public const int MostLines = 1_000_000;

    /// <summary>What the user must know. Null if all is drawn.</summary>
    public string? Note => Every <= 1 ? null
        : $"The preview shows one {(ByLayer ? "layer" : "line")} in {NumberFormatter.Format(Every)}, because there are too many lines.";

    public static Thinning Of(long lines, int layers)
    {
        var every = (int)((lines + MostLines - 1) / MostLines);
        return new Thinning(every, layers >= 2 * every);
    }

    public bool Has(int layer, int index) => Every <= 1 || (ByLayer ? layer : index) % Every == 0;
}
