using System;
using System.Collections.Generic;

namespace Caterpillar.GH.Base;

/// <summary>
/// Results of the last solve of one component. A key is a list of parts: immutable inputs compare by reference, settings by value. What the current solve
/// does not request is dropped at its end.
/// </summary>
internal sealed class SolveCache
{
    private List<(object?[] Key, object Value)> _last = [];
    private List<(object?[] Key, object Value)> _current = [];

    /// <summary>A solve begins.</summary>
    public void Begin() => _current = [];

    /// <summary>A solve ends: only what it used is kept.</summary>
    public void End()
    {
        _last = _current;
        _current = [];
    }

    public void Clear()
    {
        _last = [];
        _current = [];
    }

    /// <summary>The value of a key from this or the last solve, or a new one.</summary>
    public T Get<T>(object?[] key, Func<T> make)
        where T : class
    {
        if (Find<T>(_current, key) is { } same) return same;
        var value = Find<T>(_last, key) ?? make();
        _current.Add((key, value));
        return value;
    }

    private static T? Find<T>(List<(object?[] Key, object Value)> entries, object?[] key)
        where T : class
    {
        foreach (var entry in entries)
        {
            if (entry.Value is T value && Same(entry.Key, key)) return value;
        }
        return null;
    }

    private static bool Same(object?[] a, object?[] b)
    {
        if (a.Length != b.Length) return false;
        for (var i = 0; i < a.Length; i++)
        {
            if (a[i] is object?[] x && b[i] is object?[] y ? !Same(x, y) : !Equals(a[i], b[i])) return false;
        }
        return true;
    }
}
