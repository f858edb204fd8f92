namespace Caterpillar.Turtles;

// The printer: pen, bead, speed, events and tags.
public sealed partial class Turtle
{
    // Far above all machines, and far below what G-code can write.
    private const double MaxSpeed = 1e6;
    private const double MaxTemperature = 10_000;

    /// <summary>True if moves print.</summary>
    public bool IsPenDown => _state.PenDown;

    /// <summary>The bead of moves with the pen down.</summary>
    public Bead Bead => _state.Bead;

    /// <summary>Extrusion in mm of filament per mm of path.</summary>
    public double Density => _options.Extrusion.FactorOfArea(Bead.Area);

    /// <summary>Print speed, mm/s.</summary>
    public double Speed => Bead.Speed;

    /// <summary>Print speed, mm/min.</summary>
    public double Rate => Bead.Speed * 60;

    /// <summary>Travel speed, mm/s. Same as the print speed unless set.</summary>
    public double TravelSpeed => _state.TravelSpeed > 0 ? _state.TravelSpeed : _state.Bead.Speed;

    /// <summary>Raises the pen: the following moves do not print. Retraction is up to planning.</summary>
    public Turtle PenUp() => Pen(false);

    /// <summary>Lowers the pen: the following moves print.</summary>
    public Turtle PenDown() => Pen(true);

    /// <summary>Raises or lowers the pen.</summary>
    public Turtle Pen(bool down)
    {
        _state.PenDown = down;
        return this;
    }

    /// <summary>
    /// Sets the extrusion in mm of filament per mm of path. ExtruderTurtle uses 0.01 to 0.10. Its default is 0.05. For a 0.4 mm nozzle and 0.2 mm layers, 0.03
    /// is standard.
    /// </summary>
    public Turtle SetDensity(double filamentPerMm) => With(new Bead(_options.Extrusion.AreaOfFactor(filamentPerMm), 0, Speed));

    /// <summary>Sets the cross-section of the extrusion in mm² (Kanada), and its height if known.</summary>
    public Turtle SetArea(double area, double height = 0) => With(new Bead(area, height, Speed));

    /// <summary>Sets the extrusion by width and height in mm and a flow ratio (Caterpillar). The default shape comes from the options.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A value is negative or not finite, or a stadium is narrower than its height.</exception>
    public Turtle SetBead(double width, double height, double flow = 1, BeadShape? shape = null)
        => With(Bead.FromWidth(width, height, flow, Speed, shape ?? _options.Shape));

    /// <summary>Sets the bead. A bead without a speed keeps the current speed.</summary>
    public Turtle SetBead(Bead bead) => With(bead.Speed > 0 ? bead : bead with { Speed = Speed });

    /// <summary>Sets the print speed in mm/min, as in G-code (ExtruderTurtle). The "mm/s" in its paper is an error.</summary>
    public Turtle SetRate(double mmPerMinute) => SetSpeed(mmPerMinute / 60);

    /// <summary>Sets the print speed in mm/s (Kanada).</summary>
    public Turtle SetSpeed(double mmPerSecond)
    {
        if (mmPerSecond > MaxSpeed) throw new ArgumentOutOfRangeException(nameof(mmPerSecond), "The speed must be at most 1000000 mm/s.");
        return With(Bead with { Speed = Positive(mmPerSecond, "The speed must be above 0.") });
    }

    /// <summary>Sets the travel speed in mm/s; 0 = print speed.</summary>
    public Turtle SetTravelSpeed(double mmPerSecond)
    {
        if (!(mmPerSecond is >= 0 and <= MaxSpeed))
            throw new ArgumentOutOfRangeException(nameof(mmPerSecond), "The travel speed must be 0 to 1000000 mm/s.");
        _state.TravelSpeed = mmPerSecond;
        return this;
    }

    /// <summary>Extrudes filament in place, mm, with the pen up or down. Negative values retract.</summary>
    public Turtle Extrude(double filament)
    {
        if (double.IsNaN(filament) || double.IsInfinity(filament)) throw NotFinite();
        return Event(new ExtrudeEvent(_options.Extrusion.AreaOfFactor(filament) / _options.Extrusion.Multiplier, _state.Bead.Speed));
    }

    /// <summary>Waits for a time in milliseconds.</summary>
    public Turtle Dwell(double milliseconds)
    {
        if (!(milliseconds is >= 0 and <= 1e9)) throw new ArgumentOutOfRangeException(nameof(milliseconds), "The dwell time must be 0 to 1000000000 ms.");
        return Event(new DwellEvent(milliseconds / 1000));
    }

    /// <summary>Waits for the user.</summary>
    public Turtle Pause(string message = "") => Event(new PauseEvent(message));

    /// <summary>Sets the nozzle temperature in °C (0 = off). By default, waits until it is reached.</summary>
    public Turtle NozzleTemperature(double celsius, bool wait = true) => Event(new NozzleTemperatureEvent(Temperature(celsius), wait));

    /// <summary>Sets the bed temperature in °C (0 = off). By default, waits until it is reached.</summary>
    public Turtle BedTemperature(double celsius, bool wait = true) => Event(new BedTemperatureEvent(Temperature(celsius), wait));

    /// <summary>Sets the speed of the part cooling fan, 0 to 1.</summary>
    public Turtle Fan(double speed)
        => speed is >= 0 and <= 1 ? Event(new FanEvent(speed)) : throw new ArgumentOutOfRangeException(nameof(speed), "The fan speed must be 0 to 1.");

    /// <summary>Sets the acceleration of the following moves in mm/s².</summary>
    public Turtle Acceleration(double value) => value <= 1e6
        ? Event(new AccelerationEvent(Positive(value, "The acceleration must be above 0.")))
        : throw new ArgumentOutOfRangeException(nameof(value), "The acceleration must be at most 1000000 mm/s².");

    /// <summary>Sets the fraction of the first material, 0 to 1, for a head that mixes two (M163, M164).</summary>
    public Turtle Mix(double first)
    {
        if (first is not (>= 0 and <= 1)) throw new ArgumentOutOfRangeException(nameof(first), "The fraction must be 0 to 1.");
        Event(new RawEvent("M163 S0 P" + Basics.NumberFormatter.Format(first, 4)));
        Event(new RawEvent("M163 S1 P" + Basics.NumberFormatter.Format(1 - first, 4)));
        return Event(new RawEvent("M164 S0"));
    }

    /// <summary>Changes to a tool, numbered from 0.</summary>
    public Turtle Tool(int number)
    {
        if (number is < 0 or > 255) throw new ArgumentOutOfRangeException(nameof(number), "The tool number must be 0 to 255.");
        if (number == _state.Tags.Tool) return this;
        Event(new ToolEvent(number));
        return Tag(_state.Tags with { Tool = number });
    }

    /// <summary>Writes a comment to the G-code.</summary>
    public Turtle Comment(string text) => Event(new CommentEvent(text ?? throw new ArgumentNullException(nameof(text))));

    /// <summary>Writes a line of G-code as it is.</summary>
    public Turtle Raw(string line) => Event(new RawEvent(line ?? throw new ArgumentNullException(nameof(line))));

    /// <summary>Adds a printer event.</summary>
    public Turtle Event(PrinterEvent what)
    {
        _recorder.Event(what ?? throw new ArgumentNullException(nameof(what)), Position, TravelSpeed);
        return this;
    }

    /// <summary>Puts the following extrusions on a layer at the Z of the turtle. The layer height is in mm; 0 = unknown.</summary>
    public Turtle Layer(int index, double height = 0, string name = "")
    {
        if (index < 0 || !(height >= 0) || double.IsInfinity(height))
            throw new ArgumentOutOfRangeException(nameof(index), "The layer number and layer height must be 0 or more.");
        return Tag(_state.Tags with { Layer = new Layer(index, Z, height, name) });
    }

    /// <summary>Puts the following extrusions on the next layer.</summary>
    public Turtle NextLayer(double height = 0) => Layer(_state.Tags.Layer is { } layer ? layer.Index + 1 : 0, height, _state.Tags.Layer?.Object ?? "");

    /// <summary>Sets the color of the following extrusions, 0xRRGGBB. Null = no color.</summary>
    public Turtle Color(int? rgb)
        => rgb is null or (>= 0 and <= 0xFFFFFF) ? Tag(_state.Tags with { Color = rgb })
            : throw new ArgumentOutOfRangeException(nameof(rgb), "The color must be 0xRRGGBB.");

    /// <summary>Sets the color of the following extrusions by three components from 0 to 255.</summary>
    public Turtle Color(int red, int green, int blue) => Color(Component(red) << 16 | Component(green) << 8 | Component(blue));

    /// <summary>Sets the name of the following extrusions.</summary>
    public Turtle Name(string name) => Tag(_state.Tags with { Name = name ?? throw new ArgumentNullException(nameof(name)) });

    /// <summary>Sets the role of the following extrusions.</summary>
    public Turtle As(Role role) => Tag(_state.Tags with { Role = role });

    private Turtle With(Bead bead)
    {
        _state.Bead = bead;
        return this;
    }

    private Turtle Tag(PathTags tags)
    {
        if (tags != _state.Tags) _state.Tags = tags;
        return this;
    }

    private static int Component(int value)
        => value is >= 0 and <= 255 ? value : throw new ArgumentOutOfRangeException(nameof(value), "A color component must be 0 to 255.");

    private static double Temperature(double celsius)
        => celsius is >= 0 and <= MaxTemperature ? celsius
            : throw new ArgumentOutOfRangeException(nameof(celsius), "The temperature must be 0 to 10000 °C.");

    private static double Positive(double value, string message)
        => value > 0 && !double.IsInfinity(value) ? value : throw new ArgumentOutOfRangeException(nameof(value), message);
}
