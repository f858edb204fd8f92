namespace Caterpillar.Cli;

/// <summary>Options shared by several verbs.</summary>
internal static class CommonOptions
{
    /// <summary>Description of a G-code argument.</summary>
    public const string GCodeInput = "G-code: text, .bgcode or gzip; - = standard input.";

    /// <summary>Description of a mesh argument.</summary>
    public const string MeshInput = "Meshes: STL, OBJ, PLY or 3MF, also gzip; - = standard input.";

    /// <summary>Default of output files.</summary>
    public const string DefaultOutput = "Default: name of the input, in the current folder.";

    public static Described<double?> FilamentDiameter() => new("--filament-diameter", "Filament diameter, if the file does not state it.", "MM");

    public static Described<string> Plan(string policy)
    {
        var option = new Described<string>("--plan", "Moves to write. drawn: only the drawing. printer: also retraction and Z-hop.", "drawn|printer")
        {
            DefaultValueFactory = _ => policy,
        };
        option.AcceptOnlyFromAmong("drawn", "printer");
        return option;
    }

    public static Described<int> Threads()
    {
        var option = new Described<int>("--threads", "Maximum number of threads, without effect on the result. Default: all cores.", "N");
        option.Validators.Add(result =>
        {
            if (result.Tokens.Count == 1 && int.TryParse(result.Tokens[0].Value, out var threads) && threads < 1) result.AddError("--threads needs 1 or more.");
        });
        return option;
    }

    /// <summary>How the files of a verb are decoded.</summary>
    /// <exception cref="CliException">The flavor is unknown.</exception>
    public static DecodeOptions Decoding(string? flavor, double? diameter, int threads, Session session)
        => new() { Flavor = FlavorOf(flavor), FilamentDiameter = diameter, Threads = threads, Memory = session.Memory };

    public static Described<string?> Flavor() => Flavor("--flavor", "G-code flavor of the file. Default: detected.");

    /// <summary>An option for the name of a flavor, which shells complete.</summary>
    public static Described<string?> Flavor(string name, string description)
    {
        var option = new Described<string?>(name, description, "FLAVOR");
        option.CompletionSources.Add(_ => FlavorTable.All.Select(d => d.Name));
        return option;
    }

    /// <exception cref="CliException">The flavor is unknown.</exception>
    public static FlavorRules? FlavorOf(string? name)
    {
        if (name is null) return null;
        return FlavorTable.Find(name) ?? throw new CliException(
            ExitCode.Usage, $"Unknown flavor \"{name}\"." + SpellingSuggestion.Hint(name, FlavorTable.All.Select(d => d.Name))
                + $" Flavors: {string.Join(", ", FlavorTable.All.Select(d => d.Name))}.");
    }
}
