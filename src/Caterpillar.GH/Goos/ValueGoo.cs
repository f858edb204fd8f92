namespace Caterpillar.GH.Goos;

/// <summary>An immutable value of the library on a wire. Copies share the value.</summary>
public abstract class ValueGoo<T> : GH_Goo<T>
    where T : class
{
    protected ValueGoo(T? value = null) => Value = value!;

    public override bool IsValid => Value is not null;

    public override string IsValidWhyNot => IsValid ? "" : $"No {TypeName}.";

    public override IGH_Goo Duplicate() => (IGH_Goo)MemberwiseClone();

    /// <summary>The value for script components.</summary>
    public override object? ScriptVariable() => Value;

    public override bool CastFrom(object source)
    {
        var bare = Wrapped.Bare(source);
        if (bare is not T && bare is ValueGoo<T> goo) bare = goo.Value;
        if (bare is not T value) return false;
        Value = value;
        return true;
    }

    public override bool CastTo<Q>(ref Q target)
    {
        if (Value is not Q value) return false;
        target = value;
        return true;
    }

    public override string ToString() => Value is null ? $"No {TypeName}" : Describe(Value);

    /// <summary>A summary of the value, for a Panel.</summary>
    protected abstract string Describe(T value);
}
