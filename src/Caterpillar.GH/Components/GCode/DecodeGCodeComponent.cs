namespace Caterpillar.GH.Components.GCode;

/// <summary>Decodes G-code into a toolpath.</summary>
public sealed class DecodeGCodeComponent() : CaterpillarComponent(
    "Decode G-code", "Decode", "Decodes a G-code file, or G-code from a wire, into a toolpath.", Panel.GCode, GH_Exposure.secondary)
{
    private const string Detect = "detect";

    public override Guid ComponentGuid => new("334b128d-8e26-4ad8-9a21-2ca498c1e28b");

    private protected override void Inputs(InputPorts ports)
    {
        ports.File("File", "F",
            "G-code file: plain, binary (.bgcode) or gzip.", "G-code|*.gcode;*.bgcode;*.gco;*.g;*.nc;*.gcode.gz|All files|*.*", optional: true);
        ports.Add(new GCodeParam(), "G-code", "G", "G-code or its text, instead of a file.", optional: true);
        ports.Text("Flavor", "Fl", "G-code flavor, such as marlin2, klipper or reprapfirmware. detect = from the file.", Detect);
        ports.Choice("Rule", "R", "What counts as printing: E beyond the retracted length (Balance), or any increase of E (Rising).", ExtrusionRule.Balance);
        ports.Setup("The toolpath is simulated, checked and written with it. Default: the limits in the comments of the file.");
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new ToolpathParam(), "Toolpath", "T", "Moves of the file with their roles, layers and lines.");
        ports.Add(new GCodeParam(), "G-code", "G", "G-code of the file, byte for byte.");
        ports.Text("Settings", "S", "Slicer settings in the comments of the file, as key=value.", GH_ParamAccess.list);
        ports.Text("Flavor", "Fl", "G-code flavor used for decoding.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var options = new DecodeOptions { Flavor = Flavor(run.Maybe<string>(2)), Rule = run.Choice<ExtrusionRule>(3) };
        var wired = run.Maybe<GCodeDocument>(1);
        if (wired is not null && !string.IsNullOrEmpty(run.Maybe<string>(0)))
            run.Report(GH_RuntimeMessageLevel.Warning, "File is ignored because G-code is connected.");
        var source = wired ?? Read(run);
        var result = run.Work("Decoding", [source, options], (progress, cancel) => GCodeDecoder.Decode(source, options, progress, cancel));
        var none = result.Value?.NotGCode;
        run.Report(none is null ? result.Diagnostics : [none]);
        run.Set(1, new GCodeGoo { Value = source });
        if (none is not null || result.Value is not { } decoding)
        {
            run.Set(0, null);
            return;
        }
        run.Set(0, new ToolpathGoo(decoding, run.Maybe<PrintSetup>(4)));
        run.SetList(2, decoding.Settings.OrderBy(s => s.Key, StringComparer.Ordinal).Select(s => $"{s.Key}={s.Value}"));
        run.Set(3, decoding.Flavor.Name);
        run.Summarize($"{NumberFormatter.Format(decoding.Toolpath.Count)} moves");
    }

    private static FlavorRules? Flavor(string? name)
    {
        if (string.IsNullOrWhiteSpace(name) || string.Equals(name, Detect, StringComparison.OrdinalIgnoreCase)) return null;
        return FlavorTable.Find(name!) ?? throw new InputProblem(
            $"G-code flavor \"{name}\" not found. Use {Detect}, {string.Join(", ", FlavorTable.All.Select(d => d.Name))}.");
    }

    private static GCodeDocument Read(Run run)
    {
        var name = run.Maybe<string>(0);
        if (string.IsNullOrEmpty(name)) throw new InputProblem("File or G-code is missing.") { IsMissing = true };
        var file = run.FileAt(name!);
        // A changed file has another time or size and is read again.
        var read = run.Work("Reading", [file.FullName, file.LastWriteTimeUtc, file.Length], (_, cancel) => GCodeDocument.ReadFile(file.FullName, cancel));
        return read.Value ?? throw new InputProblem($"{file.FullName}: {read.Diagnostics[0].Message}");
    }
}
