namespace Caterpillar.Cli;

/// <summary>Options that select moves of a decoded file.</summary>
internal sealed class MoveFilterOptions
{
    private readonly Described<int?> _first = new("--first-layer", "First layer to edit: its number in the file, or counted from 0.", "N");
    private readonly Described<int?> _last = new("--last-layer", "Last layer to edit.", "N");
    private readonly Described<string[]> _roles = new("--role", "Edit only extrusions with this role, such as \"outer wall\" or infill. Repeatable.", "ROLE");
    private readonly Described<string[]> _objects = new("--object", "Edit only this object. Repeatable.", "NAME");
    private readonly Described<int?> _tool = new("--tool", "Edit only moves of this tool.", "N");
    private readonly Described<string?> _box = new("--box", "Edit only moves that end in this box, given by two corners in mm.", "X,Y,Z,X,Y,Z");

    public Option[] All => [_first, _last, _roles, _objects, _tool, _box];

    /// <summary>True if there is a selection.</summary>
    public bool IsGiven(ParseResult arguments) => Array.Exists(All, o => arguments.GetResult(o) is { Implicit: false });

    /// <summary>The selected moves.</summary>
    /// <exception cref="CliException">A role or object is not found, or the box is invalid.</exception>
    public MoveFilter Of(Toolpath toolpath, ParseResult arguments)
    {
        var objects = arguments.GetValue(_objects) is { Length: > 0 } named ? named : null;
        foreach (var name in objects ?? [])
        {
            if (toolpath.Layers.All(l => l.Object != name))
                throw CliException.Usage($"--object: \"{name}\" not found. Objects: "
                    + string.Join(", ", toolpath.Layers.Select(l => $"\"{l.Object}\"").Distinct().Take(20)) + ".");
        }
        if (arguments.GetValue(_first) > arguments.GetValue(_last)) throw CliException.Usage("--first-layer must not be above --last-layer.");
        if (arguments.GetValue(_tool) < 0) throw CliException.Usage("--tool needs 0 or more.");
        return new MoveFilter
        {
            FirstLayer = arguments.GetValue(_first),
            LastLayer = arguments.GetValue(_last),
            Roles = arguments.GetValue(_roles) is { Length: > 0 } roles ? roles.Select(RoleOf).ToArray() : null,
            Objects = objects,
            Tool = arguments.GetValue(_tool),
            Box = arguments.GetValue(_box) is { } box ? BoxOf(box) : null,
        };
    }

    private static Bounds BoxOf(string text)
    {
        var v = Numbers.List(text, "--box");
        if (v.Length != 6) throw CliException.Usage("--box needs two corners: X,Y,Z,X,Y,Z in mm.");
        return Bounds.Empty.Include(new Vec3(v[0], v[1], v[2])).Include(new Vec3(v[3], v[4], v[5]));
    }

    private static Role RoleOf(string name)
        => Enum.TryParse<Role>(name.Replace("-", "").Replace("_", "").Replace(" ", ""), true, out var role) && Enum.IsDefined(role)
            ? role
            : throw CliException.Usage($"Unknown role \"{name}\".{SpellingSuggestion.Hint(name, Shown)} Roles: {string.Join(", ", Shown)}.");

    // As shown in tables and images. Identifiers work as well.
    private static IEnumerable<string> Shown => Enum.GetNames<Role>().Select(Words.Spaced);
}
