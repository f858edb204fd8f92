namespace Caterpillar.Drawings;

/// <summary>The curves of a file that is being read.</summary>
internal sealed class CurveSource(
    byte[] bytes, string name, CurveReadOptions options, DiagnosticList diagnostics, IProgress<double>? progress, CancellationToken cancel)
    : FileSource(bytes, name, diagnostics, progress, cancel)
{
    public CurveReadOptions Options { get; } = options;

    /// <summary>Those found so far.</summary>
    public List<UserCurve> Curves { get; } = [];

    public SourceLocation Place(int line, int? column = null, string? key = null) => new(Name, line, column, key);

    /// <summary>A curve of fewer than two different points.</summary>
    public void TooShort(SourceLocation place)
        => Diagnostics.Add(Severity.Warning, "curves.too_short", "Curves with fewer than two different points are ignored.", place);

    /// <summary>A polyline of finite points, or null and a warning if it has no length. A last point equal to the first closes it.</summary>
    public PolylineCurve? Polyline(Vec3[] points, bool closed, SourceLocation place, out bool endDropped)
    {
        endDropped = false;
        var count = points.Length;
        if (Array.TrueForAll(points, p => p == points[0]))
        {
            TooShort(place);
            return null;
        }
        if (count > 3 && points[0] == points[count - 1])
        {
            Array.Resize(ref points, count - 1);
            closed = true;
            endDropped = true;
        }
        return new PolylineCurve(Geometry.Polyline.Own(points, closed && points.Length >= 3));
    }
}
