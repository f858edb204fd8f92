namespace Caterpillar.Turtles;

/// <summary>
/// The direction of a turtle as three angles in degrees. From the world axes: yaw, then pitch, then roll, each about the turtle's own axes.
/// Positive yaw turns left, positive pitch raises the nose, positive roll raises the left side.
/// </summary>
internal readonly record struct Heading(double Yaw, double Pitch, double Roll)
{
    // Closer to vertical than this, yaw and roll are the same rotation.
    private const double Pole = 1e-9;

    /// <summary>
    /// The angles of a frame: yaw and roll from −180 to 180, pitch from −90 to 90. Straight up or down, yaw and roll are the same rotation. There, yaw
    /// includes the roll, and roll is 0.
    /// </summary>
    public static Heading Of(Frame frame)
    {
        var f = frame.X;
        var pitch = Angle.Atan2(f.Z, f.LengthXY);
        if (f.LengthXY < Pole) return new Heading(Angle.Atan2(-frame.Y.X, frame.Y.Y), pitch, 0);
        var yaw = Angle.Atan2(f.Y, f.X);
        // The left axis of the frame with this yaw and pitch and no roll, and its up axis.
        var left = new Vec3(-f.Y, f.X).Unit();
        var up = Vec3.Cross(f, left);
        return new Heading(yaw, pitch, Angle.Atan2(Vec3.Dot(frame.Y, up), Vec3.Dot(frame.Y, left)));
    }

    /// <summary>The frame with these angles at a point.</summary>
    public Frame ToFrame(Vec3 origin) => Frame.At(origin).Yaw(Yaw).Pitch(Pitch).Roll(Roll);

    /// <summary>The angles that face along a direction with the wings level. Straight up or down, <paramref name="yaw"/> is kept.</summary>
    /// <exception cref="ArgumentException">The direction is zero or not finite.</exception>
    public static Heading Towards(Vec3 direction, double yaw = 0)
    {
        if (!direction.IsFinite || !(direction.Length > 0)) throw new ArgumentException("The direction to face is zero or not finite.", nameof(direction));
        var d = direction.Unit();
        return new Heading(d.LengthXY < Pole ? yaw : Angle.Atan2(d.Y, d.X), Angle.Atan2(d.Z, d.LengthXY), 0);
    }
}
