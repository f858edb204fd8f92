namespace Caterpillar.GH.Base;

/// <summary>
/// Results of the last solve of one component. A complete solve drops results that it did not request. While work goes on, the results of the last
/// complete solve are kept as well.
/// </summary>
internal sealed class SolveCache
{
    private Dictionary<SolveKey, object> _complete = [];
    private Dictionary<SolveKey, object> _last = [];
    private Dictionary<SolveKey, object> _current = [];

    /// <summary>A solve begins. If the previous one did not end, as after an abort, its results are kept.</summary>
    public void Begin()
    {
        if (_current.Count > 0) End();
    }

    /// <summary>A solve ends. It is not complete while long work for it goes on.</summary>
    public void End(bool complete = true)
    {
        _last = _current;
        if (complete) _complete = _current;
        _current = [];
    }

    public void Clear()
    {
        _complete = [];
        _last = [];
        _current = [];
    }

    /// <summary>Makes a value from the last one of its key, which may be kept.</summary>
    public T Renew<T>(object?[] parts, Func<T?, SolveKey, T> renew)
        where T : class
    {
        var key = new SolveKey(typeof(T), parts);
        var isKept = _current.TryGetValue(key, out var last) || _last.TryGetValue(key, out last) || _complete.TryGetValue(key, out last);
        var value = renew(isKept ? (T)last! : null, key);
        _current[key] = value;
        return value;
    }

    /// <summary>The value of a key from this or an earlier solve, or a new one.</summary>
    public T Get<T>(object?[] parts, Func<SolveKey, T> make)
        where T : class
        => Renew<T>(parts, (last, key) => last ?? make(key));
}
