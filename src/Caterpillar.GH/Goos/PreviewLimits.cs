namespace Caterpillar.GH.Goos;

/// <summary>Above these sizes goo draws nothing by itself.</summary>
internal static class PreviewLimits
{
    public const int Points = 500_000;
    public const int Moves = 200_000;
}
