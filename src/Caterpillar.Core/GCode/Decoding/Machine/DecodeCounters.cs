namespace Caterpillar.GCode;

/// <summary>Running sums of a decode report, in coordinates as written.</summary>
internal sealed class DecodeCounters
{
    /// <summary>Lines with a G, M or T command.</summary>
    public int Commands;
    public int Prints;
    public int Travels;
    public int TravelsWithRetraction;
    public int PrintArcs;
    public int TravelArcs;
    public int PrintsG0;
    public int TravelsG1;
    public int Rapids;
    public int Feeds;
    public int Retractions;
    public int Deretractions;
    public int NoOps;
    public int FirmwareRetractions;
    public int FirmwareDeretractions;
    public int ToolChanges;
    public int LayerMarks;
    public double PrintLength;
    public double PrintLengthXY;
    public double TravelLength;
    public double EPositive;
    public double ENegative;
    public double EPrint;
    public double ENet;
    public double EMarlin2;
    public int ZChanges;

    public readonly GrowingBox PrintEnds = new();
    public readonly GrowingBox PrintStarts = new();
    public readonly GrowingBox TravelEnds = new();

    private readonly HashSet<long> _heights = [];
    private readonly HashSet<long> _flatHeights = [];
    private long _lastHeight = long.MinValue;

    public int Heights => _heights.Count;

    public int FlatHeights => _flatHeights.Count;

    /// <summary>Counts an extrusion that ends at another height than the previous one.</summary>
    public void HeightChanged(double z)
    {
        var height = Micrometers(z);
        if (height == _lastHeight) return;
        _lastHeight = height;
        ZChanges++;
        _heights.Add(height);
    }

    public void FlatAt(double z) => _flatHeights.Add(Micrometers(z));

    private static long Micrometers(double z) => z is > -1e15 and < 1e15 ? (long)Math.Floor(z * 1000 + 0.5) : z > 0 ? long.MaxValue : long.MinValue + 1;
}
