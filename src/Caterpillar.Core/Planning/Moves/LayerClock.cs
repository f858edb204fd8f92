namespace Caterpillar.Planning;

/// <summary>
/// The time that each layer takes, at the speeds asked for: paths at one height that follow each other, of all objects there. Paths without a layer take part
/// in none.
/// </summary>
internal sealed class LayerClock
{
    private readonly int[] _runOf;
    private readonly double[] _times;
    private readonly Bounds[] _boxes;

    public LayerClock(OrderedStep[] steps, PlanRules rules)
    {
        _runOf = new int[steps.Length];
        _times = new double[steps.Length];
        _boxes = new Bounds[steps.Length];
        var run = -1;
        double? height = null;
        Vec3? at = null;
        double SpeedOf(PrintPath path, int segment) => rules.SpeedOf(path, path.BeadOf(segment), path.Layer!.Index == 0);
        for (var i = 0; i < steps.Length; i++)
        {
            if (steps[i].Path is not { } path)
            {
                _runOf[i] = run;
                continue;
            }
            if (path.Layer is not { } layer) height = null;
            else if (height is not { } same || Math.Abs(same - layer.Z) > 1e-9) (run, height, at) = (run + 1, layer.Z, null);
            _runOf[i] = height is null ? -1 : run;
            if (height is null) continue;
            if (_boxes[run].Equals(default(Bounds))) _boxes[run] = Bounds.Empty;
            _boxes[run] = _boxes[run].Include(path.Bounds);
            if (at is { } from) _times[run] += from.DistanceTo(path.Start) / rules.Settings.TravelSpeed;
            _times[run] += SlowDown.TimeOf(path, SpeedOf);
            at = path.End;
        }
    }

    /// <summary>Number of steps.</summary>
    public int Count => _times.Length;

    /// <summary>Seconds of the layer of a step; infinite if it has none.</summary>
    public double TimeOf(int step) => _runOf[step] < 0 ? double.PositiveInfinity : _times[_runOf[step]];

    /// <summary>What the layer of a step covers.</summary>
    public Bounds BoxOf(int step) => _boxes[_runOf[step]];

    /// <summary>Whether a step belongs to another layer than the one before it, which had one.</summary>
    public bool Changes(int step) => step > 0 && _runOf[step - 1] >= 0 && _runOf[step] != _runOf[step - 1];
}
