using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Simulation;

/// <summary>What a machine does at one moment of a <see cref="Timeline"/>.</summary>
public readonly record struct MachineState
{
    /// <summary>Seconds from the start.</summary>
    public double Time { get; init; }

    /// <summary>Seconds to the end.</summary>
    public double TimeLeft { get; init; }

    /// <summary>
    /// The move in progress, from 0; the number of moves when all are over. What is printed so far is all moves before it and <see cref="Done"/> of it.
    /// </summary>
    public int Move { get; init; }

    /// <summary>Part of the move that is done, 0 to 1.</summary>
    public double Done { get; init; }

    /// <summary>The machine waits: a dwell, heat, a change of the tool, homing.</summary>
    public bool Waits { get; init; }

    /// <summary>Tip of the nozzle, mm.</summary>
    public Vec3 Position { get; init; }

    /// <summary>Direction of the motion, of length 1; zero where the head stands.</summary>
    public Vec3 Direction { get; init; }

    /// <summary>Speed of the head in mm/s; of the filament for moves in place.</summary>
    public double Speed { get; init; }

    /// <summary>Material that is deposited, mm³/s; null where the factor of the tool is not known.</summary>
    public double? Flow { get; init; }

    /// <summary>What the move does.</summary>
    public MoveKind Kind { get; init; }

    /// <summary>What the extrusion is for.</summary>
    public Role Role { get; init; }

    /// <summary>Index into the layers of the toolpath, or −1.</summary>
    public int Layer { get; init; }

    /// <summary>The tool in use.</summary>
    public int Tool { get; init; }

    /// <summary>Line of the file (from 1) or number of the step (from 0), as the toolpath says; −1 where there is none.</summary>
    public int Source { get; init; }

    /// <summary>Path length of the head so far, mm.</summary>
    public double Length { get; init; }

    /// <summary>E deposited so far, in the units of the tools.</summary>
    public double Filament { get; init; }

    /// <summary>Material deposited so far, mm³; null where the factor of a tool is not known.</summary>
    public double? Volume { get; init; }

    /// <summary>Temperature of the nozzle by the model of heating, °C.</summary>
    public double NozzleTemperature { get; init; }

    /// <summary>Temperature that the nozzle should have, °C; 0 for off.</summary>
    public double NozzleTarget { get; init; }

    /// <summary>Temperature of the bed by the model of heating, °C.</summary>
    public double BedTemperature { get; init; }

    /// <summary>Temperature that the bed should have, °C; 0 for off.</summary>
    public double BedTarget { get; init; }

    /// <summary>Part cooling fan, 0 to 1.</summary>
    public double Fan { get; init; }

    /// <summary>
    /// A frame at the tip of the nozzle: Z up, X along the motion in plan; the axes of the world where it stands or goes straight up or down.
    /// </summary>
    public Frame Frame
    {
        get
        {
            var plan = new Vec3(Direction.X, Direction.Y);
            var x = plan.Length > 1e-9 ? plan : Vec3.UnitX;
            return Frame.FromAxes(Position, x, Vec3.Cross(Vec3.UnitZ, x));
        }
    }
}
