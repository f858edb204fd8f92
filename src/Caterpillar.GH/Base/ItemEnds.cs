namespace Caterpillar.GH.Base;

/// <summary>The result of an item is still being computed. A solution follows when it is done.</summary>
internal sealed class StillWorking : Exception;

/// <summary>The item has no result. Its diagnostics explain why.</summary>
internal sealed class NoResult : Exception;
