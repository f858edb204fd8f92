namespace Caterpillar.GH.Goos;

/// <summary>A profile that was chosen in the menu of a port, where it is a number, or that came along a wire.</summary>
public sealed class ProfileChoice<T> : GH_Integer
    where T : class, IGH_Goo, new()
{
    public ProfileChoice()
    {
    }

    public ProfileChoice(T profile) => Profile = profile;

    /// <summary>The profile. Null if it was not found.</summary>
    public T? Profile { get; private set; }

    public override bool IsValid => Profile?.IsValid == true;

    public override string TypeName => Profile?.TypeName ?? "Profile";

    public override IGH_Goo Duplicate() => new ProfileChoice<T> { Value = Value, Profile = Profile };

    public override object ScriptVariable() => Profile?.ScriptVariable()!;

    public override bool CastFrom(object source)
    {
        if (Wrapped.Bare(source) is ProfileChoice<T> { Profile: not null } other) source = other.Profile!;
        var profile = new T();
        if (!profile.CastFrom(source)) return false;
        Profile = profile;
        return true;
    }

    public override bool CastTo<Q>(ref Q target)
    {
        if (Profile is not Q profile) return Profile is not null && Profile.CastTo(out target);
        target = profile;
        return true;
    }

    public override string ToString() => Profile?.ToString() ?? "No Profile";
}
