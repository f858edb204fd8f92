using System;

namespace Caterpillar.GH.Base;

/// <summary>The result of an item is still worked on: a solution follows when it is there.</summary>
internal sealed class StillWorking : Exception
{
    public StillWorking()
    {
    }

    public StillWorking(string message)
        : base(message)
    {
    }

    public StillWorking(string message, Exception inner)
        : base(message, inner)
    {
    }
}
