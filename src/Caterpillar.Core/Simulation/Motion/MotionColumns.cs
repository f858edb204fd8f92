namespace Caterpillar.Simulation;

/// <summary>
/// The planned speeds of a toolpath: trapezoids in order, several for an arc, also for the times in which the machine waits. Never changed once planned.
/// </summary>
internal sealed class MotionColumns
{
    // First trapezoid of each move, and the number of trapezoids at the end; waits before a move belong to it.
    public int[] First;

    // Seconds from the start to the end of each trapezoid.
    public double[] EndTime;
    public int Count;

    // For waits and chords of arcs.
    private const int Spare = 64;
    private Speeds[] _speeds;
    private double _time;

    // What is forgotten: moves, trapezoids and their time.
    private int _goneMoves, _gone;
    private double _goneTime;

    /// <param name="moves">Number of moves that are expected.</param>
    /// <param name="timesOnly">Only times are kept, no speeds.</param>
    public MotionColumns(int moves, bool timesOnly = false)
    {
        First = new int[moves + 1];
        EndTime = new double[moves + Spare];
        _speeds = new Speeds[timesOnly ? 0 : moves + Spare];
    }

    public double TotalTime => _time;

    public bool HasSpeeds => _speeds.Length > 0;

    public void Add(in Trapezoid t)
    {
        _time += t.Duration;
        var i = Count++ - _gone;
        Buffers.Reserve(ref EndTime, i + 1);
        EndTime[i] = _time;
        if (!HasSpeeds) return;
        Buffers.Reserve(ref _speeds, i + 1);
        _speeds[i] = new Speeds(t.Start, t.Peak, t.End, t.Acceleration);
    }

    /// <summary>The next move, or the end, with its first trapezoid.</summary>
    public void Begin(int move, int trapezoid)
    {
        move -= _goneMoves;
        if (First.Length <= move) Array.Resize(ref First, 2 * move + 1);
        First[move] = trapezoid;
    }

    /// <summary>Forgets the moves before one, with their trapezoids. Only the methods that take the number of a move or trapezoid may be called then.</summary>
    public void Forget(int move)
    {
        var first = FirstOf(move);
        _goneTime = StartTime(first);
        Array.Copy(EndTime, first - _gone, EndTime, 0, Count - first);
        if (HasSpeeds) Array.Copy(_speeds, first - _gone, _speeds, 0, Count - first);
        Array.Copy(First, move - _goneMoves, First, 0, First.Length - (move - _goneMoves));
        (_goneMoves, _gone) = (move, first);
    }

    /// <summary>Seconds from the start to the start of a trapezoid.</summary>
    public double StartTime(int i) => i > _gone ? EndTime[i - 1 - _gone] : _goneTime;

    /// <summary>Seconds from the start to the start of a move, before its waits.</summary>
    public double StartOf(int move) => StartTime(FirstOf(move));

    /// <summary>Seconds of waiting before a move.</summary>
    public double WaitBefore(int move) => StartTime(FirstMoving(move)) - StartOf(move);

    /// <summary>The first trapezoid in which a move moves; the first one of the next move if there is none.</summary>
    public int FirstMoving(int move)
    {
        int first = FirstOf(move), end = FirstOf(move + 1);
        while (first < end && IsWait(first)) first++;
        return first;
    }

    /// <summary>True for the time in which the machine waits.</summary>
    public bool IsWait(int trapezoid) => _speeds[trapezoid - _gone].Acceleration == 0;

    /// <summary>Maximum speed of a move, mm/s; 0 if nothing moves.</summary>
    public double PeakOf(int move)
    {
        var peak = 0.0;
        for (int i = FirstOf(move), end = FirstOf(move + 1); i < end; i++) peak = Math.Max(peak, _speeds[i - _gone].Peak);
        return peak;
    }

    public Trapezoid this[int i] => new(_speeds[i].Start, _speeds[i].Peak, _speeds[i].End, _speeds[i].Acceleration, EndTime[i] - StartTime(i));

    private int FirstOf(int move) => First[move - _goneMoves];

    // The speeds of a trapezoid.
    private readonly record struct Speeds(double Start, double Peak, double End, double Acceleration);
}
