using System;

namespace Caterpillar.Simulation;

/// <summary>
/// The planned speeds of a toolpath: trapezoids in order, several for an arc, also for the times in which the machine waits. Never changed once planned.
/// </summary>
internal sealed class MotionColumns
{
    // First trapezoid of each move, and the number of trapezoids at the end; waits before a move belong to it.
    public readonly int[] First;

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

    public MotionColumns(int moves)
    {
        First = new int[moves + 1];
        EndTime = new double[moves + Spare];
        Start = new double[moves + Spare];
        Peak = new double[moves + Spare];
        End = new double[moves + Spare];
        Acceleration = new double[moves + Spare];
    }

    public double TotalTime => _time;

    public void Add(in Trapezoid t)
    {
        if (Count == EndTime.Length) Grow();
        _time += t.Duration;
        EndTime[Count] = _time;
        Start[Count] = t.Start;
        Peak[Count] = t.Peak;
        End[Count] = t.End;
        Acceleration[Count] = t.Acceleration;
        Count++;
    }

    /// <summary>Seconds from the start to the start of a trapezoid.</summary>
    public double StartTime(int i) => i > 0 ? EndTime[i - 1] : 0;

    public Trapezoid this[int i] => new(Start[i], Peak[i], End[i], Acceleration[i], EndTime[i] - StartTime(i));

    private void Grow()
    {
        var size = checked(Count + Count / 2 + Spare);
        Array.Resize(ref EndTime, size);
        Array.Resize(ref Start, size);
        Array.Resize(ref Peak, size);
        Array.Resize(ref End, size);
        Array.Resize(ref Acceleration, size);
    }
}
