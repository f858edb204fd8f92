using System.Collections;

namespace Caterpillar.GH.Base;

/// <summary>The parts of a key and the type of its value: immutable inputs compare by reference, settings by value. The hash is computed once.</summary>
internal sealed class SolveKey(Type type, object?[] parts) : IEquatable<SolveKey>
{
    private readonly int _hash = type.GetHashCode() ^ StructuralComparisons.StructuralEqualityComparer.GetHashCode(parts);
    private readonly Type _type = type;
    private readonly object?[] _parts = parts;

    public bool Equals(SolveKey? other)
        => other is not null && _hash == other._hash && _type == other._type && StructuralComparisons.StructuralEqualityComparer.Equals(_parts, other._parts);

    public override bool Equals(object? obj) => Equals(obj as SolveKey);

    public override int GetHashCode() => _hash;
}
