using System.Collections;

namespace Caterpillar.Machines;

/// <summary>An immutable list that equals any list with equal items, so that records that contain it compare by value.</summary>
public sealed class ValueList<T> : IReadOnlyList<T>, IEquatable<ValueList<T>>
{
    private readonly T[] _items;

    public ValueList(IEnumerable<T> items) => _items = (items ?? throw new ArgumentNullException(nameof(items))).ToArray();

    public ValueList(params T[] items)
        : this((IEnumerable<T>)items)
    {
    }

    /// <summary>An empty list.</summary>
    public static ValueList<T> Empty { get; } = new();

    /// <summary>Number of items.</summary>
    public int Count => _items.Length;

    /// <summary>An item.</summary>
    public T this[int index] => _items[index];

    public IEnumerator<T> GetEnumerator() => ((IEnumerable<T>)_items).GetEnumerator();

    IEnumerator IEnumerable.GetEnumerator() => _items.GetEnumerator();

    public bool Equals(ValueList<T>? other) => other is not null && (ReferenceEquals(_items, other._items) || _items.SequenceEqual(other._items));

    public override bool Equals(object? obj) => Equals(obj as ValueList<T>);

    public override int GetHashCode()
    {
        var hash = _items.Length;
        foreach (var item in _items) hash = unchecked(hash * 31 + (item?.GetHashCode() ?? 0));
        return hash;
    }
}
