namespace Caterpillar.GH.Base;

/// <summary>The result of an item is still worked on: a solution follows when it is there.</summary>
internal sealed class StillWorking : Exception;

/// <summary>The item has no result, which its diagnostics explain.</summary>
internal sealed class NoResult : Exception;
