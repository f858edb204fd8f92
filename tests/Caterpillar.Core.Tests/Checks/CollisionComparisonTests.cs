using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Collisions of random prints against a search by brute force over points of moves and extrusions, which shares no code with the checks.</summary>
public class CollisionComparisonTests
{
    private const double Step = 0.1;
    private const double Cell = 0.25;
    private const double Lag = 0.5 + 0.4 + 2 * Cell;
    private static readonly (double Radius, double Height)[] Outline = [(0.5, 0), (4, 6), (20, 12)];

    private static IEnumerable<int> Seeds => Enumerable.Range(0, Rounds.Of(quick: 8, full: 20));

    [Test]
    public void Random_prints_agree_outside_a_band_of_one_cell([ValueSource(nameof(Seeds))] int seed)
    {
        var random = new Random(seed);
        var (certain, free) = (0, 0);
        for (var n = 0; n < 50; n++)
        {
            var print = Random(random);
            var toolpath = print.Build();
            var found = PrintCheck.Run(toolpath, SmallPrint.Setup())
                .Where(d => d.Code is CheckCodes.NozzleHits or CheckCodes.TravelHits or CheckCodes.Slope).ToArray();
            var (must, may) = (Search(toolpath, -Cell), Search(toolpath, Cell));
            var (mustCount, mayCount) = (must.Count(h => h), may.Count(h => h));
            var count = found.Sum(d => d.Count);
            Assert.That(count, Is.InRange(mustCount, mayCount), $"print {n}\n"
                + string.Join("\n", toolpath.Moves().Select((m, i) => $"{i} {m.Kind} {m.Start} {m.End} {must[i]} {may[i]}"))
                + string.Join("\n", found.Select(f => f.ToString())));
            if (count == 0)
            {
                free++;
                continue;
            }
            certain += mustCount > 0 ? 1 : 0;
            var first = found.Min(d => d.Source!.Move!.Value);
            Assert.That(may[first], Is.True, $"print {n}: move {first} is free");
            if (mustCount > 0) Assert.That(first, Is.AtMost(Array.IndexOf(must, true)), $"print {n}");
        }
        Assert.That((certain, free), Is.GreaterThan((4, 4)), "both kinds of prints were made");
    }

    // Extrusions and travels in all directions in a space of 8 x 8 x 4 mm.
    private static SmallPrint Random(Random random)
    {
        var print = new SmallPrint(100 + 8 * random.NextDouble(), 100 + 8 * random.NextDouble(), 4);
        var moves = random.Next(4, 9);
        for (var i = 0; i < moves; i++)
        {
            var (x, y) = (100 + 8 * random.NextDouble(), 100 + 8 * random.NextDouble());
            var z = random.Next(3) > 0 ? print.At.Z : 0.2 + 4 * random.NextDouble();
            if (random.Next(2) == 0) print.Go(x, y, z + (random.Next(2) == 0 ? 3 : 0));
            else print.Print(x, y, z, 0.04 + 0.1 * random.NextDouble());
        }
        return print;
    }

    /// <summary>For each move whether it meets an earlier extrusion that is wider by <paramref name="margin"/> mm on each side.</summary>
    private static bool[] Search(Toolpath toolpath, double margin)
    {
        var moves = toolpath.Moves().ToArray();
        var ends = new double[moves.Length];
        for (var i = 0; i < moves.Length; i++) ends[i] = (i > 0 ? ends[i - 1] : 0) + moves[i].Length;
        var hits = new bool[moves.Length];
        for (var i = 0; i < moves.Length; i++)
        {
            for (var k = 0; k < i && !hits[i]; k++)
            {
                if (moves[k].Kind == MoveKind.Print) hits[i] = Meets(moves[i], ends[i], moves[k], ends[k], toolpath, margin);
            }
        }
        return hits;
    }

    private static bool Meets(Move move, double moveEnd, Move extrusion, double extrusionEnd, Toolpath toolpath, double margin)
    {
        var height = Height(extrusion);
        var half = extrusion.Deposited * toolpath.VolumePerE(0)!.Value / extrusion.Length / height / 2;
        var tolerance = move.Kind == MoveKind.Print ? Math.Max(0.05, Height(move) / 2) : 0.05;
        // Outside the band only what is as high counts in both searches.
        var slack = margin > 0 ? 0.05 + 0.02 : -0.02;
        int along = Count(move.Length), across = Count(extrusion.Length);
        for (var a = 0; a <= along; a++)
        {
            var tip = Vec3.Lerp(move.Start, move.End, (double)a / along);
            var done = moveEnd - move.Length * (1 - (double)a / along);
            for (var b = 0; b <= across; b++)
            {
                var t = (double)b / across;
                // The fresh part is not there yet. Whether it begins a little sooner or later is in the band.
                var since = done - (extrusionEnd - extrusion.Length * (1 - t));
                if (since < Lag + (margin > 0 ? -2 * Lag : 2 * Lag)) continue;
                var top = Vec3.Lerp(extrusion.Start, extrusion.End, t);
                var reach = Reach(top.Z - tip.Z - tolerance + slack);
                if (reach < 0) continue;
                double dx = top.X - tip.X, dy = top.Y - tip.Y;
                var limit = reach + half + margin + (margin > 0 ? Step : -Step);
                if (limit > 0 && dx * dx + dy * dy <= limit * limit) return true;
            }
        }
        return false;
    }

    // As the checks take it for an extrusion without a layer in the air or on the bed: the usual one, or down to the bed.
    private static double Height(Move extrusion) => Math.Min(0.2, Math.Max(extrusion.Start.Z, extrusion.End.Z));

    private static int Count(double length) => Math.Max(1, (int)Math.Ceiling(length / Step));

    private static double Reach(double excess)
    {
        if (excess <= 0) return -1;
        for (var i = 1; i < Outline.Length; i++)
        {
            if (excess > Outline[i].Height) continue;
            var ((r0, h0), (r1, h1)) = (Outline[i - 1], Outline[i]);
            return r0 + (r1 - r0) * (excess - h0) / (h1 - h0);
        }
        return 20;
    }
}
