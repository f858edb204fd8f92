using Caterpillar.Toolpaths;

namespace Caterpillar.Turtles;

// The printer: pen, bead, speed, events and tags.
public sealed partial class Turtle
{
    // Far above all machines, and far below what G-code can write.
    private const double MaxSpeed = 1e6;
    private const double MaxTemperature = 10_000;

    /// <summary>True while moves deposit an extrusion.</summary>
    public bool IsPenDown => _state.PenDown;

    /// <summary>The extrusion that moves with the pen down deposit.</summary>
    public Bead Bead => _state.Bead;

    /// <summary>Diameter of the filament, mm.</summary>
    public double FilamentDiameter => _options.Extrusion.FilamentDiameter;

    /// <summary>mm of filament per mm of path.</summary>
    public double Density => _options.Extrusion.FactorOfArea(Bead.Area);

    /// <summary>mm/s of moves with the pen down.</summary>
    public double Speed => Bead.Speed;

    /// <summary>mm/min of moves with the pen down.</summary>
    public double Rate => Bead.Speed * 60;

    /// <summary>mm/s of moves that deposit nothing: as fast as printing unless set.</summary>
    public double TravelSpeed => _state.TravelSpeed > 0 ? _state.TravelSpeed : _state.Bead.Speed;

    /// <summary>The following moves deposit nothing. Nothing is retracted: planning does that.</summary>
    public Turtle PenUp() => Pen(false);

    /// <summary>The following moves deposit an extrusion.</summary>
    public Turtle PenDown() => Pen(true);

    /// <summary>Pen up or down.</summary>
    public Turtle Pen(bool down)
    {
        _state.PenDown = down;
        return this;
    }

    /// <summary>
    /// Extrusion as mm of filament per mm of path (ExtruderTurtle: 0.01 to 0.10, 0.03 is standard for a 0.4 mm nozzle and 0.2 mm layers, 0.05 is its default).
    /// </summary>
    public Turtle SetDensity(double filamentPerMm)
    {
        _state.Bead = new Bead(_options.Extrusion.AreaOfFactor(filamentPerMm), 0, _state.Bead.Speed);
        return this;
    }

    /// <summary>Extrusion as cross-section of the extrusion in mm² (Kanada), and its height if known.</summary>
    public Turtle SetArea(double area, double height = 0)
    {
        _state.Bead = new Bead(area, height, _state.Bead.Speed);
        return this;
    }

    /// <summary>Extrusion as width × height × multiplier, mm (Caterpillar); the area is that of the shape, or of the shape of the options.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A value is negative or not finite, or a stadium is narrower than high.</exception>
    public Turtle SetBead(double width, double height, double multiplier = 1, BeadShape? shape = null)
    {
        _state.Bead = Bead.FromWidth(width, height, multiplier, _state.Bead.Speed, shape ?? _options.Shape);
        return this;
    }

    /// <summary>Sets the bead; one without a speed keeps the current speed.</summary>
    public Turtle SetBead(Bead bead)
    {
        _state.Bead = bead.Speed > 0 ? bead : bead.WithSpeed(_state.Bead.Speed);
        return this;
    }

    /// <summary>Speed in mm/min, as in G-code (ExtruderTurtle; the "mm/s" of its paper is an erratum).</summary>
    public Turtle SetRate(double mmPerMinute) => SetSpeed(mmPerMinute / 60);

    /// <summary>Speed in mm/s (Kanada).</summary>
    public Turtle SetSpeed(double mmPerSecond)
    {
        if (mmPerSecond > MaxSpeed) throw new ArgumentOutOfRangeException(nameof(mmPerSecond), "A speed must be up to 1000000 mm/s.");
        _state.Bead = _state.Bead.WithSpeed(Positive(mmPerSecond, "A speed must be above 0."));
        return this;
    }

    /// <summary>Speed in mm/s of moves that deposit nothing; 0 makes them as fast as printing.</summary>
    public Turtle SetTravelSpeed(double mmPerSecond)
    {
        if (!(mmPerSecond is >= 0 and <= MaxSpeed))
            throw new ArgumentOutOfRangeException(nameof(mmPerSecond), "A travel speed must be 0 to 1000000 mm/s.");
        _state.TravelSpeed = mmPerSecond;
        return this;
    }

    /// <summary>Extrudes in place, with the pen up or down; negative retracts. mm of filament.</summary>
    public Turtle Extrude(double filament)
    {
        if (double.IsNaN(filament) || double.IsInfinity(filament)) throw NotFinite();
        return Event(new ExtrudeEvent(_options.Extrusion.AreaOfFactor(filament) / _options.Extrusion.Multiplier, _state.Bead.Speed));
    }

    /// <summary>Waits, in milliseconds.</summary>
    public Turtle Dwell(double milliseconds)
    {
        if (!(milliseconds is >= 0 and <= 1e9)) throw new ArgumentOutOfRangeException(nameof(milliseconds), "A dwell must be 0 to 1000000000 ms.");
        return Event(new DwellEvent(milliseconds / 1000));
    }

    /// <summary>Waits for the user.</summary>
    public Turtle Pause(string message = "") => Event(new PauseEvent(message));

    /// <summary>Nozzle temperature in °C (0 = off); waits until it is reached by default.</summary>
    public Turtle NozzleTemperature(double celsius, bool wait = true) => Event(new NozzleTemperatureEvent(Temperature(celsius), wait));

    /// <summary>Bed temperature in °C (0 = off); waits until it is reached by default.</summary>
    public Turtle BedTemperature(double celsius, bool wait = true) => Event(new BedTemperatureEvent(Temperature(celsius), wait));

    /// <summary>Component cooling fan, 0 to 1.</summary>
    public Turtle Fan(double speed)
        => speed is >= 0 and <= 1 ? Event(new FanEvent(speed)) : throw new ArgumentOutOfRangeException(nameof(speed), "A fan speed must be 0 to 1.");

    /// <summary>Acceleration of the following moves in mm/s².</summary>
    public Turtle Acceleration(double value) => value <= 1e6
        ? Event(new AccelerationEvent(Positive(value, "An acceleration must be above 0.")))
        : throw new ArgumentOutOfRangeException(nameof(value), "An acceleration must be up to 1000000 mm/s².");

    /// <summary>Share of the first material, 0 to 1, of a head that mixes two (M163, M164).</summary>
    public Turtle Mix(double first)
    {
        if (first is not (>= 0 and <= 1)) throw new ArgumentOutOfRangeException(nameof(first), "A share must be 0 to 1.");
        Event(new RawEvent("M163 S0 P" + Basics.NumberFormatter.Format(first, 4)));
        Event(new RawEvent("M163 S1 P" + Basics.NumberFormatter.Format(1 - first, 4)));
        return Event(new RawEvent("M164 S0"));
    }

    /// <summary>Changes to another tool, from 0.</summary>
    public Turtle Tool(int number)
    {
        if (number is < 0 or > 255) throw new ArgumentOutOfRangeException(nameof(number), "A tool number must be 0 to 255.");
        if (number == _state.Tags.Tool) return this;
        Event(new ToolEvent(number));
        return Tag(_state.Tags with { Tool = number });
    }

    /// <summary>A comment in the G-code.</summary>
    public Turtle Comment(string text) => Event(new CommentEvent(text ?? throw new ArgumentNullException(nameof(text))));

    /// <summary>A line of G-code written as it is.</summary>
    public Turtle Raw(string line) => Event(new RawEvent(line ?? throw new ArgumentNullException(nameof(line))));

    /// <summary>Any event.</summary>
    public Turtle Event(PrinterEvent what)
    {
        _recorder.Event(what ?? throw new ArgumentNullException(nameof(what)), Position, TravelSpeed);
        return this;
    }

    /// <summary>The following extrusions belong to a layer at the height of the turtle.</summary>
    public Turtle Layer(int index, double thickness = 0, string name = "")
    {
        if (index < 0 || !(thickness >= 0)
            || double.IsInfinity(thickness))
        {
            throw new ArgumentOutOfRangeException(nameof(index), "A layer needs a number and a thickness of 0 or more.");
        }
        return Tag(_state.Tags with { Layer = new Layer(index, Z, thickness, name) });
    }

    /// <summary>The following extrusions belong to the next layer.</summary>
    public Turtle NextLayer(double thickness = 0) => Layer(_state.Tags.Layer is { } layer ? layer.Index + 1 : 0, thickness, _state.Tags.Layer?.Object ?? "");

    /// <summary>The following extrusions have a color, 0xRRGGBB, or none.</summary>
    public Turtle Color(int? rgb)
        => rgb is null or (>= 0 and <= 0xFFFFFF) ? Tag(_state.Tags with { Color = rgb })
            : throw new ArgumentOutOfRangeException(nameof(rgb), "A color must be 0xRRGGBB.");

    /// <summary>The following extrusions have a color of three components, 0 to 255.</summary>
    public Turtle Color(int red, int green, int blue) => Color(Component(red) << 16 | Component(green) << 8 | Component(blue));

    /// <summary>The following extrusions have a name.</summary>
    public Turtle Name(string name) => Tag(_state.Tags with { Name = name ?? throw new ArgumentNullException(nameof(name)) });

    /// <summary>The following extrusions have a role.</summary>
    public Turtle As(Role role) => Tag(_state.Tags with { Role = role });

    private Turtle Tag(PathTags tags)
    {
        if (tags != _state.Tags) _state.Tags = tags;
        return this;
    }

    private static int Component(int value)
        => value is >= 0 and <= 255 ? value : throw new ArgumentOutOfRangeException(nameof(value), "A color component must be 0 to 255.");

    private static double Temperature(double celsius)
        => celsius is >= 0 and <= MaxTemperature ? celsius
            : throw new ArgumentOutOfRangeException(nameof(celsius), "A temperature must be 0 to 10000 °C.");

    private static double Positive(double value, string message)
        => value > 0 && !double.IsInfinity(value) ? value : throw new ArgumentOutOfRangeException(nameof(value), message);
}
