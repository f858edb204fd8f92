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
    public double[] Start;
    public double[] Peak;
    public double[] End;
    public double[] Acceleration;
    public int Count;

    // For waits and chords of arcs.
    private const int Spare = 64;
    private double _time;

    // What is forgotten: moves, trapezoids and their time.
    private int _goneMoves, _gone;
    private double _goneTime;

    /// <param name="moves">Number of moves that are expected.</param>
    /// <param name="timesOnly">Only times are kept, no speeds.</param>
    public MotionColumns(int moves, bool timesOnly = false)
    {
        var speeds = timesOnly ? 0 : moves + Spare;
        First = new int[moves + 1];
        EndTime = new double[moves + Spare];
        Start = new double[speeds];
        Peak = new double[speeds];
        End = new double[speeds];
        Acceleration = new double[speeds];
    }

    public double TotalTime => _time;

    public void Add(in Trapezoid t)
    {
        if (Count - _gone == EndTime.Length) Grow();
        _time += t.Duration;
        var i = Count++ - _gone;
        EndTime[i] = _time;
        if (Start.Length == 0) return;
        Start[i] = t.Start;
        Peak[i] = t.Peak;
        End[i] = t.End;
        Acceleration[i] = t.Acceleration;
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
        foreach (var column in new[] { EndTime, Start, Peak, End, Acceleration })
        {
            if (column.Length > 0) Array.Copy(column, first - _gone, column, 0, Count - first);
        }
        Array.Copy(First, move - _goneMoves, First, 0, First.Length - (move - _goneMoves));
        (_goneMoves, _gone) = (move, first);
    }

    /// <summary>Seconds from the start to the start of a trapezoid.</summary>
    public double StartTime(int i) => i > _gone ? EndTime[i - 1 - _gone] : _goneTime;

    /// <summary>Seconds from the start to the start of a move, before its waits.</summary>
    public double StartOf(int move) => StartTime(FirstOf(move));

    /// <summary>Seconds of waiting before a move.</summary>
    public double WaitBefore(int move)
    {
        int first = FirstOf(move), end = FirstOf(move + 1);
        while (first < end && Acceleration[first - _gone] == 0) first++;
        return StartTime(first) - StartOf(move);
    }

    /// <summary>Maximum speed of a move, mm/s; 0 if nothing moves.</summary>
    public double PeakOf(int move)
    {
        var peak = 0.0;
        for (int i = FirstOf(move), end = FirstOf(move + 1); i < end; i++) peak = Math.Max(peak, Peak[i - _gone]);
        return peak;
    }

    public Trapezoid this[int i] => new(Start[i], Peak[i], End[i], Acceleration[i], EndTime[i] - StartTime(i));

    private int FirstOf(int move) => First[move - _goneMoves];

    private void Grow()
    {
        var size = checked(2 * EndTime.Length);
        Array.Resize(ref EndTime, size);
        if (Start.Length == 0) return;
        Array.Resize(ref Start, size);
        Array.Resize(ref Peak, size);
        Array.Resize(ref End, size);
        Array.Resize(ref Acceleration, size);
    }
}
