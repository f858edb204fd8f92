namespace Caterpillar.Simulation;

/// <summary>State of a machine at one time of a <see cref="Timeline"/>.</summary>
public readonly record struct MachineState
{
    /// <summary>Seconds from the start.</summary>
    public double Time { get; init; }

    /// <summary>Seconds to the end.</summary>
    public double TimeLeft { get; init; }

    /// <summary>The move in progress, from 0; the number of moves at the end. All moves before it are complete, and <see cref="Done"/> of it.</summary>
    public int Move { get; init; }

    /// <summary>Fraction of the move that is complete, 0 to 1.</summary>
    public double Done { get; init; }

    /// <summary>True while the machine waits: for a dwell, heating, a tool change or homing.</summary>
    public bool Waits { get; init; }

    /// <summary>Position of the nozzle tip, mm.</summary>
    public Vec3 Position { get; init; }

    /// <summary>The head as it stands over the part: its own axes at the nozzle tip, Z along the tool.</summary>
    public Frame Head { get; init; }

    /// <summary>Direction of motion, of length 1; zero if the head does not move.</summary>
    public Vec3 Direction { get; init; }

    /// <summary>Speed of the head in mm/s; of the filament for moves in place.</summary>
    public double Speed { get; init; }

    /// <summary>Volumetric flow, mm³/s; null if the filament diameter of the tool is unknown.</summary>
    public double? Flow { get; init; }

    /// <summary>Kind of the move.</summary>
    public MoveKind Kind { get; init; }

    /// <summary>Role of the extrusion.</summary>
    public Role Role { get; init; }

    /// <summary>Index into the layers of the toolpath, or −1.</summary>
    public int Layer { get; init; }

    /// <summary>The tool in use.</summary>
    public int Tool { get; init; }

    /// <summary>Line of the file (from 1) or number of the step (from 0), depending on the toolpath; −1 = none.</summary>
    public int Source { get; init; }

    /// <summary>Path length of the head so far, mm.</summary>
    public double Length { get; init; }

    /// <summary>E extruded so far, in the units of the tools.</summary>
    public double Filament { get; init; }

    /// <summary>Material extruded so far, mm³; null if the filament diameter of a tool is unknown.</summary>
    public double? Volume { get; init; }

    /// <summary>Simulated nozzle temperature, °C.</summary>
    public double NozzleTemperature { get; init; }

    /// <summary>Target nozzle temperature, °C; 0 = off.</summary>
    public double NozzleTarget { get; init; }

    /// <summary>Simulated bed temperature, °C.</summary>
    public double BedTemperature { get; init; }

    /// <summary>Target bed temperature, °C; 0 = off.</summary>
    public double BedTarget { get; init; }

    /// <summary>Speed of the part cooling fan, 0 to 1.</summary>
    public double Fan { get; init; }

    /// <summary>
    /// Frame at the nozzle tip: Z along the tool, X along the motion across it. The world axes if an upright head does not move or moves vertically.
    /// </summary>
    public Frame Frame
    {
        get
        {
            var tool = Head.Z;
            var x = Across(Direction, tool);
            if (!(x.Length > 1e-9)) x = Across(Math.Abs(tool.X) < 0.9 ? Vec3.UnitX : Vec3.UnitY, tool);
            return Frame.FromAxes(Position, x, Vec3.Cross(tool, x));
        }
    }

    private static Vec3 Across(Vec3 v, Vec3 tool) => v - tool * Vec3.Dot(v, tool);
}
