using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Turtles;

namespace Caterpillar.Tests.Turtles;

/// <summary>Reads the command lists of the shared data, whose <c>lift</c> is <c>lift_world</c>, and replays them with a turtle.</summary>
internal static class CommandList
{
    public static IEnumerable<string[]> Read(string file)
    {
        using var stream = file.EndsWith(".gz", StringComparison.Ordinal) ? new GZipStream(File.OpenRead(file), CompressionMode.Decompress)
            : (Stream)File.OpenRead(file);
        using var reader = new StreamReader(stream);
        while (reader.ReadLine() is { } line)
        {
            if (line.Length > 0 && line[0] != '#') yield return line.Split(' ');
        }
    }

    public static Turtle Replay(string file)
    {
        var turtle = new Turtle();
        foreach (var words in Read(file)) Do(turtle, words);
        return turtle;
    }

    public static void Do(Turtle t, string[] words)
    {
        double N(int i) => NumberReader.TryParse(words[i], out var value) ? value : throw new InvalidDataException(string.Join(" ", words));
        double? K(int i) => words[i] == "keep" ? null : N(i);
        _ = words[0] switch
        {
            "start" => t.StartAt(N(1), N(2), N(3)),
            "yaw" => t.Left(N(1)),
            "pitch" => t.PitchUp(N(1)),
            "roll" => t.RollRight(N(1)),
            "heading" => t.SetHeading(N(1), N(2), N(3)),
            "forward" => t.Forward(N(1)),
            "forward_lift" => t.ForwardLift(N(1), N(2)),
            "lift" => t.LiftWorld(N(1)),
            "position" => t.GoTo(K(1), K(2), K(3)),
            "jump" => t.Jump(N(1), N(2), N(3)).SetHeading(N(4)),
            "penup" => t.PenUp(),
            "pendown" => t.PenDown(),
            "extrude" => t.Extrude(N(1)),
            "density" => t.SetDensity(N(1)),
            "area" => t.SetArea(N(1)),
            "rate" => t.SetRate(N(1)),
            "speed" => t.SetSpeed(N(1)),
            "dwell" => t.Dwell(N(1)),
            "pause" => t.Pause(),
            "hotend" => t.NozzleTemperature(N(1)),
            "bed" => t.BedTemperature(N(1)),
            _ => throw new InvalidDataException(words[0]),
        };
    }

    /// <summary>The numbers of a drawing, in the words of truth.json.</summary>
    public static Totals Total(Turtle turtle, Vec3 start)
    {
        var history = TurtleHistory.Of(turtle.ToSteps(), start: start);
        var totals = new Totals();
        Sum printLength = new(), travelLength = new(), ePrint = new(), eExtrude = new(), time = new();
        foreach (var move in history)
        {
            if (move.From == move.To)
            {
                eExtrude.Add(move.Filament);
                continue;
            }
            if (move.Prints)
            {
                printLength.Add(move.Length);
                ePrint.Add(move.Filament);
                time.Add(move.Length / move.Rate * 60);
                totals.Box = totals.Box.Include(move.From).Include(move.To);
                if (move.Length > 1e-9) totals.PrintMoves++;
            }
            else
            {
                travelLength.Add(move.Length);
                if (move.Length > 1e-9) totals.TravelMoves++;
            }
        }
        (totals.PrintLength, totals.TravelLength, totals.EPrint, totals.EExtrude, totals.PrintTime) = (printLength.Value, travelLength.Value, ePrint.Value,
            eExtrude.Value, time.Value);
        return totals;
    }

    // Neumaier's compensated sum: the error of adding up is not the turtle's.
    private sealed class Sum
    {
        private double _sum;
        private double _rest;

        public double Value => _sum + _rest;

        public void Add(double value)
        {
            var next = _sum + value;
            _rest += Math.Abs(_sum) >= Math.Abs(value) ? _sum - next + value : value - next + _sum;
            _sum = next;
        }
    }

    public sealed class Totals
    {
        public int PrintMoves { get; set; }

        public int TravelMoves { get; set; }

        public double PrintLength { get; set; }

        public double TravelLength { get; set; }

        public double EPrint { get; set; }

        public double EExtrude { get; set; }

        public double PrintTime { get; set; }

        public Bounds Box { get; set; } = Bounds.Empty;
    }
}
