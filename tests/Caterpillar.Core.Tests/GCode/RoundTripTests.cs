using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Round trips of the shared files, compared move by move (<see cref="SameMoves"/>).</summary>
public class RoundTripTests
{
    [Category("Arithmetic")]
    [TestCaseSource(typeof(GCodeFiles), nameof(GCodeFiles.Affordable))]
    public void Every_changed_move_is_rewritten(string file)
    {
        var decoding = RoundTrips.Decode(GCodeFiles.Document(file), null);
        Assert.That(RoundTrips.Shifted(decoding), Is.Null);
    }

    [TestCaseSource(typeof(GCodeFiles), nameof(GCodeFiles.Affordable))]
    public void The_toolpath_alone_is_written(string file)
    {
        var decoding = RoundTrips.Decode(GCodeFiles.Document(file), null);
        foreach (var relative in new[] { true, false })
        {
            if (InTurn(decoding, relative)) Assert.That(RoundTrips.Written(decoding, relative), Is.Null);
        }
    }

    [TestCaseSource(typeof(GCodeFiles), nameof(GCodeFiles.Affordable))]
    [Category("Arithmetic")]
    public void Another_notation_makes_the_same_moves(string file)
    {
        var decoding = RoundTrips.Decode(GCodeFiles.Document(file), null);
        foreach (var (name, options) in Notations())
        {
            if (decoding.Toolpath.Count < 5000
                || (name is "relative E" or "absolute E" && InTurn(decoding, name is "absolute E"))) Assert.That(RoundTrips.Converted(decoding, options),
                Is.Null, name);
        }
        if (decoding.Toolpath.Count < 10000) Assert.That(RoundTrips.Fitted(decoding), Is.Null, "arcs fitted");
    }

    // Small files in every flavor, large ones in a few.
    [TestCaseSource(typeof(GCodeFiles), nameof(GCodeFiles.Affordable))]
    [Category("Arithmetic")]
    public void Another_flavor_makes_the_same_moves(string file)
    {
        foreach (var flavor in new[] { null, FlavorTable.Slicer })
        {
            var decoding = RoundTrips.Decode(GCodeFiles.Document(file), flavor);
            var small = decoding.Toolpath.Count < 1000;
            if (!small && flavor is not null) continue;
            foreach (var (name, options) in Flavors())
            {
                if (small || name == (decoding.Toolpath.Count % 2 == 0 ? "klipper" : "cnc")) Assert.That(RoundTrips.Converted(decoding, options), Is.Null,
                    decoding.Flavor.Name + " to " + name);
            }
        }
    }

    // Large files take only one of two round trips.
    private static bool InTurn(DecodedGCode decoding, bool first) => decoding.Toolpath.Count < 15000 || decoding.Toolpath.Count % 2 == (first ? 0 : 1);

    [Test]
    [Explicit("Every round trip of every file; some minutes.")]
    public void Every_file_makes_every_round_trip()
    {
        var watch = Stopwatch.StartNew();
        var failures = new List<string>();
        var count = new SortedDictionary<string, int>(StringComparer.Ordinal);
        foreach (var file in GCodeFiles.All())
        {
            var document = GCodeFiles.Document(file);
            foreach (var flavor in new[] { null, FlavorTable.Slicer })
            {
                var decoding = RoundTrips.Decode(document, flavor);
                foreach (var (name, trip) in Trips())
                {
                    var difference = trip(decoding);
                    count[name] = count.TryGetValue(name, out var before) ? before + 1 : 1;
                    if (difference is not null) failures.Add(file + " (" + decoding.Flavor.Name + ") " + name + ": " + difference);
                }
            }
        }
        var said = $"{count.Values.Sum()} round trips of {count.Count} kinds in {watch.Elapsed.TotalSeconds:0.0} s, {failures.Count} differ";
        TestContext.Progress.WriteLine(said);
        Assert.That(failures, Is.Empty, said + "\n" + string.Join("\n", failures));
    }

    private static IEnumerable<(string Name, Func<DecodedGCode, string?> Trip)> Trips()
    {
        yield return ("shifted", RoundTrips.Shifted);
        yield return ("written relative", d => RoundTrips.Written(d, true));
        yield return ("written absolute", d => RoundTrips.Written(d, false));
        yield return ("arcs fitted", RoundTrips.Fitted);
        foreach (var (name, options) in Notations().Concat(Flavors())) yield return (name, d => RoundTrips.Converted(d, options));
    }

    private static IEnumerable<(string Name, ConvertOptions Options)> Notations()
    {
        yield return ("relative E", new ConvertOptions { RelativeE = true });
        yield return ("absolute E", new ConvertOptions { RelativeE = false });
        yield return ("mm", new ConvertOptions { Millimeters = true });
        yield return ("arcs expanded", new ConvertOptions { ExpandArcs = true, ChordTolerance = 0.02 });
        yield return ("volumes", new ConvertOptions { Volumetric = true, FilamentDiameter = 1.75 });
        yield return ("lengths", new ConvertOptions { Volumetric = false, FilamentDiameter = 1.75 });
        yield return ("fewer decimals", new ConvertOptions { DecimalsXyz = 2, DecimalsE = 4, DecimalsF = 0 });
        yield return ("fewer decimals, relative E", new ConvertOptions { DecimalsXyz = 2, DecimalsE = 3, DecimalsF = 0, RelativeE = true });
    }

    private static IEnumerable<(string Name, ConvertOptions Options)> Flavors()
    {
        foreach (var flavor in FlavorTable.All)
        {
            yield return (flavor.Name, new ConvertOptions { Flavor = flavor, RetractionLength = 1.5, FilamentDiameter = 1.75 });
            yield return (flavor.Name + " relative", new ConvertOptions { Flavor = flavor, RelativeE = true, FilamentDiameter = 1.75 });
        }
    }
}
