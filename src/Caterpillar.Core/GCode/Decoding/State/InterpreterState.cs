namespace Caterpillar.GCode;

/// <summary>The state of the machine between two lines. It decides how the next line is read. Its parts are values, so that a copy is a snapshot.</summary>
internal sealed class InterpreterState
{
    /// <summary>Differences below this count as no change, mm or degrees.</summary>
    public const double NoChange = 1e-9;

    public HeadPosition Head;
    public Modes Modes = new() { IsPlain = true };
    public FeedState Feed = new() { Factor = 1, SavedFactor = 1 };
    public ExtrusionState Extrusion = new() { Flow = 1 };
    public RotaryPosition Rotary;
    public WorkOffsets Work;
    public SavedStates Saved = SavedStates.None;
    public RetractionState Retraction;

    // Positions that G28.1 and G30.1 store, in machine coordinates; those the machine itself has are taken as zero.
    public Vec3 Stored28;
    public Vec3 Stored30;

    public int Tool;

    /// <summary>The tool for the next M6, or NaN.</summary>
    public double NextTool = double.NaN;

    /// <summary>The position of E of each tool, if the firmware keeps one per tool.</summary>
    public KeyValuePair<int, double>[] EByTool = [];

    public void CopyFrom(InterpreterState from)
    {
        Head = from.Head;
        Modes = from.Modes;
        Feed = from.Feed;
        Extrusion = from.Extrusion;
        Rotary = from.Rotary;
        Work = from.Work;
        Saved = from.Saved;
        Retraction = from.Retraction;
        Stored28 = from.Stored28;
        Stored30 = from.Stored30;
        Tool = from.Tool;
        NextTool = from.NextTool;
        EByTool = from.EByTool;
    }

    /// <summary>True if lines are read alike in both states. With relative E, its position does not matter.</summary>
    public bool ReadsLike(InterpreterState other, bool positionOfEMatters)
        => Head.ReadsLike(other.Head) && (System.Math.Abs(Extrusion.E - other.Extrusion.E) <= NoChange || !positionOfEMatters)
            && Feed.Speed == other.Feed.Speed && Tool == other.Tool && Modes.ReadsLike(other.Modes)
            && Extrusion.IsSwitchedOn == other.Extrusion.IsSwitchedOn && Rotary == other.Rotary && Work.ReadsLike(other.Work)
            && Stored28 == other.Stored28 && Stored30 == other.Stored30 && Saved.ReadsLike(other.Saved)
            && Retraction == other.Retraction;
}

/// <summary>The state before a chunk of the document, and the number of lines before it.</summary>
internal readonly record struct Checkpoint(int Line, InterpreterState State);
