using System;
using System.Linq;
using BenchmarkDotNet.Attributes;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;

namespace Caterpillar.Bench;

/// <summary>The stages from a mesh of half a million triangles to G-code and back, 0.2 mm layers, 2 walls, 20 % infill.</summary>
[MemoryDiagnoser]
public class SlicingBenchmarks
{
    private readonly PrintSetup _setup = new();
    private TriMesh _mesh = TriMesh.Empty;
    private double[] _heights = [];
    private SliceResult? _sliced;
    private Toolpath? _toolpath;
    private byte[] _text = [];

    [GlobalSetup]
    public void Prepare()
    {
        _mesh = Samples.BumpySphere().Moved(new Vec3(110, 110, 0));
        _heights = Enumerable.Range(0, 400).Select(i => 0.1 + 0.2 * i).ToArray();
        _sliced = Slice();
        _toolpath = Plan();
        using var memory = new System.IO.MemoryStream();
        new GCodeWriter(_toolpath).WriteAll(memory);
        _text = memory.ToArray();
    }

    [Benchmark]
    public object Sections() => MeshSections.At(_mesh, _heights);

    [Benchmark]
    public SliceResult Slice() => PlanarSlicer.Slice([new NamedMesh("sphere", _mesh)], _setup.Settings).Value ?? throw new InvalidOperationException();

    [Benchmark]
    public Toolpath Plan() => Planner.Plan(_sliced!.ToSteps(), _setup).Value ?? throw new InvalidOperationException();

    [Benchmark]
    public void Write() => new GCodeWriter(_toolpath!).WriteAll(System.IO.Stream.Null);

    [Benchmark]
    public object Decode() => GCodeDecoder.Decode(_text);
}
