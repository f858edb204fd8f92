using System;
using Caterpillar.Basics;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>Speeds and accelerations beyond the axes, more material than hot end and material allow, tools that do not exist.</summary>
internal sealed class RateCheck(PrintSetup setup, Findings findings) : IMoveCheck
{
    private const double Rounding = 1.001;
    private readonly Printer _printer = setup.Printer;

    // What rounding in a file may change: coordinates in mm, E, speeds in mm/s.
    private readonly double _roundedXyz = Math.Pow(10, -setup.Printer.DecimalsXyz);
    private readonly double _roundedE = Math.Pow(10, -setup.Printer.DecimalsE);
    private readonly double _roundedF = Math.Pow(10, -setup.Printer.DecimalsF) / 60;

    public void Event(MoveEvent what)
    {
        var (value, most) = what.Event switch
        {
            AccelerationEvent set => (set.Value, OfHead(_printer.MaxAcceleration)),
            LimitEvent { Limit: MotionLimit.PrintAcceleration or MotionLimit.TravelAcceleration } set => (set.Value, OfHead(_printer.MaxAcceleration)),
            LimitEvent { Limit: MotionLimit.RetractionAcceleration } set => (set.Value, _printer.MaxAcceleration.E),
            LimitEvent { Limit: MotionLimit.AccelerationX } set => (set.Value, _printer.MaxAcceleration.X),
            LimitEvent { Limit: MotionLimit.AccelerationY } set => (set.Value, _printer.MaxAcceleration.Y),
            LimitEvent { Limit: MotionLimit.AccelerationZ } set => (set.Value, _printer.MaxAcceleration.Z),
            LimitEvent { Limit: MotionLimit.AccelerationE } set => (set.Value, _printer.MaxAcceleration.E),
            _ => (0, 0),
        };
        if (!(value > most)) return;
        findings.Add(CheckCodes.Acceleration, what.Move,
            () => $"An acceleration is set to {Figures.Short(value)} mm/s²; {_printer.Title} stands {Figures.Short(most)} mm/s².");
    }

    public void Move(in CheckedMove move)
    {
        if (move.Tool >= _printer.ToolCount) ReportTool(move);
        if (!move.StartKnown || !(move.Length > 0) || !(move.Speed > 0)) return;
        var most = MaxSpeed(move, _printer.MaxSpeed);
        // Travels are slowed down without harm; a strand printed more slowly is not the one that was asked for.
        if (move.Speed > most * (1 + 1e-9) + _roundedF) ReportSpeed(move, most);
        if (move.Kind != MoveKind.Print) return;
        var flow = move.Deposited / move.Length * Math.Min(move.Speed, most);
        if (!(flow > setup.MaxFlow * Rounding)) return;
        // In short moves the last decimals count for more.
        var least = (move.Deposited - _roundedE * move.Pushed / move.E) / (move.Length + 2 * _roundedXyz) * Math.Min(move.Speed, most);
        if (least > setup.MaxFlow * Rounding) ReportFlow(flow, move.Index);
    }

    public void End(Toolpath toolpath)
    {
    }

    private static double OfHead(AxisValues axes) => Math.Max(axes.X, axes.Y);

    // What the axes allow in a direction; an arc is taken by its chord in Z and by the slower of X and Y.
    private double MaxSpeed(in CheckedMove move, AxisValues axes)
    {
        var path = move.End - move.Start;
        if (path == Geometry.Vec3.Zero) return Math.Min(axes.X, axes.Y);
        return Math.Min(MaxSpeed(path.X, move.Length, axes.X), Math.Min(MaxSpeed(path.Y, move.Length, axes.Y), MaxSpeed(path.Z, move.Length, axes.Z)));
    }

    // Where an axis moves by a few of the last decimals, its share is not known better.
    private double MaxSpeed(double along, double length, double axis)
    {
        var path = Math.Abs(along) < 20 * _roundedXyz ? Math.Abs(along) - _roundedXyz : Math.Abs(along);
        return path > 0 ? axis * length / path : double.MaxValue;
    }

    private void ReportTool(in CheckedMove move)
    {
        var tool = move.Tool;
        findings.Add(CheckCodes.Tool, move.Index,
            () => $"A move is for tool {NumberFormatter.Format(tool)}; {_printer.Title} has {NumberFormatter.Format(_printer.ToolCount)}, counted from 0.");
    }

    private void ReportSpeed(in CheckedMove move, double most)
    {
        var speed = move.Speed;
        findings.Add(move.Kind == MoveKind.Print ? CheckCodes.Speed : CheckCodes.TravelSpeed, move.Index,
            () => $"A move asks for {Figures.Short(speed)} mm/s; {_printer.Title} moves there at {Figures.Short(most)} mm/s and will "
                + "slow down.");
    }

    private void ReportFlow(double flow, int move)
        => findings.Add(CheckCodes.Flow, move,
            () => $"A move asks for {Figures.Short(flow)} mm³/s of material; the limit is {Figures.Short(setup.MaxFlow)} mm³/s.");
}
