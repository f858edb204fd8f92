namespace Caterpillar.Simulation;

/// <summary>Computes <see cref="PrintStatistics"/>.</summary>
internal sealed class StatisticsSums
{
    private readonly Toolpath _toolpath;
    private readonly PrintSetup _setup;
    private readonly Sum[] _roles = Array.ConvertAll((Role[])Enum.GetValues(typeof(Role)), _ => new Sum());
    private readonly SortedDictionary<int, Sum> _tools = [];
    private readonly Sum?[] _layers;

    // Objects that are printed together share their layers: the first entry of each.
    private readonly int[] _firstEntries;
    private readonly Sum _print = new(), _travel = new(), _extruder = new();
    private int _retractions, _flowMove = -1;
    private double _flow, _speed;
    private Bounds _bounds = Bounds.Empty;

    public StatisticsSums(Toolpath toolpath, PrintSetup setup)
    {
        (_toolpath, _setup) = (toolpath, setup);
        _layers = new Sum?[toolpath.Layers.Count];
        _firstEntries = new int[toolpath.Layers.Count];
        for (var i = 1; i < _layers.Length; i++) _firstEntries[i] = _toolpath.Layers[i].Index == _toolpath.Layers[i - 1].Index ? _firstEntries[i - 1] : i;
    }

    /// <summary>The statistics of all blocks.</summary>
    public PrintStatistics ToStatistics(double duration, WaitTimes waits)
    {
        double? mass = 0, cost = 0;
        var all = new Sum();
        var tools = new List<ToolUse>();
        foreach (var pair in _tools)
        {
            var sum = pair.Value;
            all.Volume += sum.Volume;
            all.VolumeUnknown |= sum.VolumeUnknown;
            var material = _setup.OfTool(pair.Key).Material;
            var filament = sum.E * MotionPlanner.FilamentPerE(pair.Key, _toolpath.VolumePerE(pair.Key), _setup);
            all.E += filament;
            // mm³ and g/cm³
            var grams = sum.KnownVolume / 1000 * material.Density;
            mass += grams;
            cost += grams / 1000 * material.CostPerKg;
            tools.Add(new ToolUse(pair.Key, sum.Time, filament, sum.KnownVolume, grams));
        }
        return new PrintStatistics
        {
            Duration = duration,
            Waits = waits,
            PrintTime = _print.Time,
            TravelTime = _travel.Time,
            ExtruderTime = _extruder.Time,
            PrintLength = _print.Length,
            TravelLength = _travel.Length,
            Retractions = _retractions,
            Moves = _toolpath.Count,
            Volume = all.KnownVolume,
            Filament = all.E,
            Mass = mass,
            Cost = cost > 0 ? cost : null,
            GreatestFlow = _flowMove >= 0 ? _flow : null,
            GreatestFlowMove = _flowMove,
            GreatestSpeed = _speed,
            PrintBounds = _bounds,
            Roles = [.. Enumerable.Range(0, _roles.Length).Where(i => _roles[i].Count > 0)
                .Select(i => new RoleTime((Role)i, _roles[i].Time, _roles[i].Length, _roles[i].KnownVolume))],
            Tools = tools,
            Layers = [.. Enumerable.Range(0, _layers.Length).Where(i => _layers[i] is not null)
                .Select(i => new LayerTime(i, _layers[i]!.Start, _layers[i]!.Time, _layers[i]!.Length, _layers[i]!.KnownVolume))],
        };
    }

    /// <summary>The next block, whose motion is final.</summary>
    public void Block(int block, MotionColumns motion)
    {
        var c = _toolpath.Blocks[block].Columns;
        var first = _toolpath.FirstOf(block);
        var at = _toolpath.StartOf(block);
        Sum? tool = null;
        var toolNumber = -1;
        double? factor = null;
        for (var i = 0; i < c.Count; i++)
        {
            var number = first + i;
            var end = new Vec3(c.X[i], c.Y[i], c.Z[i]);
            var isArc = c.TryGetArc(i, out var arc);
            var length = isArc ? arc.Length(at, end) : at.DistanceTo(end);
            var start = motion.StartOf(number);
            var over = motion.StartOf(number + 1);
            var moving = over - start - motion.WaitBefore(number);
            if (tool is null || c.Tool[i] != toolNumber)
            {
                toolNumber = c.Tool[i];
                if (!_tools.TryGetValue(toolNumber, out tool)) _tools.Add(toolNumber, tool = new Sum());
                factor = _toolpath.VolumePerE(toolNumber);
            }
            var kind = c.Kind[i];
            if (kind is MoveKind.Retract or MoveKind.Wipe) _retractions++;
            tool.Add(moving, length, c.Deposited[i], factor);
            var what = kind == MoveKind.Print ? _print : length > 1e-9 ? _travel : _extruder;
            what.Add(moving, length, c.Deposited[i], factor);
            if (length > 1e-9) _speed = Math.Max(_speed, motion.PeakOf(number));
            if (kind == MoveKind.Print)
            {
                _roles[(int)c.Role[i]].Add(moving, length, c.Deposited[i], factor);
                _bounds = isArc ? _bounds.Include(arc.Bounds(at, end)) : _bounds.Include(at).Include(end);
                if (length > 0 && c.Deposited[i] * factor / length * motion.PeakOf(number) is { } flow && flow > _flow) (_flow, _flowMove) = (flow, number);
            }
            if (c.Layer[i] >= 0)
            {
                var layer = _layers[_firstEntries[c.Layer[i]]] ??= new Sum { Start = start };
                layer.Add(over - start, kind == MoveKind.Print ? length : 0, c.Deposited[i], factor);
            }
            at = end;
        }
    }

    private sealed class Sum
    {
        public double Start, Time, Length, E, Volume;
        public bool VolumeUnknown;
        public int Count;

        public double? KnownVolume => VolumeUnknown ? null : Volume;

        public void Add(double time, double length, double e, double? factor)
        {
            Count++;
            Time += time;
            Length += length;
            if (e == 0) return;
            E += e;
            if (factor is { } known) Volume += e * known;
            else VolumeUnknown = true;
        }
    }
}
