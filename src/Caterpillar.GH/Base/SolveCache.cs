using System;
using System.Collections.Generic;

namespace Caterpillar.GH.Base;

/// <summary>
/// Results of the last solve of one component. A key is a list of parts: immutable inputs compare by reference, settings by value. What the current solve
/// does not request is dropped at its end.
/// </summary>
internal sealed class SolveCache
{
    private Dictionary<Key, object> _last = [];
    private Dictionary<Key, object> _current = [];

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
    public T Get<T>(object?[] parts, Func<T> make)
        where T : class
    {
        var key = new Key(typeof(T), parts);
        if (_current.TryGetValue(key, out var same)) return (T)same;
        var value = _last.TryGetValue(key, out var kept) ? (T)kept : make();
        _current.Add(key, value);
        return value;
    }

    /// <summary>The parts of a key and the type of its value; the hash is computed once.</summary>
    private sealed class Key(Type type, object?[] parts) : IEquatable<Key>
    {
        private readonly int _hash = Hash(parts, type.GetHashCode());
        private readonly Type _type = type;
        private readonly object?[] _parts = parts;

        public bool Equals(Key? other) => other is not null && _hash == other._hash && _type == other._type && Same(_parts, other._parts);

        public override bool Equals(object? obj) => Equals(obj as Key);

        public override int GetHashCode() => _hash;

        private static bool Same(object?[] a, object?[] b)
        {
            if (a.Length != b.Length) return false;
            for (var i = 0; i < a.Length; i++)
            {
                if (ReferenceEquals(a[i], b[i])) continue;
                if (a[i] is object?[] x && b[i] is object?[] y ? !Same(x, y) : !Equals(a[i], b[i])) return false;
            }
            return true;
        }

        private static int Hash(object?[] parts, int seed)
        {
            var hash = seed;
            foreach (var part in parts) hash = unchecked(31 * hash + (part is object?[] list ? Hash(list, list.Length) : part?.GetHashCode() ?? 0));
            return hash;
        }
    }
}
