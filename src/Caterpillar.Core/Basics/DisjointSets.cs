namespace Caterpillar.Basics;

/// <summary>Sets of the numbers from 0 on, at first one for each number, that grow together (union-find).</summary>
internal sealed class DisjointSets(int count)
{
    private int[] _parents = Enumerable.Range(0, count).ToArray();
    private int _count = count;

    /// <summary>Adds the next number.</summary>
    public void Add()
    {
        if (_count == _parents.Length) Array.Resize(ref _parents, Math.Max(16, 2 * _count));
        _parents[_count] = _count++;
    }

    /// <summary>The number that stands for the set of a number: its lowest.</summary>
    public int Of(int number)
    {
        var parents = _parents;
        while (parents[number] != number) number = parents[number] = parents[parents[number]];
        return number;
    }

    /// <summary>Joins the sets of two numbers. False if it is one already.</summary>
    public bool Join(int a, int b)
    {
        var (x, y) = (Of(a), Of(b));
        _parents[Math.Max(x, y)] = Math.Min(x, y);
        return x != y;
    }
}
