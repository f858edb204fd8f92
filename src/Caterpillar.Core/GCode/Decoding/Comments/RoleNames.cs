using Caterpillar.Files;

namespace Caterpillar.GCode;

/// <summary>Names of roles in the comments of slicers.</summary>
internal static class RoleNames
{
    // The first name is that of written files.
    private static readonly (Role Role, string[] Names)[] Table = [.. EmbeddedText.Rows("comments/RoleNames.tsv").Skip(1)
        .Select(r => ((Role)Enum.Parse(typeof(Role), r[0]), r[1].Split([", "], StringSplitOptions.None)))];

    private static readonly Dictionary<string, Role> Roles =
        Table.SelectMany(row => row.Names.Select(name => (name, row.Role))).ToDictionary(n => n.name, n => n.Role, StringComparer.Ordinal);

    private static readonly Dictionary<Role, string> Written =
        Table.ToDictionary(r => r.Role, r => char.ToUpperInvariant(r.Names[0][0]) + r.Names[0].Substring(1));

    /// <summary>The role with this name (case does not matter), or null.</summary>
    public static Role? Find(string name) => Roles.TryGetValue(name.Trim().ToLowerInvariant(), out var role) ? role : null;

    /// <summary>The name in written files. PrusaSlicer's viewer reads it, too.</summary>
    public static string Of(Role role) => Written[role];
}
