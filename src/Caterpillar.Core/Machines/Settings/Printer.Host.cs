namespace Caterpillar.Machines;

// What a file tells the program that prints it.
public sealed partial record Printer
{
    /// <summary>Write the print time (;TIME) and the progress (M73), if the flavor supports it.</summary>
    public bool ProgressCommands { get; init; } = true;

    /// <summary>Mark the objects with the commands of the flavor (EXCLUDE_OBJECT, M486), so that one can be canceled. false = only comments.</summary>
    public bool ObjectLabels { get; init; } = true;

    /// <summary>Images of the print in the file, for print hosts and displays: width and height of each. Mainsail and Fluidd show 32 and 300 pixels.</summary>
    /// <value>pixels.</value>
    public ValueList<Vec3> Thumbnails { get; init => field = HostKeys.Thumbnails.Check(value); } = new();

    /// <summary>Write the whole setup as comments at the end of the file, so that --settings FILE.gcode prints another part in the same way.</summary>
    public bool SetupComments { get; init; } = true;
}

/// <summary>Keys of printers: what a file tells the program that prints it.</summary>
internal static class HostKeys
{
    public static readonly KeyTable<Printer> All = new();

    public static readonly PrinterFlagKey ProgressCommands
        = All.Boolean("progress_commands", p => p.ProgressCommands, (p, v) => p with { ProgressCommands = v });
    public static readonly PrinterFlagKey ObjectLabels = All.Boolean("object_labels", p => p.ObjectLabels, (p, v) => p with { ObjectLabels = v });
    public static readonly ProfileKey<Printer, ValueList<Vec3>> Thumbnails = All.Of(
        "thumbnails_px", new RowsFormat<Vec3>(["width", "height"], 16, 16, 1000, n => new Vec3(n[0], n[1], 0), v => [v.X, v.Y]), p => p.Thumbnails,
        (p, v) => p with { Thumbnails = v });
    public static readonly PrinterFlagKey SetupComments = All.Boolean("setup_comments", p => p.SetupComments, (p, v) => p with { SetupComments = v });
}
