namespace Caterpillar.Toolpaths;

/// <summary>Material extruded in place as a ball of its volume below the nozzle, or as a disc where the nozzle is nearer to the bed.</summary>
/// <param name="Tip">The nozzle tip, mm: the top.</param>
/// <param name="Width">Diameter seen from above, mm.</param>
/// <param name="Height">Height, mm.</param>
internal readonly record struct Blob(Vec3 Tip, double Width, double Height)
{
    /// <summary>The blob of a move; null if it extrudes nothing in place, and for start and end code.</summary>
    public static Blob? Of(Toolpath toolpath, in Move move)
    {
        if (move.Kind != MoveKind.Prime || move.Role == Role.Purge || (move.Layer < 0 && toolpath.Layers.Count > 0)) return null;
        if (toolpath.VolumeOf(move) is not { } volume || !(volume > 0)) return null;
        var ball = Math.Pow(6 * volume / Math.PI, 1.0 / 3);
        return move.End.Z > 0 && move.End.Z < ball ? new Blob(move.End, 2 * Math.Sqrt(volume / (Math.PI * move.End.Z)), move.End.Z)
            : new Blob(move.End, ball, ball);
    }
}
