using System.Collections.Generic;
using System.Linq;
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

    /// <summary>mm (or mm³) for one unit of E as it is written now.</summary>
    public double UnitOfE = 1;

    public double KeptFactor = 1;
    public int Workspace;
    public double[]? Workspaces;
    public Vec3 Stored28;
    public Vec3 Stored30;
    public Vec3 Offset;
    public double OffsetE;
    public KeptState[] ModeStack = [];
    public KeptState[] NamedStates = [];

    /// <summary>True when lines are read alike in both states; where E is relative for good, its position does not matter.</summary>
    public bool ReadsAlike(MachineSnapshot other, bool positionOfEMatters)
        => Near(X, other.X) && Near(Y, other.Y) && Near(Z, other.Z) && (Near(E, other.E) || !positionOfEMatters)
            && Near(ShiftX, other.ShiftX) && Near(ShiftY, other.ShiftY) && Near(ShiftZ, other.ShiftZ)
            && Speed == other.Speed && Tool == other.Tool && Motion == other.Motion && Plane == other.Plane
            && Relative == other.Relative && Inches == other.Inches && M83 == other.M83 && LastRelative == other.LastRelative
            && AbsoluteCenters == other.AbsoluteCenters && Volumetric == other.Volumetric && SwitchedOn == other.SwitchedOn && Turns == other.Turns
                && TurnShift == other.TurnShift
            && Workspace == other.Workspace && Alike(Workspaces, other.Workspaces) && Stored28 == other.Stored28 && Stored30 == other.Stored30
            && Offset == other.Offset && OffsetE == other.OffsetE && ModeStack.SequenceEqual(other.ModeStack) && NamedStates.SequenceEqual(other.NamedStates);

    private static bool Near(double a, double b) => System.Math.Abs(a - b) <= 1e-9;

    private static bool Alike(double[]? a, double[]? b) => a is null || b is null ? a == b : a.SequenceEqual(b);
}

/// <summary>The state before a chunk of the document, and how many lines and events are before it.</summary>
internal readonly record struct Checkpoint(int Line, MachineSnapshot State, int Events);
