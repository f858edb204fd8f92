namespace Caterpillar.Simulation;

/// <summary>The limits in force: those of the printer until a command in the file sets others.</summary>
internal sealed class MachineLimits
{
    // Speed before the first F: 1500 mm/min in Marlin, 25 mm/s in Klipper.
    public const double FirstSpeed = 25;

    // What a file may set, so that no limit stops the machine for ever.
    private const double Least = 1e-6;

    private readonly double[] _values = new double[Enum.GetValues(typeof(MotionLimit)).Length];

    public MachineLimits(Printer printer)
    {
        Set(MotionLimit.PrintAcceleration, printer.PrintAcceleration);
        Set(MotionLimit.TravelAcceleration, printer.TravelAcceleration);
        Set(MotionLimit.RetractionAcceleration, printer.RetractionAcceleration);
        SetAxes(MotionLimit.AccelerationX, printer.MaxAcceleration);
        SetAxes(MotionLimit.SpeedX, printer.MaxSpeed);
        SetAxes(MotionLimit.JerkX, printer.Jerk);
        Set(MotionLimit.JunctionDeviation, printer.JunctionDeviation);
        Set(MotionLimit.SquareCornerVelocity, printer.SquareCornerVelocity);
        Set(MotionLimit.MinimumCruiseRatio, printer.MinimumCruiseRatio);
        Set(MotionLimit.Speed, Math.Min(printer.MaxSpeed.X, printer.MaxSpeed.Y));
        Set(MotionLimit.HeadJerk, Math.Min(printer.Jerk.X, printer.Jerk.Y));
        HeadAcceleration = Math.Min(printer.MaxAcceleration.X, printer.MaxAcceleration.Y);
    }

    public double this[MotionLimit limit] => _values[(int)limit];

    /// <summary>Acceleration of the head where there is one for all its moves (Klipper), mm/s².</summary>
    public double HeadAcceleration { get; private set; }

    /// <summary>Takes a command of the file; others than those of limits are ignored.</summary>
    public void Apply(PrinterEvent what)
    {
        switch (what)
        {
            case AccelerationEvent acceleration:
                Set(MotionLimit.PrintAcceleration, acceleration.Value);
                Set(MotionLimit.TravelAcceleration, acceleration.Value);
                HeadAcceleration = Math.Max(acceleration.Value, Least);
                break;
            case LimitEvent { Limit: MotionLimit.HeadJerk } jerk:
                Set(MotionLimit.JerkX, jerk.Value);
                Set(MotionLimit.JerkY, jerk.Value);
                break;
            case LimitEvent limit:
                Set(limit.Limit, limit.Value);
                break;
        }
    }

    private void SetAxes(MotionLimit first, AxisValues values)
    {
        Set(first, values.X);
        Set(first + 1, values.Y);
        Set(first + 2, values.Z);
        Set(first + 3, values.E);
    }

    private void Set(MotionLimit limit, double value)
        => _values[(int)limit] = limit switch
        {
            MotionLimit.MinimumCruiseRatio => Math.Min(Math.Max(value, 0), 0.999),
            MotionLimit.JunctionDeviation or MotionLimit.SquareCornerVelocity or >= MotionLimit.JerkX and <= MotionLimit.JerkE => Math.Max(value, 0),
            _ => Math.Max(value, Least),
        };
}
