namespace Caterpillar.GCode;

/// <summary>The feed rate as written, its factor (M220), and the speed that follows.</summary>
internal struct FeedState
{
    /// <summary>The feed rate as written, mm/min.</summary>
    public double Rate;

    public double Factor;

    /// <summary>The factor saved by M220 B.</summary>
    public double SavedFactor;

    /// <summary>The speed that follows, mm/s.</summary>
    public double Speed;

    public void Set(double rate, double factor)
    {
        Rate = rate;
        Factor = factor;
        Speed = rate / 60 * factor;
    }
}
