namespace Caterpillar.GCode;

/// <summary>Reads layers, roles and objects of the following moves from comments, and the settings and thumbnails of a slicer.</summary>
internal sealed class CommentInterpreter(Machine machine)
{
    private const int MaxSettings = 5000;
    private const int MaxThumbnails = 100;
    private const int LongestRole = 30;
    private readonly SortedDictionary<string, string> _settings = new(StringComparer.Ordinal);
    private readonly List<Thumbnail> _thumbnails = [];
    private readonly MoveRecorder _moves = machine.Moves;
    private readonly DecodeCounters _counters = machine.Counters;
    private bool _hasBareRoles;
    private bool _hasLayerComments;

    /// <summary>True once comments on separate lines name roles. Comments after moves do not count then.</summary>
    public bool HasRoles { get; private set; }

    /// <summary>The settings that the slicer wrote as <c>; key = value</c>.</summary>
    public IReadOnlyDictionary<string, string> Settings => _settings;

    public IReadOnlyList<Thumbnail> Thumbnails => _thumbnails;

    /// <summary>The line of the first comment that begins a layer, or 0.</summary>
    public int FirstLayerLine { get; private set; }

    /// <summary>A comment on a line of its own.</summary>
    public void Line(byte[] text, int start, int end)
    {
        var meaning = CommentReader.Read(text, start, end);
        switch (meaning.Kind)
        {
            case CommentKind.LayerNumber:
                _counters.LayerMarks++;
                BeginLayer(meaning.Number, meaning.Z, 0);
                break;
            case CommentKind.LayerChange:
                _counters.LayerMarks++;
                BeginLayer(null, meaning.Number == 1 ? meaning.Z : double.NaN, meaning.Height);
                break;
            case CommentKind.Z:
                _moves.Layers.SetZ(meaning.Z);
                break;
            case CommentKind.Height:
                _moves.Layers.SetThickness(meaning.Height);
                break;
            case CommentKind.Role:
                HasRoles = true;
                _moves.Role = meaning.Role;
                break;
            case CommentKind.ObjectStart:
                SetObject(meaning.Text);
                break;
            case CommentKind.ObjectEnd:
                SetObject("");
                break;
            case CommentKind.Thumbnail:
                if (_thumbnails.Count < MaxThumbnails && Thumbnail.Read(meaning.Text) is { } thumbnail) _thumbnails.Add(thumbnail);
                break;
            case CommentKind.Setting:
                if (meaning.Text.Length > 0 && _settings.Count < MaxSettings) _settings[meaning.Text] = meaning.Value;
                break;
            default:
                if (!HasRoles || _hasBareRoles) BareRole(text, start, end);
                break;
        }
    }

    /// <summary>Slic3r: a comment after a move names its role.</summary>
    public void AfterMove(byte[] text, int start)
    {
        var end = LineEnds.Find(text, start, text.Length);
        if (CommentReader.WholeRole(text, start, end) is { } role)
        {
            _moves.Role = role;
        }
        else if (!_hasLayerComments && CommentReader.NextLayer(text, start, end) is >= 0 and var layer)
        {
            FirstLayer();
            _moves.Layers.Mark(layer, double.NaN, 0);
        }
    }

    public void SetObject(string name)
    {
        if (name != _moves.Layers.Object) _moves.Layers.SetObject(name);
    }

    // Simplify3D: a comment that is nothing but the name of a role.
    private void BareRole(byte[] text, int start, int end)
    {
        if (end - start > LongestRole || CommentReader.WholeRole(text, start, end) is not { } role) return;
        HasRoles = _hasBareRoles = true;
        _moves.Role = role;
    }

    private void BeginLayer(int? number, double z, double thickness)
    {
        _hasLayerComments = true;
        FirstLayer();
        _moves.BeginLayer(number, z, thickness);
    }

    private void FirstLayer()
    {
        if (_moves.Layers.Marked) return;
        FirstLayerLine = machine.Diagnostics.Line;
        _moves.ForgetLayers();
    }
}
