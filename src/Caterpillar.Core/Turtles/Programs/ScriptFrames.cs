namespace Caterpillar.Turtles;

/// <summary>The frames of the running procedures. Their variables come one after the other in the values of the context, after the globals.</summary>
internal sealed class ScriptFrames(FormulaContext context, int globals, int maxDepth)
{
    private readonly List<Frame> _frames = [];
    private int _size = globals;

    /// <summary>Begins a procedure with the values of its parameters.</summary>
    /// <param name="procedure">The called procedure.</param>
    /// <param name="given">Values of its parameters.</param>
    /// <param name="back">The instruction after the call.</param>
    /// <param name="words">Words that are being drawn at the call.</param>
    /// <param name="at">The call: line and column.</param>
    /// <exception cref="FormulaException">Too many procedures call each other.</exception>
    public void Enter(Procedure procedure, double[] given, int back, int words, Token at)
    {
        if (_frames.Count >= maxDepth)
            throw new FormulaException("turtle.recursion",
                $"Procedure calls are nested {NumberFormatter.Format(maxDepth)} levels deep. Is there an endless recursion?", at);
        var start = context.Base + _size;
        _frames.Add(new Frame(back, context.Base, _size, words));
        var values = context.Values;
        Buffers.Reserve(ref values, start + procedure.FrameSize);
        context.Values = values;
        given.CopyTo(values, start);
        for (var i = start + given.Length; i < start + procedure.FrameSize; i++) values[i] = double.NaN;
        context.Base = start;
        _size = procedure.FrameSize;
    }

    /// <summary>Ends the current procedure. Returns the instruction after its call and the number of words that were being drawn there.</summary>
    public (int Back, int Words) Leave()
    {
        var frame = _frames[_frames.Count - 1];
        _frames.RemoveAt(_frames.Count - 1);
        context.Base = frame.Base;
        _size = frame.Size;
        return (frame.Back, frame.Words);
    }

    private readonly record struct Frame(int Back, int Base, int Size, int Words);
}
