namespace Caterpillar.Planning;

/// <summary>
/// Writes moves and tracks the state: position of the head, current tool, retracted filament of each tool, height of the print. E beyond
/// the balance is deposited, E below it only restores.
/// </summary>
internal sealed class MoveEmitter
{
    // Rounding of sums, too small to print.
    private const double BalanceEpsilon = 1e-9;
    private readonly ToolpathBuilder _builder;
    private readonly PlanRules _rules;
    private readonly PlanReport _counts;
    private readonly ToolpathTool[] _tools;
    private readonly double[] _retracted;
    private readonly Dictionary<Layer, int> _layers = [];
    private Layer? _layer;
    private int _layerIndex = -1;
    private int _nextTaken;

    public MoveEmitter(PlanRules rules, PlanOptions options, Action<Toolpath>? take, PlanReport counts)
    {
        var start = options.Start;
        _rules = rules;
        _counts = counts;
        _tools = Array.ConvertAll(rules.Tools, t => new ToolpathTool(t.VolumePerE));
        Action? followed = options.Follow is { } follow ? () => GiveOn(follow) : null;
        _builder = take is null ? new ToolpathBuilder(MoveSource.Steps, start) { Memory = options.Memory, Filled = followed }
            : new ToolpathBuilder(MoveSource.Steps, start)
            {
                Moves = new(ToolpathBlock.FollowedSize, ToolpathBuilder.FirstSize, ToolpathBlock.FileFor(options.Memory)), Filled = () => GiveOn(take),
            };
        _retracted = new double[rules.Tools.Length];
        IsPlaced = start is not null;
    }

    public Vec3 Position => _builder.Position;

    /// <summary>False until the first move if the start is unknown.</summary>
    public bool IsPlaced { get; private set; }

    public int Tool { get; private set; }

    public ToolRules ToolRules => _rules.Tools[Tool];

    /// <summary>Number of the step that the next moves belong to.</summary>
    public int Source { get; set; } = -1;

    /// <summary>Highest point printed so far, mm; negative infinity before.</summary>
    public double Highest { get; private set; } = double.NegativeInfinity;

    /// <summary>Retracted E of the current tool.</summary>
    public double Retracted => _retracted[Tool];

    /// <summary>True if some E of printing moves only restored earlier retraction.</summary>
    public bool PrintedRetracted { get; private set; }

    /// <summary>Called before each travel move.</summary>
    public Action? BeforeTravel { get; set; }

    /// <summary>Line of the script that the next moves come from; 0 if unknown.</summary>
    public int Line
    {
        set => _builder.Line = value;
    }

    public Toolpath Build(IReadOnlyList<SourceLocation?>? places)
        => _builder.Build(_tools, places);

    public void Event(PrinterEvent what) => _builder.AddEvent(what, Source);

    public void EnterLayer(Layer? layer)
    {
        if (ReferenceEquals(layer, _layer)) return;
        _layer = layer;
        _layerIndex = -1;
        if (layer is not null && !_layers.TryGetValue(layer, out _layerIndex)) _layers.Add(layer, _layerIndex = _builder.AddLayer(layer));
    }

    public void SwitchTool(int tool)
    {
        _builder.AddEvent(new ToolEvent(tool), Source);
        Tool = tool;
        StateTool();
        _counts.ToolChanges++;
    }

    /// <summary>Sets what depends on the tool.</summary>
    public void StateTool()
    {
        if (ToolRules.PressureAdvance is { } advance) Event(new PressureAdvanceEvent(advance, Tool));
    }

    public void Travel(Vec3 to, double speed)
    {
        if (IsPlaced && to == Position) return;
        BeforeTravel?.Invoke();
        if (IsPlaced) _counts.TravelLength += Position.DistanceTo(to);
        Add(to, 0, 0, speed, MoveKind.Travel, Role.Unspecified);
    }

    /// <summary>A segment of a path: its volume in mm³ becomes E; retraction is restored first.</summary>
    public void Print(Vec3 to, double volume, double speed, Role role, Arc? arc)
    {
        var e = ToolRules.EOf(volume);
        var fill = Fill(e);
        if (fill > 0) PrintedRetracted = true;
        Add(to, e, e - fill, speed, e > 0 && fill == e ? MoveKind.MovingDeretract : MoveKind.Print, role, arc);
    }

    /// <summary>The end of a path that is traversed after the extruder has stopped.</summary>
    public void Coast(Vec3 to, double speed, Arc? arc) => Add(to, 0, 0, speed, MoveKind.Travel, Role.Unspecified, arc);

    public void Reached(double z) => Highest = Math.Max(Highest, z);

    public void Retract(double e, double speed)
    {
        _retracted[Tool] += e;
        Add(Position, -e, 0, speed, MoveKind.Retract, Role.Unspecified);
    }

    public void Wipe(Vec3 to, double e, double speed)
    {
        _retracted[Tool] += e;
        Add(to, -e, 0, speed, MoveKind.Wipe, Role.Unspecified);
    }

    /// <summary>Deretractions all retraction: in place, or during a move to a point.</summary>
    public void Restore(Vec3? during, double speed)
    {
        var e = _retracted[Tool];
        if (e <= 0)
        {
            if (during is { } there) Travel(there, speed);
            return;
        }
        _retracted[Tool] = 0;
        _counts.Deretractions++;
        if (during is { } to)
        {
            _counts.TravelLength += Position.DistanceTo(to);
            Add(to, e, 0, speed, MoveKind.MovingDeretract, Role.Unspecified);
        }
        else
        {
            Add(Position, e, 0, speed, MoveKind.Deretract, Role.Unspecified);
        }
    }

    /// <summary>Extrudes in place; retraction is restored first.</summary>
    public void Prime(double e, double speed)
    {
        var fill = Fill(e);
        if (fill > 0)
        {
            _counts.Deretractions++;
            Add(Position, fill, 0, speed, MoveKind.Deretract, Role.Unspecified);
        }
        if (e > fill) Add(Position, e - fill, e - fill, speed, MoveKind.Prime, Role.Unspecified);
    }

    /// <summary>Waits in place.</summary>
    public void Dwell(DwellEvent what)
    {
        _builder.AddEvent(what, Source);
        Add(Position, 0, 0, 0, MoveKind.Dwell, Role.Unspecified);
    }

    /// <summary>A move of another toolpath, whose E may have another unit or another diameter of the filament.</summary>
    public void Copy(Move move, Layer? layer, double? volumePerE, Vec3? turns)
    {
        EnterLayer(layer);
        Tool = move.Tool;
        var scale = volumePerE is { } own && ToolRules.VolumePerE is { } here ? own / here : 1;
        var left = _retracted[Tool] - scale * (move.E - move.Deposited);
        _retracted[Tool] = left > BalanceEpsilon ? left : 0;
        if (move.Kind == MoveKind.Print) Reached(Math.Max(move.Start.Z, move.End.Z));
        _builder.Add(move.End, scale * move.E, scale * move.Deposited, move.Speed, move.Kind, move.Role, _layerIndex, Tool, Source, move.Arc);
        if (turns is { } words) _builder.SetRotary(words);
        IsPlaced = true;
    }

    // The longer it is the rarer: each time takes a copy of the lists of blocks, layers and events.
    private void GiveOn(Action<Toolpath> take)
    {
        if (_builder.Count < _nextTaken) return;
        _nextTaken = _builder.Count + _builder.Count / 16;
        take(_builder.SoFar(_tools));
    }

    private double Fill(double e)
    {
        var fill = Math.Min(e, _retracted[Tool]);
        if (fill <= 0) return 0;
        var left = _retracted[Tool] - fill;
        _retracted[Tool] = left > BalanceEpsilon ? left : 0;
        return fill;
    }

    private void Add(Vec3 to, double e, double deposited, double speed, MoveKind kind, Role role, Arc? arc = null)
    {
        _builder.Add(to, e, deposited, speed, kind, role, _layerIndex, Tool, Source, arc);
        IsPlaced |= kind is MoveKind.Travel or MoveKind.Print or MoveKind.MovingDeretract or MoveKind.Wipe;
    }
}
