namespace Caterpillar.GCode;

/// <summary>A move that a line has to make, in machine coordinates.</summary>
internal readonly record struct TargetMove(double X, double Y, double Z, double E, double Speed, MoveKind Kind, int Tool, Arc? Arc, Vec3 Turns)
{
    public TargetMove(ToolpathColumns c, int i)
        : this(
            c.X[i], c.Y[i], c.Z[i], c.E[i], c.Speed[i], c.Kind[i], c.Tool[i], c.TryGetArc(i, out var arc) ? arc : null, c.TurnsAt(i, Vec3.Zero))
    {
    }

    public Vec3 End => new(X, Y, Z);
}
