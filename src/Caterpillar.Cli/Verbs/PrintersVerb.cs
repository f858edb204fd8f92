namespace Caterpillar.Cli;

/// <summary>Lists profiles, shows one as JSON with all its keys, or creates one from a header and a footer.</summary>
internal sealed class PrintersVerb : Verb
{
    private readonly Argument<string?> _name = new("NAME")
    {
        Description = "Printer, material or settings to show as JSON. If a name is ambiguous: material/NAME or settings/NAME.",
        HelpName = "NAME",
        Arity = ArgumentArity.ZeroOrOne,
    };

    private readonly Described<bool> _keys = new("--keys", "List the keys of profiles with their ranges and descriptions.");

    private readonly Described<string[]> _import = new("--import",
        "Create profiles from settings of PrusaSlicer (.ini, bundles, too), OrcaSlicer or Bambu Studio (.json), or those in their prints and 3MF projects; "
            + "or a printer from two files with start and end G-code, such as those of ExtruderTurtle. As FOOTER: - = none. With NAME: that printer only.",
        "FILE [FOOTER]") { Arity = new ArgumentArity(1, 2), AllowMultipleArgumentsPerToken = true };

    private readonly Described<string?> _like = new("--base", "With --import: similar printer for values that the files do not state.", "NAME|FILE");

    private readonly Described<string> _output = new("--output",
        "Output file; - = standard output. With --import also a folder. Materials and settings get folders of their own in it.",
        "FILE.json|FOLDER", "-o") { DefaultValueFactory = _ => "-" };

    public PrintersVerb()
        : base("printers", "List, show or create profiles of printers, materials and settings.", ["JSON", "a table"])
    {
        _name.CompletionSources.Add(_ => new ProfileLibrary().Names<Printer>());
        Arguments.Add(_name);
        Add([_keys, _import, _like, _output]);
    }

    public override int Run(ParseResult arguments, Session session)
    {
        var name = arguments.GetValue(_name);
        var output = arguments.GetValue(_output)!;
        if (arguments.GetValue(_import) is { Length: > 0 } files)
            PrinterImport.Run(files, name, arguments.GetValue(_like), output, session);
        else if (arguments.GetValue(_like) is not null) throw CliException.Usage("--base needs --import.");
        else if (arguments.GetValue(_keys)) session.WriteText(output, WriteKeys);
        else if (name is not null) Show(name, output, session);
        else return List(output, session);
        return ExitCode.Done;
    }

    // Invalid profiles are reported. The others are still listed.
    private static int List(string output, Session session)
    {
        var profiles = session.Profiles;
        var good = true;
        var rows = new List<string[]> { new[] { "PRINTER", "BUILD VOLUME", "NOZZLE", "FLAVOR", "" } };
        foreach (var name in profiles.Names<Printer>())
        {
            if (Read(profiles.Printer(name)) is not { } printer) continue;
            var size = printer.BuildVolume;
            rows.Add([name, $"{Number(size.X)} × {Number(size.Y)} × {Number(size.Z)} mm", Number(printer.NozzleDiameter) + " mm", printer.Flavor.Name,
                printer.Title]);
        }
        rows.Add([]);
        rows.Add(["MATERIAL", "NOZZLE, BED", "FILAMENT", "", ""]);
        foreach (var name in profiles.Names<Material>())
        {
            if (Read(profiles.Material(name)) is not { } material) continue;
            rows.Add([name, $"{Number(material.NozzleTemperature)}, {Number(material.BedTemperature)} °C", Number(material.FilamentDiameter) + " mm", "",
                material.Title]);
        }
        rows.Add([]);
        rows.Add(["SETTINGS", "LAYER, LINE", "SPEED", "", ""]);
        foreach (var name in profiles.Names<PrintSettings>())
        {
            if (Read(profiles.Settings(name)) is not { } settings) continue;
            var (given, usual) = (settings.AsGiven, settings.NozzleDiameter);
            var nozzle = given.LayerHeight > 0 && given.LineWidth > 0 ? "" : $" for a {Number(usual)} mm nozzle";
            var sizes = $"{Number(settings.LayerHeight)}, {Number(settings.LineWidth)} mm{nozzle}";
            rows.Add([name, sizes, Number(settings.PrintSpeed) + " mm/s", "", settings.Title]);
        }
        session.WriteText(output, text => TextTable.Write(text, rows));
        return good ? ExitCode.Done : ExitCode.BadInput;

        T? Read<T>(Result<T> result)
            where T : class
        {
            session.Print(result.Diagnostics);
            good &= result.Value is not null;
            return result.Value;
        }
    }

    private static void WriteKeys(TextWriter text)
    {
        TextTable.Write(text,
            [.. Rows("PRINTER", ProfileKeys.Of<Printer>()), [], .. Rows("MATERIAL", ProfileKeys.Of<Material>()), [],
            .. Rows("SETTINGS", ProfileKeys.Of<PrintSettings>())]);

        static IEnumerable<string[]> Rows(string title, IReadOnlyList<ProfileKey> keys)
            => keys.Select(k => new[] { k.Name, k.Summary + " (" + k.Range + ")" }).Prepend([title, ""]);
    }

    private static void Show(string name, string output, Session session)
    {
        var profiles = session.Profiles;
        if (name.StartsWith("material/", StringComparison.Ordinal)) Show<Material>(name["material/".Length..]);
        else if (name.StartsWith("settings/", StringComparison.Ordinal)) Show<PrintSettings>(name["settings/".Length..]);
        else if (profiles.Names<Printer>().Contains(name)) Show<Printer>(name);
        else if (profiles.Names<Material>().Contains(name)) Show<Material>(name);
        else if (profiles.Names<PrintSettings>().Contains(name)) Show<PrintSettings>(name);
        else Show<Printer>(name);

        void Show<T>(string which)
            where T : class
        {
            var profile = session.ValueOrFail(profiles.Find<T>(which), File.Exists(which) ? ExitCode.BadInput : ExitCode.Usage);
            session.WriteText(output, text => text.Write(ProfileWriter.Write(profile)));
            if (output != "-") session.Say(() => $"{output}: {profile}");
        }
    }

    private static string Number(double value) => NumberFormatter.Format(value, 3);
}
