using System.Collections;

namespace Caterpillar.GH.Goos;

/// <summary>A field of layers that is made for given models. Recipes from the same parts are equal, so that nothing is sliced twice.</summary>
public sealed class FieldRecipe : IEquatable<FieldRecipe>
{
    private readonly string _text;
    private readonly object?[] _parts;
    private readonly Func<IReadOnlyList<NamedMesh>, PrintSetup, Func<int, Vec3?>, Result<LayerField>> _make;

    internal FieldRecipe(string text, object?[] parts, Func<IReadOnlyList<NamedMesh>, PrintSetup, Func<int, Vec3?>, Result<LayerField>> make)
    {
        _text = text;
        _parts = [text, .. parts];
        _make = make;
    }

    internal FieldRecipe(string text, object?[] parts, LayerField field)
        : this(text, parts, (_, _, _) => new Result<LayerField>(field, []))
    {
        Made = field;
    }

    /// <summary>The field, if it depends on no models.</summary>
    internal LayerField? Made { get; }

    /// <summary>The field for models in their print position, mm.</summary>
    /// <param name="models">The models.</param>
    /// <param name="setup">Its head limits overhangs.</param>
    /// <param name="vertexAt">Place of a vertex of the first model by its number in Rhino's mesh, mm. Null if there is none.</param>
    internal Result<LayerField> For(IReadOnlyList<NamedMesh> models, PrintSetup setup, Func<int, Vec3?> vertexAt) => _make(models, setup, vertexAt);

    public bool Equals(FieldRecipe? other) => other is not null && StructuralComparisons.StructuralEqualityComparer.Equals(_parts, other._parts);

    public override bool Equals(object? obj) => Equals(obj as FieldRecipe);

    public override int GetHashCode() => StringComparer.Ordinal.GetHashCode(_text);

    public override string ToString() => _text;
}
