using System;
using System.IO;
using System.Text;
using BenchmarkDotNet.Attributes;
using Caterpillar.GCode;
using Caterpillar.Toolpaths;

namespace Caterpillar.Bench;

/// <summary>Reading and writing a G-code file: that in <c>CATERPILLAR_BIG_GCODE</c>, or a made one of 300,000 lines.</summary>
[MemoryDiagnoser]
public class GCodeBenchmarks
{
    private byte[] _bytes = [];
    private DecodedGCode? _decoding;

    [GlobalSetup]
    public void Prepare()
    {
        var file = Environment.GetEnvironmentVariable("CATERPILLAR_BIG_GCODE");
        _bytes = string.IsNullOrEmpty(file) ? Made(300_000) : File.ReadAllBytes(file);
        _decoding = DecodeOnTwoThreads();
    }

    [Benchmark]
    public DecodedGCode DecodeOnOneThread()
        => GCodeDecoder.Decode(GCodeDocument.FromBytes(_bytes), new DecodeOptions { Threads = 1 }).Value ?? throw new InvalidOperationException();

    [Benchmark]
    public DecodedGCode DecodeOnTwoThreads()
        => GCodeDecoder.Decode(GCodeDocument.FromBytes(_bytes), new DecodeOptions { Threads = 2 }).Value ?? throw new InvalidOperationException();

    [Benchmark]
    public object DecodeAndWriteUnedited()
    {
        var decoding = DecodeOnTwoThreads();
        return GCodeEditor.Write(decoding, decoding.Toolpath, new EditOptions(), Stream.Null);
    }

    [Benchmark]
    public object EditOneLayerAndWrite()
        => GCodeEditor.Write(_decoding!, _decoding!.Toolpath.ScaleSpeed(new MoveFilter { FirstLayer = 20, LastLayer = 20, Kinds = [MoveKind.Print] }, 0.5),
            new EditOptions(), Stream.Null);

    [Benchmark]
    public object ConvertToRelativeE() => GCodeConverter.Convert(_decoding!, new ConvertOptions { RelativeE = true }, null, Stream.Null);

    [Benchmark]
    public void WriteAnew() => new GCodeWriter(_decoding!.Toolpath).WriteAll(Stream.Null);

    private static byte[] Made(int lines)
    {
        var text = new StringBuilder("; gcode_flavor = marlin2\nG21\nG90\nM82\nG92 E0\n");
        for (var i = 0; i < lines; i++)
        {
            if (i % 3000 == 0) text.Append(";LAYER_CHANGE\n;Z:").Append(i / 3000 * 2 + 2).Append("e-1\nG1 Z").Append(i / 3000 * 2 + 2).Append(" F7800\n");
            text.Append("G1 X").Append(i % 97).Append('.').Append(i % 1000).Append(" Y").Append(i % 89).Append('.').Append(i % 991).Append(" E").Append(i / 50)
                .Append('.').Append((i % 50) * 2 + 10).Append('\n');
        }
        return Encoding.ASCII.GetBytes(text.ToString());
    }
}
