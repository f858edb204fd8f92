namespace Caterpillar.Cli;

/// <summary>The options that select printer, material and settings; for every verb that needs them.</summary>
internal sealed class SetupOptions
{
    /// <summary>Description of the printer of a G-code file.</summary>
    public const string FromFile = "Default: motion limits from the setup or the slicer's settings in the file, or generic.";

    /// <param name="otherwise">What happens without a printer.</param>
    public SetupOptions(string otherwise = "Default: generic.")
    {
        Printer = new Described<string?>("--printer",
            "Printer profile: name (listed by \"caterpillar printers\") or JSON file. " + otherwise, "NAME|FILE", "-p");
        Printer.CompletionSources.Add(_ => new ProfileLibrary().Names<Printer>());
        Material.CompletionSources.Add(_ => new ProfileLibrary().Names<Material>());
        Settings.CompletionSources.Add(_ => new ProfileLibrary().Names<PrintSettings>());
        Set.CompletionSources.Add(_ => ProfileKeys.All.Select(k => k.Name + "="));
    }

    public Described<string?> Printer { get; }

    public Described<string[]> Material { get; } = new("--material",
        "Material profile: name or JSON file. Repeat for the next tools. Default: set by the printer.", "NAME|FILE", "-m");

    public Described<string?> Settings { get; } = new("--settings",
        "Print settings: name or JSON file, or G-code, a 3MF project or .ini of another slicer, whose whole setup is used. Default: set by the printer.",
        "NAME|FILE", "-s");

    public Described<string[]> Set { get; } = new("--set",
        "Override a key of printer, material or settings, such as layer_height_mm=0.3. Repeatable. \"caterpillar printers --keys\" lists all keys.",
        "KEY=VALUE");

    public Option[] All => [Printer, Material, Settings, Set];

    /// <summary>True if a printer is given.</summary>
    public bool IsGiven(ParseResult arguments) => arguments.GetResult(Printer) is { Implicit: false };

    /// <summary>The given options, for another verb.</summary>
    public IEnumerable<string> Given(ParseResult arguments)
        => All.Select(o => arguments.GetResult(o)).OfType<OptionResult>().Where(given => !given.Implicit).SelectMany(BatchOptions.WordsOf);

    /// <summary>The setup; its problems are printed. Without <c>--printer</c>, the profiles that the input names (<paramref name="own"/>) are used.</summary>
    /// <exception cref="CliException">A profile or key is not found (wrong usage), or a profile is invalid (bad input).</exception>
    public PrintSetup Resolve(ParseResult arguments, Session session, IReadOnlyList<string>? own = null)
    {
        var values = arguments.GetValue(Set) ?? [];
        if (own is null || IsGiven(arguments)) own = [];
        var printer = own.Count > 0 ? own[0] : arguments.GetValue(Printer) ?? "generic";
        var materials = arguments.GetValue(Material) is { Length: > 0 } given ? given : own.Skip(1).Take(1).ToArray();
        var settings = arguments.GetValue(Settings) ?? (own.Count > 2 ? own[2] : null);
        if (settings is not null && ProfileImport.HasSetup(settings))
        {
            var read = ProfileImport.ReadSetup(settings);
            var code = read.Diagnostics.Any(d => d.Code == "profile.not_found") ? ExitCode.Usage : ExitCode.BadInput;
            return Changed(session.ValueOrFail(read, code), arguments, session);
        }
        var plain = session.Profiles.Setup(printer, materials.FirstOrDefault(), settings);
        if (plain.Diagnostics.Any(d => d.Code == "profile.not_found")) session.ValueOrFail(plain, ExitCode.Usage);
        if ((values.Length == 0 && materials.Length < 2) || plain.Value is null) return session.ValueOrFail(plain);
        return session.ValueOrFail(session.Profiles.Setup(printer, materials.FirstOrDefault(), settings, values, [.. materials.Skip(1)]), ExitCode.Usage);
    }

    /// <summary>The setup in a file, with the printer, the material and the keys of the options where they are given.</summary>
    /// <exception cref="CliException">A profile or key is not found (wrong usage), or the setup is invalid (bad input).</exception>
    public PrintSetup Changed(PrintSetup setup, ParseResult arguments, Session session)
    {
        if (IsGiven(arguments)) setup = setup with { Printer = session.ValueOrFail(session.Profiles.Printer(arguments.GetValue(Printer)!), ExitCode.Usage) };
        if (arguments.GetValue(Material) is { Length: > 0 } names)
        {
            var materials = Array.ConvertAll(names, name => session.ValueOrFail(session.Profiles.Material(name), ExitCode.Usage));
            setup = setup with { Material = materials[0], ToolMaterials = new(materials.Skip(1)) };
        }
        setup = session.ValueOrFail(setup.With(arguments.GetValue(Set) ?? []), ExitCode.Usage);
        var found = setup.Check();
        return session.ValueOrFail(new Result<PrintSetup>(found.Any(d => d.Severity == Severity.Error) ? null : setup, found));
    }
}
