namespace Caterpillar.GH.Base;

/// <summary>The parts of a key and the type of its value: immutable inputs compare by reference, settings by value. The hash is computed once.</summary>
internal sealed class SolveKey(Type type, object?[] parts) : IEquatable<SolveKey>
{
    private readonly int _hash = Hash(parts, type.GetHashCode());
    private readonly Type _type = type;
    private readonly object?[] _parts = parts;

    public bool Equals(SolveKey? other) => other is not null && _hash == other._hash && _type == other._type && Same(_parts, other._parts);

    public override bool Equals(object? obj) => Equals(obj as SolveKey);

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
