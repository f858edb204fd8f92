namespace Caterpillar.Checks;

/// <summary>A move with what several checks need of it. Lengths in mm, volumes in mm³.</summary>
internal struct CheckedMove
{
    public int Index;
    public Vec3 Start;
    public Vec3 End;

    /// <summary>Rotary words at its start and at its end, degrees.</summary>
    public Vec3 StartTurns, EndTurns;

    /// <summary>False before the first move if the start position is unknown, and after homing.</summary>
    public bool StartKnown;

    /// <summary>A move to the switches.</summary>
    public bool IsHoming;

    /// <summary>True for such a move whose start is known.</summary>
    public bool HomesFromKnown;
    public MoveKind Kind;
    public Role Role;
    public int Layer;
    public int Tool;
    public double E;
    public double Speed;
    public double Length;
    public Arc? Arc;

    /// <summary>Material that becomes an extrusion, and what the extruder pushes (negative: pulls); NaN if unknown.</summary>
    public double Deposited;

    /// <inheritdoc cref="Deposited"/>
    public double Pushed;

    /// <summary>Nominal thickness of its layer; 0 if unknown.</summary>
    public double Thickness;
}

/// <summary>A check that sees all moves and events once, in order.</summary>
internal abstract class MoveCheck
{
    /// <summary>The codes of its findings. It does not run if all of them are off.</summary>
    public abstract IReadOnlyList<string> Codes { get; }

    /// <summary>An event before the next move.</summary>
    public virtual void Event(MoveEvent what)
    {
    }

    public abstract void Move(in CheckedMove move);

    /// <summary>After the last move.</summary>
    public virtual void End(Toolpath toolpath)
    {
    }
}
