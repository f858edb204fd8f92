namespace Caterpillar.GCode;

/// <summary>Names of roles in the comments of slicers, from <c>RoleNames.tsv</c>.</summary>
internal static class RoleNames
{
    private static readonly (Role Role, string[] Names)[] Table =
        [.. EmbeddedText.Rows("comments/RoleNames.tsv").Select(r => ((Role)Enum.Parse(typeof(Role), r[0]), r.Skip(1).ToArray()))];

    private static readonly Dictionary<string, Role> Roles =
        Table.SelectMany(row => row.Names.Select(name => (name, row.Role))).ToDictionary(n => n.name, n => n.Role, StringComparer.Ordinal);

    private static readonly Dictionary<Role, string> Written =
        Table.ToDictionary(r => r.Role, r => char.ToUpperInvariant(r.Names[0][0]) + r.Names[0].Substring(1));

    /// <summary>The role with this name (case does not matter), or null.</summary>
    public static Role? Find(string name) => Roles.TryGetValue(name.Trim().ToLowerInvariant(), out var role) ? role : null;

    /// <summary>The name in written files. PrusaSlicer's viewer reads it, too.</summary>
    public static string Of(Role role) => Written[role];
}
