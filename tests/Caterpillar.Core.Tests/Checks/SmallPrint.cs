using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Tests.Checks;

/// <summary>Takes down the progress that is reported, from any thread.</summary>
internal sealed class Shares : IProgress<double>
{
    public List<double> All { get; } = [];

    public void Report(double value)
    {
        lock (All) All.Add(value);
    }
}

/// <summary>Builds small prints for tests: extrusions 0.4 mm wide and 0.2 mm high unless they say otherwise.</summary>
internal sealed class SmallPrint
{
    public const double Area = 0.08;
    public static readonly double FilamentArea = Math.PI / 4 * 1.75 * 1.75;
    private readonly ToolpathBuilder _builder;
    private int _step;
    private int _layer = -1;
    private Vec3? _turns;

    public SmallPrint(double x = 10, double y = 10, double z = 0.2) => _builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(x, y, z));

    /// <summary>The moves that must be found, by their code.</summary>
    public List<(int Move, string Code)> Planted { get; } = [];

    public Vec3 At => _builder.Position;

    public int Count => _builder.Count;

    public static Printer Generic { get; } = new() { StartGCode = ValueList<string>.Empty, MaxFlow = 0, MaxSpeed = new(500, 500, 500, 500) };

    public SmallPrint Go(double x, double y, double z) => Add(new Vec3(x, y, z), 0, MoveKind.Travel);

    /// <summary>Up, over and down, above everything.</summary>
    public SmallPrint Over(double x, double y, double z) => Go(At.X, At.Y, 200).Go(x, y, 200).Go(x, y, z);

    public SmallPrint Print(double x, double y, double z, double area = Area, Role role = Role.Unspecified, double speed = 50, int tool = 0)
        => Add(new Vec3(x, y, z), new Vec3(x, y, z).DistanceTo(At) * area, MoveKind.Print, role, speed, tool);

    /// <summary>The moves that follow end with these rotary words, degrees.</summary>
    public SmallPrint Turns(double a, double b, double c)
    {
        _turns = new Vec3(a, b, c);
        return this;
    }

    /// <summary>The moves that follow are in a layer.</summary>
    public SmallPrint InLayer(Layer layer)
    {
        _layer = _builder.AddLayer(layer);
        return this;
    }

    public SmallPrint Arc(double x, double y, double z, Vec3 center, double sweep, double area = 0)
    {
        var (end, arc) = (new Vec3(x, y, z), new Arc(center, sweep));
        var e = arc.Length(At, end) * area / FilamentArea;
        _builder.Add(end, e, e, 50, area > 0 ? MoveKind.Print : MoveKind.Travel, Role.Unspecified, -1, 0, _step++, arc);
        return this;
    }

    public SmallPrint Prime(double volume)
    {
        _builder.Add(At, volume / FilamentArea, volume / FilamentArea, 5, MoveKind.Prime, Role.Unspecified, -1, 0, _step++);
        return this;
    }

    public SmallPrint Event(PrinterEvent what)
    {
        _builder.AddEvent(what, _step++);
        return this;
    }

    /// <summary>A wall along X from the bed up, its extrusions on top of each other; the head ends above it.</summary>
    public SmallPrint Wall(double x0, double x1, double y, double top)
    {
        Over(x0, y, 0.2);
        for (var k = 1; k <= (int)Math.Round(top / 0.2); k++)
        {
            Go(At.X, At.Y, 0.2 * k);
            Print(k % 2 == 1 ? x1 : x0, y, 0.2 * k);
        }
        return Go(At.X, At.Y, 200);
    }

    /// <summary>The next move must be found.</summary>
    public SmallPrint Expect(string code)
    {
        Planted.Add((_builder.Count, code));
        return this;
    }

    public Toolpath Build() => _builder.Build([new ToolpathTool(FilamentArea)]);

    public static PrintSetup Setup(Func<Printer, Printer>? change = null)
        => new(change is null ? Generic : change(Generic), new Material(), new PrintSettings());

    /// <summary>Findings of one of the codes, or all that begin with a word.</summary>
    public static Diagnostic[] Find(Toolpath toolpath, PrintSetup setup, string code)
        => PrintCheck.Run(toolpath, setup).Where(d => d.Code.StartsWith(code, StringComparison.Ordinal)).ToArray();

    /// <summary>The file of a toolpath without any check, read again, with the line of each move.</summary>
    public static (DecodedGCode File, WrittenLines Lines, string Text) Written(Toolpath toolpath, PrintSetup setup)
    {
        var lines = new WrittenLines();
        using var memory = new MemoryStream();
        new GCodeWriter(toolpath, SetupFormat.Of(setup, toolpath).Value) { Written = lines }.WriteAll(memory);
        return (Decode(memory.ToArray(), setup), lines, Encoding.ASCII.GetString(memory.ToArray()));
    }

    public static DecodedGCode Decode(byte[] text, PrintSetup setup)
        => GCodeDecoder.Decode(text, new DecodeOptions { Flavor = setup.Printer.Flavor, FilamentDiameter = 1.75 }).Value!;

    private SmallPrint Add(Vec3 end, double volume, MoveKind kind, Role role = Role.Unspecified, double speed = 50, int tool = 0)
    {
        _builder.Add(end, volume / FilamentArea, volume / FilamentArea, speed, kind, role, _layer, tool, _step++);
        if (_turns is { } turns) _builder.SetRotary(turns);
        return this;
    }
}
