namespace Caterpillar.Drawings;

/// <summary>
/// Settings that vary along a curve. Polylines have one value per vertex. Other curves have values at equal steps of length. Between them, values vary
/// linearly. Missing columns are null.
/// </summary>
public sealed class PointValues
{
    private readonly double[]?[] _columns;

    /// <exception cref="ArgumentException">The columns have different lengths, or one has fewer than two values.</exception>
    public PointValues(
        IEnumerable<double>? areas = null, IEnumerable<double>? widths = null, IEnumerable<double>? heights = null, IEnumerable<double>? speeds = null,
        IEnumerable<double>? flows = null)
    {
        _columns = [areas?.ToArray(), widths?.ToArray(), heights?.ToArray(), speeds?.ToArray(), flows?.ToArray()];
        foreach (var column in _columns)
        {
            if (column is null) continue;
            if (Count != 0 && Count != column.Length) throw new ArgumentException("All columns need the same number of values.");
            if (column.Length < 2) throw new ArgumentException("There must be at least two values along a curve.");
            Count = column.Length;
        }
    }

    /// <summary>Number of values in each column; 0 = no columns.</summary>
    public int Count { get; }

    /// <summary>Cross-sections of the extrusion, mm².</summary>
    public IReadOnlyList<double>? Areas => _columns[0];

    /// <summary>Widths of the extrusion, mm.</summary>
    public IReadOnlyList<double>? Widths => _columns[1];

    /// <summary>Heights of the extrusion, mm.</summary>
    public IReadOnlyList<double>? Heights => _columns[2];

    /// <summary>Speeds of the head, mm/s.</summary>
    public IReadOnlyList<double>? Speeds => _columns[3];

    /// <summary>Flow ratios of width × height.</summary>
    public IReadOnlyList<double>? Flows => _columns[4];
}
