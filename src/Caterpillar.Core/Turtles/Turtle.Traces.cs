namespace Caterpillar.Turtles;

// Parts made of strings, and what scripts see of a turtle.
public sealed partial class Turtle
{
    /// <summary>
    /// Prints a part made of strings in the coordinates of the turtle: x is forward, y left, z up. The turtle does not move. If the pen is up, nothing is
    /// printed. Strings without a speed are printed at the speed of the turtle.
    /// </summary>
    public Turtle Draw(Trace part)
    {
        if (part is null) throw new ArgumentNullException(nameof(part));
        if (!_state.PenDown) return this;
        var (frame, own, tags) = (Pose, Bead, _state.Tags);
        foreach (var s in part.Strings)
            _recorder.Print(frame.ToWorld(s.Start), frame.ToWorld(s.End), new Bead(s.Area, own.Height, s.Speed > 0 ? s.Speed : own.Speed), tags);
        return this;
    }

    /// <summary>Bead shape of extrusions that are set by width and height.</summary>
    internal BeadShape Shape => _options.Shape;

    /// <summary>Estimated memory of the recorded steps, bytes.</summary>
    internal long Bytes => _recorder.Bytes + StateBytes * _stack.Count + PoseBytes * (_poses?.Count ?? 0);

    // With the unused half of a growing list.
    private const long StateBytes = 300;
    private const long PoseBytes = 192;

    /// <summary>The steps so far, which a script may take back to shape them.</summary>
    internal StepRecorder Recorder => _recorder;
}
