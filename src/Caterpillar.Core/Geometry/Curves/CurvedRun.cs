namespace Caterpillar.Geometry;

/// <summary>
/// Divides a smooth run of curved spans. The requests become a density of segments along the length (one by the distance, √(κ/8t) for a chord tolerance t at
/// curvature κ, κ/α for a turn α); equal steps of its integral give the points. Every segment is then measured and halved if it fails.
/// </summary>
internal sealed class CurvedRun(List<CurveSpan> spans, SubdivisionOptions options, int mostPoints, CancellationToken cancel)
{
    // Shares of the request for which the density is computed and which samples may reach: between samples the chord error can be 2 % larger.
    private const double Planned = 0.93;
    private const double Measured = 0.97;
    private const double MaxDensity = 1e4;

    private readonly ArcLength _length = new(spans);
    private readonly double _longest
        = options.MaxLength > 0 && (options.Distance == 0 || options.MaxLength < options.Distance) ? options.MaxLength : options.Distance;

    private readonly List<(double S, double Amount)> _table = [];
    private readonly List<Vec3> _points = [];
    private int _pulse;

    // Of a length; a circle would need more points than the limit.
    private const double Precision = 1e-14;

    private bool Adapts => options.ChordTolerance > 0 || options.Angle > 0;

    /// <summary>The points after the start of the run, with its end.</summary>
    public List<Vec3> Divide()
    {
        if (options.MinLength == 0 && IsHopeless()) throw new SubdivisionLimitException();
        var stations = Adapts ? ByDensity() : ByLength();
        var last = new Station(0, 0, 0);
        foreach (var s in stations)
        {
            if (s <= last.S || s >= _length.Total) continue;
            var (leaf, u) = _length.Locate(s);
            var next = new Station(s, leaf, u);
            Add(last, next, 0);
            last = next;
        }
        Add(last, new Station(_length.Total, _length.LeafCount - 1, 1), 0);
        return _points;
    }

    // Chords cannot be nearer to the curve than its points are exact, nor turn less than the ends of its parts.
    private bool IsHopeless()
    {
        if (options.ChordTolerance > 0 && options.ChordTolerance < Precision * _length.Total) return true;
        if (!(options.Angle > 0)) return false;
        var turn = 0.0;
        for (var i = 0; i < _length.LeafCount; i++)
        {
            var leaf = _length.LeafAt(i);
            var span = _length.Spans[leaf.Span];
            turn += CurveSpan.TurnDegrees(Tangent(span, leaf.From), Tangent(span, leaf.To));
        }
        return turn > options.Angle * mostPoints;
    }

    // Lengths along the run at which it is cut, without its ends.
    private double[] ByLength()
    {
        var total = _length.Total;
        var step = Math.Max(_longest, options.MinLength);
        if (!options.EqualDivision)
        {
            var whole = Count(total / step) - 1;
            // A remainder below the minimum is added to the previous segment.
            if (whole > 0 && total - whole * step < options.MinLength * (1 - 1e-9)) whole--;
            return Stations(Math.Max(whole, 0), k => k * step);
        }
        var count = Count(total / step);
        if (options.MinLength > 0) count = Math.Min(count, AtLeast(total / options.MinLength));
        count = AtLeastAround(count);
        return Stations(count - 1, k => total * k / count);
    }

    private double[] ByDensity()
    {
        BuildTable();
        var total = _table[_table.Count - 1].Amount;
        if (!options.EqualDivision)
        {
            var whole = Count(total) - 1;
            return Stations(Math.Max(whole, 0), k => LengthOf(k));
        }
        var count = Count(total);
        // With the density at its cap, rounding up would make segments shorter than the minimum.
        if (options.MinLength > 0 && count > 1 && options.MinLength * count > _length.Total) count = AtLeast(_length.Total / options.MinLength);
        count = AtLeastAround(count);
        return Stations(count - 1, k => LengthOf(total * k / count));
    }

    // A loop needs at least a triangle.
    private int AtLeastAround(int count)
    {
        var parts = _length.Spans;
        return parts[0].Start.DistanceTo(parts[parts.Count - 1].End) <= Curve.JoinTolerance ? Math.Max(count, 3) : count;
    }

    private int Count(double amount)
        => amount <= mostPoints ? (int)Math.Max(Math.Ceiling(amount - 1e-9), 1) : throw new SubdivisionLimitException();

    private int AtLeast(double amount) => (int)Math.Min(Math.Max(Math.Floor(amount + 1e-9), 1), mostPoints);

    private double[] Stations(int count, Func<int, double> at)
    {
        var stations = new double[count];
        for (var i = 0; i < count; i++)
        {
            Pulse();
            stations[i] = at(i + 1);
        }
        return stations;
    }

    private double Density(CurveSpan span, double u)
    {
        var density = _longest > 0 ? 1 / _longest : 0;
        var curvature = Math.Min(span.Curvature(u), 1e12);
        if (options.ChordTolerance > 0) density = Math.Max(density, Math.Sqrt(curvature / (8 * Planned * options.ChordTolerance)));
        if (options.Angle > 0) density = Math.Max(density, curvature / Basics.Angle.ToRadians(Measured * options.Angle));
        return Math.Min(density, options.MinLength > 0 ? Math.Min(1 / options.MinLength, MaxDensity) : MaxDensity);
    }

    // The integral of the density over the length, as a table that is linear between its entries.
    private void BuildTable()
    {
        _table.Add((0, 0));
        for (var i = 0; i < _length.LeafCount; i++)
        {
            var (number, from, to, start, length) = _length.LeafAt(i);
            var span = _length.Spans[number];
            if (span.Arc is not null)
            {
                Append(start + length, length * Density(span, 0.5));
                continue;
            }
            const int Parts = 8;
            for (var k = 0; k < Parts; k++)
            {
                Integrate(span, SampleAt(span, from + (to - from) * k / Parts), SampleAt(span, from + (to - from) * (k + 1) / Parts), 0);
            }
            // Lengths of the table follow the trapezoids; the leaf ends exactly.
            _table[_table.Count - 1] = (start + length, _table[_table.Count - 1].Amount);
        }
    }

    // Long work hears a wish to stop.
    private void Pulse()
    {
        if ((++_pulse & 0xFFF) == 0) cancel.ThrowIfCancellationRequested();
    }

    private void Integrate(CurveSpan span, Sample a, Sample b, int depth)
    {
        Pulse();
        var middle = SampleAt(span, 0.5 * (a.U + b.U));
        var mean = 0.5 * (a.Density + b.Density);
        if (depth < 10 && Math.Abs(middle.Density - mean) > 0.02 * (middle.Density + mean) && (b.U - a.U) * middle.Speed * middle.Density > 0.01)
        {
            Integrate(span, a, middle, depth + 1);
            Integrate(span, middle, b, depth + 1);
            return;
        }
        // Simpson's rule for the length and for the amount of each half.
        var half = 0.5 * (b.U - a.U);
        Append(Last + half * 0.5 * (a.Speed + middle.Speed), half * 0.5 * (a.Speed * a.Density + middle.Speed * middle.Density));
        Append(Last + half * 0.5 * (middle.Speed + b.Speed), half * 0.5 * (middle.Speed * middle.Density + b.Speed * b.Density));
    }

    private double Last => _table[_table.Count - 1].S;

    private Sample SampleAt(CurveSpan span, double u) => new(u, Density(span, u), span.Derivatives(u).First.Length);

    private void Append(double s, double amount)
    {
        var sum = _table[_table.Count - 1].Amount + amount;
        // No need to look at the rest.
        if (sum > mostPoints) throw new SubdivisionLimitException();
        _table.Add((s, sum));
    }

    private double LengthOf(double amount)
    {
        var high = Search.First(1, _table.Count - 1, (_table, amount), static (s, i) => s._table[i].Amount > s.amount);
        var (s, reached) = _table[high - 1];
        var size = _table[high].Amount - reached;
        return size > 0 ? s + (_table[high].S - s) * Math.Min(1, (amount - reached) / size) : s;
    }

    private void Add(Station from, Station to, int depth)
    {
        Pulse();
        if (_points.Count > mostPoints) throw new SubdivisionLimitException();
        if (depth < 24 && (to.S - from.S) * 0.5 >= Math.Max(options.MinLength, 1e-6) && Fails(from, to))
        {
            var s = 0.5 * (from.S + to.S);
            var (leaf, u) = _length.Locate(s);
            var middle = new Station(s, leaf, u);
            Add(from, middle, depth + 1);
            Add(middle, to, depth + 1);
            return;
        }
        _points.Add(PointOf(to));
    }

    private bool Fails(Station from, Station to)
        => (_longest > 0 && to.S - from.S > _longest * (1 + 1e-9)) || (Adapts && (Deviates(from, to) || Turns(from, to)));

    // Samples in every leaf, within which the speed changes little, then a search around the farthest one.
    private bool Deviates(Station from, Station to)
    {
        if (options.ChordTolerance == 0) return false;
        const int Samples = 6;
        var limit = Measured * options.ChordTolerance;
        Vec3 start = PointOf(from), end = PointOf(to);
        foreach (var (span, a, b) in Parts(from, to))
        {
            var step = (b - a) / Samples;
            var (largest, at) = (0.0, a);
            for (var k = 0; k <= Samples; k++)
            {
                var distance = span.Point(a + step * k).DistanceToSegment(start, end);
                if (distance > largest) (largest, at) = (distance, a + step * k);
            }
            if (largest > limit) return true;
            if (largest < 0.5 * limit) continue;
            for (var width = step / 2; width > step / 20; width /= 2)
            {
                var (left, right) = (Math.Max(a, at - width), Math.Min(b, at + width));
                var (dl, dr) = (span.Point(left).DistanceToSegment(start, end), span.Point(right).DistanceToSegment(start, end));
                if (dl > largest) (largest, at) = (dl, left);
                if (dr > largest) (largest, at) = (dr, right);
            }
            if (largest > limit) return true;
        }
        return false;
    }

    private bool Turns(Station from, Station to)
    {
        if (options.Angle == 0) return false;
        const int Samples = 6;
        var turn = 0.0;
        Vec3? last = null;
        foreach (var (span, a, b) in Parts(from, to))
        {
            for (var k = 0; k <= Samples; k++)
            {
                var tangent = Tangent(span, a + (b - a) * k / Samples);
                if (last is { } before) turn += CurveSpan.TurnDegrees(before, tangent);
                last = tangent;
                if (turn > options.Angle) return true;
            }
        }
        return false;
    }

    // The pieces of spans between two stations, leaf by leaf, each from one u to another.
    private IEnumerable<(CurveSpan Span, double From, double To)> Parts(Station from, Station to)
    {
        for (var number = from.Leaf; number <= to.Leaf; number++)
        {
            var leaf = _length.LeafAt(number);
            var a = number == from.Leaf ? from.U : leaf.From;
            var b = number == to.Leaf ? to.U : leaf.To;
            if (b > a) yield return (_length.Spans[leaf.Span], a, b);
        }
    }

    private static Vec3 Tangent(CurveSpan span, double u) => u <= 0 ? span.StartTangent : u >= 1 ? span.EndTangent : span.Derivatives(u).First.Unit();

    private Vec3 PointOf(Station station) => _length.Spans[_length.LeafAt(station.Leaf).Span].Point(station.U);

    // Density of segments and speed at a parameter of a span.
    private readonly record struct Sample(double U, double Density, double Speed);

    private readonly record struct Station(double S, int Leaf, double U);
}
