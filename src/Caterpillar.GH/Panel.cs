namespace Caterpillar.GH;

/// <summary>The panels of the tab, in the order of the workflow.</summary>
internal static class Panel
{
    public const string Setup = "Setup";
    public const string Design = "Design";
    public const string Path = "Path";
    public const string Slice = "Slice";
    public const string GCode = "G-code";
    public const string Simulate = "Simulate";
}
