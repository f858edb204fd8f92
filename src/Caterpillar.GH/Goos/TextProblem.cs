namespace Caterpillar.GH.Goos;

/// <summary>Goo that is read from text, such as the name of a profile.</summary>
internal interface IReadsText
{
    /// <summary>The reason why text could not be read. Null if it was.</summary>
    string? Problem { get; }
}

/// <summary>Reports why text could not be read. Grasshopper's own message names only the types.</summary>
internal static class TextProblem
{
    public static string? Of<T>(Result<T> read)
        where T : class
        => read.Value is null ? string.Join("\n", read.Diagnostics) : null;

    /// <summary>Goo from text, without a value if the text can't be read. Null for other data.</summary>
    public static T? Read<T>(GH_Param<T> param, T goo, object data)
        where T : class, IGH_Goo
    {
        if (goo is not IReadsText reader || Wrapped.Text(data) is null) return null;
        if (!goo.CastFrom(data)) param.AddRuntimeMessage(GH_RuntimeMessageLevel.Error, $"{param.Name}: {reader.Problem}");
        return goo;
    }

    /// <summary>Replaces goo that was not read with null.</summary>
    public static void Clean<T>(GH_Structure<T> data, Func<T, bool> isBad)
        where T : class, IGH_Goo
    {
        foreach (var path in data.Paths)
        {
            var branch = data.EnsurePath(path);
            for (var i = 0; i < branch.Count; i++)
            {
                if (branch[i] is { } goo && isBad(goo)) branch[i] = null!;
            }
        }
    }
}
