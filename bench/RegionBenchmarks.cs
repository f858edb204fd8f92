using BenchmarkDotNet.Attributes;
using Caterpillar.Geometry;

namespace Caterpillar.Bench;

/// <summary>Offsets and boolean operations of a contour of 1,000 vertices.</summary>
[MemoryDiagnoser]
public class RegionBenchmarks
{
    private readonly Region _region = Region.From(Samples.Contour(1000));
    private readonly Region _other = Region.Rectangle(80, 80, 130, 110);

    [Benchmark]
    public Region Inwards() => _region.Offset(-0.4);

    [Benchmark]
    public Region OutwardsRound() => _region.Offset(0.4, JoinStyle.Round);

    [Benchmark]
    public Region Subtract() => _region.Subtract(_other);

    [Benchmark]
    public Region Union() => _region.Union(_other);

    [Benchmark]
    public object Hatch() => _region.HatchLines(45, 2);
}
