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
        if (Count == EndTime.Length) Grow();
        _time += t.Duration;
        EndTime[Count] = _time;
        if (Start.Length > 0)
        {
            Start[Count] = t.Start;
            Peak[Count] = t.Peak;
            End[Count] = t.End;
            Acceleration[Count] = t.Acceleration;
        }
        Count++;
    }

    /// <summary>There are so many moves, at least.</summary>
    public void Reserve(int moves)
    {
        if (First.Length <= moves) Array.Resize(ref First, 2 * moves + 1);
    }

    /// <summary>Seconds from the start to the start of a trapezoid.</summary>
    public double StartTime(int i) => i > 0 ? EndTime[i - 1] : 0;

    public Trapezoid this[int i] => new(Start[i], Peak[i], End[i], Acceleration[i], EndTime[i] - StartTime(i));

    private void Grow()
    {
        var size = checked(2 * Count);
        Array.Resize(ref EndTime, size);
        if (Start.Length == 0) return;
        Array.Resize(ref Start, size);
        Array.Resize(ref Peak, size);
        Array.Resize(ref End, size);
        Array.Resize(ref Acceleration, size);
    }
}
