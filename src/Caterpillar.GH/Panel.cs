namespace Caterpillar.GH;

/// <summary>The panels of the tab, in the order of the workflow: Grasshopper sorts them by name.</summary>
internal static class Panel
{
    public const string Setup = "1. Setup";
    public const string Design = "2. Design";
    public const string Path = "3. Path";
    public const string Slice = "4. Slice";
    public const string GCode = "5. G-code";
    public const string Simulate = "6. Simulate";
}
