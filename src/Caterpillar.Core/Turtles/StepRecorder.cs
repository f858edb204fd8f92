namespace Caterpillar.Turtles;

/// <summary>The tags of a turtle's extrusions besides their beads. A new tag starts a new path.</summary>
internal sealed record PathTags(Role Role, Layer? Layer, int Tool, string Name, int? Color);

/// <summary>Joins moves into paths and travels, in order.</summary>
internal sealed class StepRecorder
{
    private readonly List<Step> _steps = [];
    private readonly List<Vec3> _points = [];
    private readonly List<Bead> _beads = [];
    private readonly List<int> _lines = [];
    private readonly List<Vec3> _travel = [];
    private int _travelLine;
    private bool _uniform = true;
    private PathTags? _tags;
    private double _travelSpeed;

    private long _texts;

    // A point and a bead, with the unused half of growing lists.
    private const long MoveBytes = 100;
    private const long EventBytes = 100;

    public long Moves { get; private set; }

    /// <summary>Estimated memory of the recorded steps, bytes.</summary>
    public long Bytes => MoveBytes * Moves + _texts;

    /// <summary>True if something has been recorded at a position, so that the start is fixed.</summary>
    public bool HasStarted { get; private set; }

    /// <summary>Name of the script, or null.</summary>
    public string? File { get; set; }

    /// <summary>Line of the script that is running, from 1; 0 = no script.</summary>
    public int Line { get; set; }

    public void Print(Vec3 from, Vec3 to, Bead bead, PathTags tags)
    {
        Moves++;
        HasStarted = true;
        if (from == to) return;
        CloseTravel();
        if (_points.Count > 0 && (_points[_points.Count - 1] != from || (!ReferenceEquals(tags, _tags) && tags != _tags))) ClosePath();
        if (_points.Count == 0)
        {
            _points.Add(from);
            _tags = tags;
            _uniform = true;
        }
        // While all beads are equal, one stands for all.
        if (_uniform && _points.Count > 1 && _beads[0] != bead)
        {
            for (var i = _points.Count - 2; i > 0; i--) _beads.Add(_beads[0]);
            _uniform = false;
        }
        _points.Add(to);
        if (!_uniform || _beads.Count == 0) _beads.Add(bead);
        if (Line > 0) _lines.Add(Line);
    }

    public void Travel(Vec3 from, Vec3 to, double speed)
    {
        Moves++;
        StateStart(from, speed);
        if (from == to) return;
        ClosePath();
        if (_travel.Count > 0 && _travelSpeed != speed) CloseTravel();
        _travelSpeed = speed;
        if (_travel.Count == 0) _travelLine = Line;
        _travel.Add(to);
    }

    public void Return(Vec3 from, Vec3 to)
    {
        Moves++;
        HasStarted = true;
        if (from == to) return;
        Close();
        _steps.Add(new TravelStep(to, intent: TravelIntent.Return) { Source = Place(Line) });
    }

    public void Event(PrinterEvent what, Vec3 at, double speed)
    {
        _texts += EventBytes + 2L * (what switch { CommentEvent comment => comment.Text.Length, RawEvent raw => raw.Line.Length, _ => 0 });
        if (what is ExtrudeEvent) StateStart(at, speed);
        Close();
        _steps.Add(new EventStep(what) { Source = Place(Line) });
    }

    /// <summary>Ends the current path. Returns the number of the next step.</summary>
    public int Begin()
    {
        Close();
        return _steps.Count;
    }

    /// <summary>The steps from a number on. Ends the current path.</summary>
    public IReadOnlyList<Step> From(int first)
    {
        Close();
        return _steps.GetRange(first, _steps.Count - first);
    }

    /// <summary>Replaces the steps from a number on.</summary>
    public void Replace(int first, IReadOnlyList<Step> steps)
    {
        _steps.RemoveRange(first, _steps.Count - first);
        _steps.AddRange(steps);
    }

    /// <summary>All steps so far. Further moves continue the last path.</summary>
    public IReadOnlyList<Step> ToSteps()
    {
        var steps = new List<Step>(_steps.Count + 1);
        steps.AddRange(_steps);
        if (_points.Count > 0) steps.Add(MakePath());
        if (_travel.Count > 0) steps.Add(new TravelStep(_travel, _travelSpeed) { Source = Place(_travelLine) });
        return steps.ToArray();
    }

    // The first travel or extrusion states where the turtle started.
    private void StateStart(Vec3 at, double speed)
    {
        if (HasStarted) return;
        HasStarted = true;
        _travel.Add(at);
        _travelLine = Line;
        _travelSpeed = speed;
    }

    private void Close()
    {
        ClosePath();
        CloseTravel();
    }

    private void ClosePath()
    {
        if (_points.Count == 0) return;
        _steps.Add(MakePath());
        _points.Clear();
        _beads.Clear();
        _lines.Clear();
    }

    private void CloseTravel()
    {
        if (_travel.Count == 0) return;
        _steps.Add(new TravelStep(_travel, _travelSpeed) { Source = Place(_travelLine) });
        _travel.Clear();
    }

    private PathStep MakePath()
    {
        var path = PrintPath.Own(_points.ToArray(), _beads.ToArray(), closed: false);
        var tags = _tags!;
        var known = _lines.Count > 0 && _lines.Count == _points.Count - 1;
        return new PathStep(path with { Role = tags.Role, Layer = tags.Layer, Tool = tags.Tool, Name = tags.Name, Color = tags.Color })
        {
            Source = known ? Place(_lines[0]) : null,
            Lines = known ? _lines.ToArray() : null,
        };
    }

    private SourceLocation? Place(int line) => line > 0 ? new SourceLocation(File, line) : null;
}
