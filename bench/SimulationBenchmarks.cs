using System;
using BenchmarkDotNet.Attributes;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;

namespace Caterpillar.Bench;

/// <summary>Times of 2.5 million moves, statistics of them, and the state at one moment.</summary>
[MemoryDiagnoser]
public class SimulationBenchmarks
{
    private readonly Random _random = new(1);
    private Toolpath? _toolpath;
    private PrintSetup _setup = new();
    private Timeline? _timeline;

    [Params(Cornering.Jerk, Cornering.JunctionDeviation, Cornering.SquareCornerVelocity)]
    public Cornering Rule { get; set; }

    [GlobalSetup]
    public void Prepare()
    {
        _toolpath = Samples.Print(2_500_000);
        _setup = new PrintSetup { Printer = new Printer { Cornering = Rule, LookaheadMoves = Rule == Cornering.SquareCornerVelocity ? 0 : 16 } };
        _timeline = Timeline.Of(_toolpath, _setup);
    }

    [Benchmark]
    public Timeline Plan() => Timeline.Of(_toolpath!, _setup);

    [Benchmark]
    public PrintStatistics Statistics() => PrintStatistics.Of(_timeline!);

    [Benchmark]
    public MachineState Seek() => _timeline!.AtFraction(_random.NextDouble());
}
