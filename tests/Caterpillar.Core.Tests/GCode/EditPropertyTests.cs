using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Random edits of random programs in random styles: what is decoded from the written file is the edited toolpath, move by move.</summary>
[Category("Arithmetic")]
public class EditPropertyTests
{
    private static readonly FlavorRules[] Flavors = FlavorTable.All.Where(d => d.ExtruderLetters.Length > 0).ToArray();

    private static int Runs => Rounds.Of(quick: 400, full: 400, onMono: 100);

    [Test]
    public void Random_programs_come_back()
        => ForAll(1, (decoding, random) => RoundTrips.Written(decoding, random.Next(2) == 0));

    [Test]
    public void What_is_left_after_random_cuts_is_the_kept_moves()
        => ForAll(2, (decoding, random) =>
        {
            var edited = Cut(decoding.Toolpath, random);
            return Check(decoding, edited) ?? Kept(decoding.Toolpath, edited);
        });

    [Test]
    public void Extrusions_that_stay_are_copied_together_as_they_are_one_by_one()
        => ForAll(9, (decoding, random) =>
        {
            var toolpath = decoding.Toolpath;
            var removed = Removed(toolpath, random);
            var together = new MoveRemover(toolpath, removed).Run();
            // In blocks of one move no two can be copied together.
            var single = new MoveRemover(toolpath.With(toolpath.Blocks.SelectMany(Apart)), removed).Run();
            return together.Moves().SequenceEqual(single.Moves()) && together.Events.SequenceEqual(single.Events)
                && together.Blocks.SelectMany(Lines).SequenceEqual(single.Blocks.SelectMany(Lines)) ? null : "The cuts differ.";
        });

    [Test]
    public void Chosen_layers_roles_tools_and_kinds_can_be_cut_out()
        => ForAll(3, (decoding, random) => Check(decoding, decoding.Toolpath.Remove(Filter(random))));

    [Test]
    public void Events_and_tools_can_be_put_in()
        => ForAll(4, (decoding, random) =>
        {
            var edited = decoding.Toolpath;
            for (var i = random.Next(1, 4); i > 0; i--) edited = edited.Insert(random.Next(edited.Count + 1), Event(random));
            return Check(decoding, edited);
        });

    [Test]
    public void Moves_can_be_mapped_and_their_material_and_speed_scaled()
        => ForAll(5, (decoding, random) => Check(decoding, Change(decoding.Toolpath, random)));

    [Test]
    public void Edits_can_follow_one_another()
        => ForAll(6, (decoding, random) =>
        {
            var edited = Change(decoding.Toolpath, random);
            edited = edited.Count > 0 ? edited.Insert(random.Next(edited.Count + 1), Event(random)) : edited;
            return Check(decoding, Cut(edited, random));
        });

    [Test]
    public void Random_programs_can_be_converted()
        => ForAll(7, (decoding, random) =>
        {
            var options = new ConvertOptions
            {
                Flavor = FlavorTable.All[random.Next(FlavorTable.All.Count)],
                RelativeE = random.Next(3) switch { 0 => null, 1 => true, _ => false },
                FilamentDiameter = 1.75,
                RetractionLength = random.Next(2) * 1.5,
                ExpandArcs = random.Next(3) == 0,
                Millimeters = random.Next(2) == 0,
            };
            return RoundTrips.Converted(decoding, options) is { } difference ? "to " + options + ": " + difference : null;
        });

    [Test]
    public void After_another_start_code_the_layers_are_the_same()
        => ForAll(8, (decoding, random) =>
        {
            string[] any = ["G28", "G91", "G90", "M83", "M82", "G1 X5 Y7 Z9 F900", "G92 X3", "M106 S9", "G20", "T1", "G1 F77", "; hello", "G10"];
            var start = Enumerable.Range(0, random.Next(6)).Select(_ => any[random.Next(any.Length)])
                .Where(l => l != "G10" || decoding.Flavor.FirmwareRetraction).ToArray();
            var result = GCodeEditor.ToDocument(decoding, decoding.Toolpath, new EditOptions { Start = start, End = ["M84 ; off"] });
            var back = RoundTrips.Decode(result.Value!, decoding.Flavor);
            var prints = decoding.Toolpath.Moves().Where(m => m.Kind == MoveKind.Print && m.Layer >= 0).Select(m => m.Source).ToArray();
            if (prints.Length == 0) return null;
            var kept = decoding.Toolpath.Moves().Where(m => m.Source >= decoding.FirstLayerLine && m.Source <= prints[prints.Length - 1]).ToArray();
            var all = back.Toolpath.Moves().ToArray();
            if (all.Length < kept.Length) return "moves are lost";
            return SameMoves.Difference(Part(decoding.Toolpath, kept), Part(back.Toolpath, all.Skip(all.Length - kept.Length).ToArray()),
                new MoveTolerance { LayersOfExtrusions = true }) is { } found
                ? found + "\n" + string.Concat(result.Value!.ToBytes().Select(b => (char)b)) + "\n-----"
                : null;
        });

    [Test]
    [Explicit("Each property for thousands of programs; minutes.")]
    public void Many_random_programs()
    {
        _first = Runs;
        _runs = 10_000;
        try
        {
            Random_programs_come_back();
            What_is_left_after_random_cuts_is_the_kept_moves();
            Chosen_layers_roles_tools_and_kinds_can_be_cut_out();
            Events_and_tools_can_be_put_in();
            Moves_can_be_mapped_and_their_material_and_speed_scaled();
            Edits_can_follow_one_another();
            Random_programs_can_be_converted();
            After_another_start_code_the_layers_are_the_same();
        }
        finally
        {
            _first = 0;
            _runs = Runs;
        }
    }

    private int _first;
    private int _runs = Runs;

    private static Toolpath Part(Toolpath toolpath, Move[] moves)
    {
        var builder = new ToolpathBuilder(MoveSource.Lines, moves.Length > 0 ? moves[0].Start : null);
        foreach (var layer in toolpath.Layers) builder.AddLayer(layer);
        foreach (var m in moves) builder.Add(m.End, m.E, m.Deposited, m.Speed, m.Kind, m.Role, m.Layer, m.Tool, m.Source, m.Arc);
        return builder.Build(toolpath.Tools);
    }

    private void ForAll(int seed, Func<DecodedGCode, Random, string?> difference)
    {
        for (var run = _first; run < _first + _runs; run++)
        {
            var random = new Random(seed * 1_000_000 + run);
            var flavor = Flavors[random.Next(Flavors.Length)];
            var text = RandomProgram.Text(random, flavor);
            var decoding = RoundTrips.Decode(GCodeDocument.FromText(text), flavor);
            if (difference(decoding, random) is { } found) Assert.Fail("run " + run + ", " + flavor.Name + ": " + found + "\n" + text);
        }
    }

    // Both methods of writing.
    private static string? Check(DecodedGCode decoding, Toolpath edited)
    {
        // A and B extrude where they do so along X or Y; without any extrusion nothing says so.
        if (decoding.Axis != ExtrusionAxis.E && !edited.Moves().Any(m => m.E != 0 && (m.End - m.Start).LengthXY > 2e-3)) return null;
        var spliced = RoundTrips.Edited(decoding, edited, new MoveTolerance { Chords = 0.01, LayersOfExtrusions = true, UnknownRoles = true });
        if (spliced is not null) return spliced + "\n" + Text(decoding, edited);
        return RoundTrips.Written(decoding, edited, true) is { } written ? "rewritten: " + written : null;
    }

    private static string Text(DecodedGCode decoding, Toolpath edited)
        => string.Concat(GCodeEditor.ToDocument(decoding, edited).Value!.ToBytes().Select(b => (char)b)) + "\n-----";

    // The kept moves are the same, and each finds its tool retracted as much as before.
    private static string? Kept(Toolpath before, Toolpath after)
    {
        var states = States(before).ToDictionary(s => s.Move.Source);
        foreach (var (move, pulled, firmware) in States(after))
        {
            if (move.Source < 0 || before.HomeOf(states[move.Source].Move) is not null) continue;
            var was = states[move.Source];
            if (move.End != was.Move.End || move.E != was.Move.E || move.Kind != was.Move.Kind || move.Speed != was.Move.Speed
                || move.Tool != was.Move.Tool) return "a kept move changed: " + was.Move + " to " + move;
            if (move.Kind == MoveKind.Travel) continue;
            if (firmware != was.Firmware || Math.Abs(pulled - was.Pulled) > 1e-6) return "different retraction before " + move + ": " + pulled + " "
                + firmware + " instead of " + was.Pulled + " " + was.Firmware;
        }
        return null;
    }

    private static IEnumerable<(Move Move, double Pulled, bool Firmware)> States(Toolpath toolpath)
    {
        var pulled = new double[10];
        var firmware = new bool[10];
        foreach (var move in toolpath.Moves())
        {
            yield return (move, pulled[move.Tool], firmware[move.Tool]);
            if (move.E != 0) pulled[move.Tool] = Math.Max(pulled[move.Tool] - move.E, 0);
            else if (move.Kind is MoveKind.Retract or MoveKind.Deretract) firmware[move.Tool] = move.Kind == MoveKind.Retract;
        }
    }

    private static Toolpath Cut(Toolpath toolpath, Random random) => new MoveRemover(toolpath, Removed(toolpath, random)).Run();

    // Runs of moves.
    private static MoveSet Removed(Toolpath toolpath, Random random)
    {
        var removed = new MoveSet(toolpath.Count);
        var on = false;
        for (var i = 0; i < toolpath.Count; i++)
        {
            if (random.Next(4) == 0) on = random.Next(3) == 0;
            removed[i] = on;
        }
        return removed;
    }

    private static IEnumerable<ToolpathBlock> Apart(ToolpathBlock block) => Enumerable.Range(0, block.Count).Select(i =>
    {
        var columns = new ToolpathColumns(1);
        columns.Append(block.Columns, i, 1);
        if (block.Columns.TryGetArc(i, out var arc)) (columns.ArcMoves, columns.Arcs) = ([0], [arc]);
        return new ToolpathBlock(columns);
    });

    private static IEnumerable<int> Lines(ToolpathBlock block) => Enumerable.Range(0, block.Count).Select(i => block.Columns.Line?[i] ?? 0);

    private static MoveFilter Filter(Random random) => random.Next(5) switch
    {
        0 => new MoveFilter { FirstLayer = random.Next(3), LastLayer = random.Next(3) },
        1 => new MoveFilter { Roles = [Role.Infill, Role.OuterWall] },
        2 => new MoveFilter { Tool = random.Next(3) },
        3 => new MoveFilter { Kinds = [(MoveKind)random.Next(8)] },
        _ => new MoveFilter { Box = new Bounds(new Vec3(0, 0, 0), new Vec3(25, 50, 5)) },
    };

    private static PrinterEvent Event(Random random) => random.Next(7) switch
    {
        0 => new PauseEvent("look"),
        1 => new ToolEvent(random.Next(4)),
        2 => new FanEvent(random.Next(256) / 255.0),
        3 => new NozzleTemperatureEvent(200 + random.Next(30), random.Next(2) == 0),
        4 => new BedTemperatureEvent(60),
        5 => new RawEvent("M117 hello"),
        _ => new CommentEvent("a note"),
    };

    private static Toolpath Change(Toolpath toolpath, Random random)
    {
        var filter = random.Next(2) == 0 ? new MoveFilter() : Filter(random);
        return random.Next(4) switch
        {
            0 => toolpath.ScaleFlow(filter, 0.25 + random.NextDouble()),
            1 => toolpath.ScaleSpeed(filter, 0.25 + random.NextDouble()),
            2 => toolpath.Deform(filter, p => new Vec3(p.X * 1.1 + 3.1234, p.Y + 0.1 * p.X, p.Z + 0.02 * p.X)),
            _ => toolpath.Deform(filter, p => p + new Vec3(1, 2, 0.5)).ScaleFlow(filter, 1.5),
        };
    }
}
