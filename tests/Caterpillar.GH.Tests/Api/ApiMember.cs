using System;
using System.Collections.Generic;

namespace Caterpillar.GH.Tests.Api;

/// <summary>A member as the lists of the public API give it.</summary>
/// <param name="Name">Its name; accessors under their property, constructors as <c>#ctor</c>.</param>
/// <param name="Parameters">Canonical types of its parameters; null if only their number is known.</param>
/// <param name="Count">Number of parameters; by reference ones may be missing where the types are unknown.</param>
internal sealed record ApiMember(string Name, string[]? Parameters, int Count)
{
    public bool IsStatic { get; init; }

    public bool IsProtected { get; init; }

    public bool IsAbstract { get; init; }

    public bool IsVirtual { get; init; }

    public bool CanRead { get; init; } = true;

    public bool CanWrite { get; init; } = true;

    public string? Returns { get; init; }

    /// <summary>Value of an enum member or a constant, as text.</summary>
    public string? Value { get; init; }
}

/// <summary>A type as the lists give it.</summary>
internal sealed class ApiType
{
    public bool IsInterface { get; init; }

    public bool IsAbstract { get; init; }

    public bool IsSealed { get; init; }

    /// <summary>Canonical names of its base and interfaces.</summary>
    public List<string> Bases { get; } = [];

    public List<ApiMember> Members { get; } = [];
}

/// <summary>The public API of one or several assemblies.</summary>
internal sealed class ApiList
{
    public Dictionary<string, ApiType> Types { get; } = new(StringComparer.Ordinal);

    public ApiType Type(string name)
    {
        if (!Types.TryGetValue(name, out var type)) Types.Add(name, type = new ApiType());
        return type;
    }
}
