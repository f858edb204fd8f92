namespace Caterpillar.Curved;

/// <summary>
/// Chooses which faces become parts of which layers. Thickness and slope bound the differences of heights of layers at neighboring nodes; where heights are
/// given, those bounds give the least and the greatest height of every layer at every node, and there are layers if and only if none of the given heights is
/// outside of them (difference constraints). Largest first: the piece and the layer that gain the largest visible area, until little is gained.
/// </summary>
internal sealed class SmoothPlan
{
    // mm², and of the grid: smaller gains are not worth their time.
    private const double LeastArea = 1;
    private const double LeastShare = 0.001;
    private readonly SlopeGrid _grid;
    private readonly LayerRules _rules;
    private readonly TopSamples _samples;

    // The layers that each sample may be in. Empty for what is done.
    private readonly (int From, int To)[] _spans;
    private readonly List<FixedLayer> _layers = [];

    // What each layer gains, piece by piece; and where those of the piece of each sample begin.
    private readonly int[] _gains;
    private readonly int[] _rows;
    private readonly int _stride;

    public SmoothPlan(TopSamples samples, SlopeGrid grid, LayerRules rules)
    {
        (_samples, _grid, _rules) = (samples, grid, rules);
        _spans = samples.All.Select(s => (1 + rules.Fewest(s.Height - rules.First), 1 + rules.MostLayers(s.Height - rules.First))).ToArray();
        for (var i = 0; i < _spans.Length; i++) _spans[i].From = Math.Max(1, _spans[i].From);
        _stride = _spans.Aggregate(0, (most, span) => Math.Max(most, span.To)) + 2;
        var numbers = new Dictionary<int, int>();
        _rows = new int[_spans.Length];
        for (var i = 0; i < _rows.Length; i++)
        {
            var piece = samples.PieceOf(i);
            if (!numbers.ContainsKey(piece)) numbers.Add(piece, numbers.Count);
            _rows[i] = numbers[piece] * _stride;
        }
        _gains = new int[numbers.Count * _stride];
    }

    /// <summary>The layers that are given at some nodes, from below, each number once.</summary>
    public IReadOnlyList<FixedLayer> Layers => _layers;

    /// <summary>Slopes of faces in the layers, the steepest of them as a tangent. 0 if only level ones are.</summary>
    public double Steepest { get; private set; }

    /// <summary>
    /// Direction of solid infill, degrees, with which the lines of the largest piece run down its slope: across it, they would be steps themselves.
    /// </summary>
    public double Angle { get; private set; }

    /// <summary>Visible samples that slope and are in no layer.</summary>
    public List<int> LeftOut { get; } = [];

    /// <summary>Chooses.</summary>
    /// <exception cref="OperationCanceledException">The call was canceled.</exception>
    public void Run(CancellationToken cancel)
    {
        var done = new bool[_spans.Length];
        foreach (var visible in new[] { true, false })
        {
            while (Best(done, visible) is var (piece, layer) && layer > 0)
            {
                cancel.ThrowIfCancellationRequested();
                Take(piece, layer, done);
            }
        }
        _layers.Sort((a, b) => a.Number.CompareTo(b.Number));
        if (Steepest <= TopSamples.LevelSlope) Steepest = 0;
        for (var s = 0; s < done.Length; s++)
        {
            if (!done[s] && _samples.All[s] is { Visible: true, Slope: > TopSamples.LevelSlope }) LeftOut.Add(s);
        }
    }

    private void Take(int piece, int layer, bool[] done)
    {
        var chosen = new List<int>();
        for (var s = 0; s < done.Length; s++)
        {
            if (!done[s] && _rows[s] == piece * _stride && _spans[s].From <= layer && layer <= _spans[s].To) chosen.Add(s);
        }
        if (_layers.Count == 0) Angle = DownSlope(chosen) - (layer % 2 == 0 ? 90 : 0);
        var places = _samples.WithEdges(chosen).Where(p => Allows(p.Node, p.Height, layer));
        var made = FixedLayer.Of(layer, places, _grid, _rules.Slope);
        foreach (var s in chosen)
        {
            var sample = _samples.All[s];
            var (from, to) = _spans[s];
            // What is too far above or below the others may be in another layer.
            if (sample.Height > made.Upper[sample.Node] + 1e-9) _spans[s] = (layer + 1, to);
            else if (sample.Height < made.Lower[sample.Node] - 1e-9) _spans[s] = (from, layer - 1);
            if (_spans[s] != (from, to)) continue;
            done[s] = true;
            if (sample.Visible) Steepest = Math.Max(Steepest, sample.Slope);
        }
        var same = _layers.FindIndex(l => l.Number == layer);
        if (same < 0) _layers.Add(made);
        else _layers[same] = FixedLayer.Of(layer, _layers[same].Places.Concat(made.Places), _grid, _rules.Slope);
        Narrow(made);
    }

    private double DownSlope(List<int> samples)
    {
        double along = 0, across = 0;
        foreach (var s in samples)
        {
            var sample = _samples.All[s];
            along += sample.ByX * sample.ByX - sample.ByY * sample.ByY;
            across += 2 * sample.ByX * sample.ByY;
        }
        return along == 0 && across == 0 ? new PrintSettings().SolidInfillAngle : Basics.Angle.Atan2(across, along) / 2;
    }

    // The piece and the layer that gain most of what is seen, or else of the rest; of layers that gain almost as much the one that
    // bends least.
    private (int Piece, int Layer) Best(bool[] done, bool visible)
    {
        Array.Clear(_gains, 0, _gains.Length);
        for (var s = 0; s < done.Length; s++)
        {
            if (done[s] || _spans[s].From > _spans[s].To || _samples.All[s].Visible != visible) continue;
            _gains[_rows[s] + _spans[s].From]++;
            _gains[_rows[s] + _spans[s].To + 1]--;
        }
        var most = 0;
        for (var i = 1; i < _gains.Length; i++)
        {
            // The last of each row is 0.
            _gains[i] += _gains[i - 1];
            most = Math.Max(most, _gains[i]);
        }
        if (most < Math.Max(LeastArea / (_grid.Cell * _grid.Cell), LeastShare * _grid.Count)) return default;
        var (best, least) = (0, double.PositiveInfinity);
        for (var i = 0; i < _gains.Length; i++)
        {
            if (_gains[i] < 0.99 * most) continue;
            var bend = Bend(i / _stride, i % _stride, done);
            // Lines change their direction from layer to layer.
            if (_layers.Count > 0 && (i % _stride - _layers[0].Number) % 2 != 0) bend += 1e6;
            if (bend < least) (best, least) = (i, bend);
        }
        return (best / _stride, best % _stride);
    }

    private double Bend(int piece, int layer, bool[] done)
    {
        var sum = 0.0;
        for (var s = 0; s < done.Length; s++)
        {
            if (!done[s] && _rows[s] == piece * _stride && _spans[s].From <= layer && layer <= _spans[s].To)
                sum += Math.Abs(_samples.All[s].Height - _rules.Height(layer));
        }
        return sum;
    }

    private bool Allows(int node, double height, int layer)
        => layer >= 1 && height <= _rules.First + _rules.Upper(layer - 1) + 1e-9 && height >= _rules.First + _rules.Lower(layer - 1) - 1e-9
            && _layers.TrueForAll(l => height <= l.Upper[node] + _rules.Upper(layer - l.Number) + 1e-9
                && height >= l.Lower[node] + _rules.Lower(layer - l.Number) - 1e-9);

    private void Narrow(FixedLayer layer)
    {
        for (var s = 0; s < _spans.Length; s++)
        {
            var sample = _samples.All[s];
            var (from, to) = _spans[s];
            _spans[s] = (Math.Max(from, layer.Number + _rules.Fewest(sample.Height - layer.Upper[sample.Node])),
                Math.Min(to, layer.Number + _rules.MostLayers(sample.Height - layer.Lower[sample.Node])));
        }
    }
}
