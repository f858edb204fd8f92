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
    public ValueList<Vec3> Thumbnails { get; init => field = Keys.Check(value); } = new();

    /// <summary>Write the whole setup as comments at the end of the file, so that --settings FILE.gcode prints another part in the same way.</summary>
    public bool SetupComments { get; init; } = true;
}
