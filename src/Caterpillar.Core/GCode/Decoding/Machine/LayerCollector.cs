namespace Caterpillar.GCode;

/// <summary>Collects the layers of a file from its comments. Without comments, from the heights of flat extrusions.</summary>
internal sealed class LayerCollector
{
    private readonly List<Draft> _drafts = [];
    private readonly Dictionary<string, int> _ofMark = new(StringComparer.Ordinal);
    private readonly Dictionary<long, int> _byHeight = [];
    private int _current = -1;
    private int _number = -1;
    private double _markZ = double.NaN;
    private double _markThickness;
    private double _previousZ = double.NaN;
    private bool _used;
    private int _marks;
    private double[]? _expected;
    private bool _hasOthers;

    /// <summary>Heights of the flat extrusions that a file without marks will have. Null = unknown.</summary>
    public IEnumerable<double>? Heights { private get; set; }

    /// <summary>False if <see cref="Thicknesses"/> are those of other layers than there are in the end.</summary>
    public bool AreExpected => _expected is null || (!Marked && !_hasOthers && _drafts.Count == _expected.Length);

    /// <summary>Layer of the following moves. −1 = none.</summary>
    public int Current => !AreAlike || _current < 0 ? _current : Numbers is null ? 0 : Numbers[Math.Min(_current, Numbers.Length - 1)];

    /// <summary>True if comments mark the layers.</summary>
    public bool Marked { get; private set; }

    /// <summary>True if all layers are one for the moves. Only comments begin them, not heights.</summary>
    public bool AreAlike { get; set; }

    /// <summary>The number of each layer after <see cref="MergeEmpty"/>, where it is known before. Layers are not alike for the moves, then.</summary>
    public int[]? Numbers { get; set; }

    /// <summary>True if the current layer waits for the height of its first flat extrusion.</summary>
    public bool NeedsZ { get; private set; }

    public string Object { get; private set; } = "";

    /// <summary>
    /// A comment begins a layer with a number. Null = the next number. Two marks without an extrusion between them count as one, except for different numbers
    /// in a file without extrusions.
    /// </summary>
    public void Mark(int? number, double z, double thickness)
    {
        if (!Marked)
        {
            Marked = true;
            _drafts.Clear();
            _byHeight.Clear();
            _current = -1;
        }
        var again = _current >= 0 && !_used;
        if (!again || (number ?? _number) != _number) _ofMark.Clear();
        _number = number ?? (again ? _number : _number + 1);
        _markZ = double.IsNaN(z) && again ? _markZ : z;
        _markThickness = thickness > 0 ? thickness : again ? _markThickness : 0;
        if (!again) _marks++;
        _used = false;
        Select();
    }

    public void SetZ(double z)
    {
        if (!Marked || _used) return;
        // Objects that are printed one after the other begin again at the first layer.
        if (z < _previousZ && _number > 0 && _drafts.Count > 1 && z <= _drafts[0].Z + 1e-6) _number = 0;
        _markZ = z;
        Select();
    }

    public void SetThickness(double thickness)
    {
        if (!Marked || _used || _markThickness > 0 || !(thickness > 0)) return;
        _markThickness = thickness;
        Select();
    }

    public void SetObject(string name)
    {
        Object = name;
        if (Marked) Select();
    }

    /// <summary>An extrusion is printed in a marked layer.</summary>
    public void Printed(double z, bool flat)
    {
        _used = true;
        if (!flat)
        {
            // A spiral: the height where the layer ends.
            _drafts[_current] = _drafts[_current] with { Z = double.IsNaN(_markZ) ? z : _drafts[_current].Z, IsPrinted = true };
            return;
        }
        if (double.IsNaN(_markZ)) _markZ = z;
        _previousZ = _markZ;
        NeedsZ = false;
        _drafts[_current] = _drafts[_current] with { Z = _markZ, IsPrinted = true };
    }

    /// <summary>A flat extrusion at another height than the one before, in a file without marks.</summary>
    public void FlatAt(double z) => _current = LayerAt(z, true);

    /// <summary>
    /// Removes layers with travel moves only: they belong to an object in the same layer or to the next mark. Files without extrusions keep them. Call it once,
    /// after the last move.
    /// </summary>
    /// <returns>The replacement of each layer, or null if all stay.</returns>
    public int[]? MergeEmpty()
    {
        var any = _drafts.Exists(d => d.IsPrinted);
        // They were only expected.
        if (!any && !Marked) _drafts.Clear();
        if (!any) return null;
        var places = InPlaceOf();
        var kept = new List<Draft>(_drafts.Count);
        var numbers = new int[places.Length];
        for (var i = 0; i < places.Length; i++)
        {
            numbers[i] = kept.Count;
            if (places[i] == i) kept.Add(_drafts[i]);
        }
        for (var i = 0; i < places.Length; i++) places[i] = numbers[places[i]];
        Numbers = places;
        if (kept.Count == _drafts.Count) return null;
        _drafts.Clear();
        _drafts.AddRange(kept);
        return places;
    }

    /// <summary>Number of layers that have extrusions, or of all if none has any, each number once. Call it after <see cref="MergeEmpty"/>.</summary>
    public int CountPrinted()
    {
        var any = _drafts.Exists(d => d.IsPrinted);
        return _drafts.Where(d => d.IsPrinted == any).Select(d => d.Number).Distinct().Count();
    }

    /// <summary>Thickness of each printed layer, mm. 0 = not printed. Null if neither the comments so far nor the known heights tell it.</summary>
    public double[]? Thicknesses()
    {
        if (!Marked) return _expected ??= Heights is { } heights ? Expected(heights) : null;
        var all = new double[_drafts.Count];
        for (var i = 0; i < all.Length; i++)
        {
            if (!_drafts[i].IsPrinted) continue;
            if (!(_drafts[i].Thickness > 0)) return null;
            all[i] = Rounded(_drafts[i].Thickness);
        }
        return all;
    }

    public Layer[] ToLayers()
    {
        if (!Marked) return Ranked();
        var layers = new Layer[_drafts.Count];
        double z = 0, below = 0;
        for (var i = 0; i < layers.Length; i++)
        {
            var draft = _drafts[i];
            if (!double.IsNaN(draft.Z) && draft.Z != z)
            {
                below = draft.Z > z ? z : 0;
                z = draft.Z;
            }
            var height = double.IsNaN(draft.Z) ? z : draft.Z;
            var thickness = draft.Thickness > 0 ? draft.Thickness : Math.Max(height - below, 0);
            layers[i] = new Layer(draft.Number, height, Rounded(thickness), draft.Object);
        }
        return layers;
    }

    // The layer of a flat extrusion, or of one that is expected.
    private int LayerAt(double z, bool isPrinted)
    {
        var key = (long)Math.Floor(z * 1000 + 0.5);
        if (!_byHeight.TryGetValue(key, out var layer))
        {
            layer = _drafts.Count;
            _byHeight.Add(key, layer);
            _drafts.Add(new Draft(layer, z, 0, Object, 0, isPrinted));
            _hasOthers |= _expected is not null;
        }
        else if (isPrinted && !_drafts[layer].IsPrinted)
        {
            _hasOthers |= _drafts[layer].Z != z;
            _drafts[layer] = _drafts[layer] with { Z = z, Object = Object, IsPrinted = true };
        }
        return layer;
    }

    // Thickness of each layer, mm, with those that are expected.
    private double[] Expected(IEnumerable<double> heights)
    {
        foreach (var height in heights) LayerAt(height, false);
        return Array.ConvertAll(Ranked(), l => l.Thickness);
    }

    private static double Rounded(double thickness) => Math.Floor(thickness * 1e6 + 0.5) / 1e6;

    // For each layer itself if it has extrusions, else the next after it, or else before it, that has and began with the same mark, or else the last of its
    // object there.
    private int[] InPlaceOf()
    {
        var places = new int[_drafts.Count];
        var last = new Dictionary<string, int>(StringComparer.Ordinal);
        var printed = -1;
        for (var i = places.Length - 1; i >= 0; i--)
        {
            if (i + 1 < places.Length && _drafts[i + 1].Mark != _drafts[i].Mark)
            {
                printed = -1;
                last.Clear();
            }
            if (_drafts[i].IsPrinted) printed = i;
            if (!last.TryGetValue(_drafts[i].Object, out var own)) last.Add(_drafts[i].Object, own = i);
            places[i] = printed >= 0 ? printed : own;
        }
        for (var i = 1; i < places.Length; i++)
        {
            var before = places[i - 1];
            if (_drafts[before].IsPrinted && _drafts[before].Mark == _drafts[i].Mark && !_drafts[places[i]].IsPrinted) places[i] = before;
        }
        return places;
    }

    // Without marks the number of a layer is its rank from below.
    private Layer[] Ranked()
    {
        int[] order = [.. Enumerable.Range(0, _drafts.Count)];
        var z = Array.ConvertAll(order, i => _drafts[i].Z);
        Array.Sort(z, order);
        var layers = new Layer[order.Length];
        for (var rank = 0; rank < order.Length; rank++)
        {
            var thickness = rank == 0 ? z[0] : z[rank] - z[rank - 1];
            layers[order[rank]] = new Layer(rank, z[rank], Math.Max(Rounded(thickness), 0), _drafts[order[rank]].Object);
        }
        return layers;
    }

    private void Select()
    {
        if (!_ofMark.TryGetValue(Object, out var layer))
        {
            layer = _drafts.Count;
            _ofMark.Add(Object, layer);
            _drafts.Add(default);
        }
        _drafts[layer] = new Draft(_number, _markZ, _markThickness, Object, _marks, _drafts[layer].IsPrinted);
        _current = layer;
        NeedsZ = true;
    }

    private readonly record struct Draft(int Number, double Z, double Thickness, string Object, int Mark, bool IsPrinted);
}
