namespace Caterpillar.GH.Tests.Examples.Arranging;

/// <summary>Random numbers that are the same in every run.</summary>
internal sealed class Chance
{
    private uint _state = 2463534242;

    /// <summary>A number from zero to below the count.</summary>
    public int Next(int count)
    {
        _state ^= _state << 13;
        _state ^= _state >> 17;
        _state ^= _state << 5;
        return (int)(_state % (uint)count);
    }
}
