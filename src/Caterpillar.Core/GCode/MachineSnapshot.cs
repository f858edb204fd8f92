using System.Collections.Generic;
using Caterpillar.Geometry;

namespace Caterpillar.GCode;

/// <summary>The state of the machine between two lines: what decides how the next line is read.</summary>
internal sealed class MachineSnapshot
{
    public double X;
    public double Y;
    public double Z;
    public double E;
    public double ShiftX;
    public double ShiftY;
    public double ShiftZ;
    public double A;
    public double B;
    public Turns Turns;
    public Turns TurnShift;
    public double Feed;
    public double FeedFactor;
    public double Flow;
    public double Speed;
    public double NextTool;
    public double ShadowE;
    public int Tool;
    public int Motion;
    public ArcPlane Plane;
    public bool Relative;
    public bool Inches;
    public bool M83;
    public bool LastRelative;
    public bool AbsoluteCenters;
    public bool Shadow;
    public bool Volumetric;
    public bool SwitchedOn;
    public bool KnownX;
    public bool KnownY;
    public bool KnownZ;
    public bool Started;
    public KeyValuePair<int, double>[] EByTool = [];

    /// <summary>True when lines are read alike in both states; where E is relative for good, its position does not matter.</summary>
    public bool ReadsAlike(MachineSnapshot other, bool positionOfEMatters)
        => Near(X, other.X) && Near(Y, other.Y) && Near(Z, other.Z) && (Near(E, other.E) || !positionOfEMatters)
            && Near(ShiftX, other.ShiftX) && Near(ShiftY, other.ShiftY) && Near(ShiftZ, other.ShiftZ)
            && Speed == other.Speed && Tool == other.Tool && Motion == other.Motion && Plane == other.Plane
            && Relative == other.Relative && Inches == other.Inches && M83 == other.M83 && LastRelative == other.LastRelative
            && AbsoluteCenters == other.AbsoluteCenters && Volumetric == other.Volumetric && Turns == other.Turns && TurnShift == other.TurnShift && SwitchedOn == other.SwitchedOn;

    private static bool Near(double a, double b) => System.Math.Abs(a - b) <= 1e-9;
}

/// <summary>The state before a chunk of the document, and how many lines and events are before it.</summary>
internal readonly record struct Checkpoint(int Line, MachineSnapshot State, int Events);
