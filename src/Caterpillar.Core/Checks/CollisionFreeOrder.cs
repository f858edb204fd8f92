using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>
/// An order in which free paths can be printed without the nozzle, the head or the gantry going through one that is printed already. Between paths the head
/// goes up, over everything, and down.
/// </summary>
public static class CollisionFreeOrder
{
    /// <summary>Code of the errors that name two paths that block each other, or several in a circle.</summary>
    public const string Blocked = "order.blocked";

    /// <summary>Code of the error that names a path that blocks itself in both directions.</summary>
    public const string BlocksItself = "order.blocks_itself";

    /// <summary>
    /// Finds an order, close to the given one. A path that blocks itself is reversed where that helps. Of paths that block each other, whichever is first,
    /// there is no order: then the errors name them.
    /// </summary>
    /// <param name="paths">The paths, in any order.</param>
    /// <param name="setup">The printer with its head, the material and the settings.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="cancel">Cancels.</param>
    /// <returns>The steps, paths with the travels between them; the steps of errors are the numbers of the paths.</returns>
    public static Result<IReadOnlyList<Step>> Find(
        IReadOnlyList<PrintPath> paths, PrintSetup setup, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (paths is null) throw new ArgumentNullException(nameof(paths));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        var problems = new List<Diagnostic>();
        var top = paths.Select(p => p.Bounds.Max.Z).Append(setup.PrintedOn?.Bounds.Max.Z ?? 0).Max();
        var trial = new OrderTrial(setup, top + Math.Max(setup.Printer.LiftClearance, 1));
        var turned = paths.Select((p, i) => Turned(p, i, trial, problems)).ToArray();
        if (problems.Count > 0) return new Result<IReadOnlyList<Step>>(null, problems);
        var before = Constraints(turned, trial, problems, progress, cancel);
        if (problems.Count > 0) return new Result<IReadOnlyList<Step>>(null, problems);
        var order = Sorted(before, problems);
        if (order is null) return new Result<IReadOnlyList<Step>>(null, problems);
        progress?.Report(1);
        return new Result<IReadOnlyList<Step>>(trial.Steps(order.Select(i => turned[i])), []);
    }

    private static PrintPath Turned(PrintPath path, int index, OrderTrial trial, List<Diagnostic> problems)
    {
        if (path is null) throw new ArgumentException("A path is null.", nameof(path));
        if (!trial.Collides(path)) return path;
        var back = path.Reversed();
        if (!trial.Collides(back)) return back;
        problems.Add(new Diagnostic(Severity.Error, BlocksItself,
            $"Path {Name(path, index)} cannot be printed in either direction: the nozzle would go through it.",
            new SourceLocation(Step: index)));
        return path;
    }

    // For each path those that must be printed before it.
    private static List<int>[] Constraints(PrintPath[] paths, OrderTrial trial, List<Diagnostic> problems, IProgress<double>? progress,
        CancellationToken cancel)
    {
        var before = Array.ConvertAll(paths, _ => new List<int>());
        for (var i = 0; i < paths.Length; i++)
        {
            progress?.Report((double)i / paths.Length);
            for (var k = i + 1; k < paths.Length; k++)
            {
                cancel.ThrowIfCancellationRequested();
                var (late, early) = (trial.Collides(paths[i], paths[k]), trial.Collides(paths[k], paths[i]));
                if (late && early)
                    problems.Add(new Diagnostic(Severity.Error, Blocked,
                        $"Paths {Name(paths[i], i)} and {Name(paths[k], k)} block each other: whichever is printed first, the head goes through it for the "
                            + $"other.",
                        new SourceLocation(Step: k)));
                else if (late) before[i].Add(k);
                else if (early) before[k].Add(i);
            }
        }
        return before;
    }

    // The first path that nothing has to come before any more, again and again.
    private static List<int>? Sorted(List<int>[] before, List<Diagnostic> problems)
    {
        var order = new List<int>(before.Length);
        var done = new bool[before.Length];
        while (order.Count < before.Length)
        {
            var next = 0;
            while (next < done.Length && (done[next] || !before[next].TrueForAll(b => done[b]))) next++;
            if (next == done.Length)
            {
                var circle = Enumerable.Range(0, before.Length).Where(i => !done[i]).ToArray();
                problems.Add(new Diagnostic(Severity.Error, Blocked, "Each of these paths must be printed before another of them: "
                    + string.Join(", ", circle.Select(i => NumberFormatter.Format(i))) + ".", new SourceLocation(Step: circle[0])));
                return null;
            }
            done[next] = true;
            order.Add(next);
        }
        return order;
    }

    private static string Name(PrintPath path, int index)
        => path.Name.Length > 0 ? $"{NumberFormatter.Format(index)} ({path.Name})" : NumberFormatter.Format(index);
}

/// <summary>Tries paths one after the other with the checks of collisions.</summary>
/// <param name="setup">The head, and what is printed on.</param>
/// <param name="travelHeight">Height of travels, mm, above all paths.</param>
internal sealed class OrderTrial(PrintSetup setup, double travelHeight)
{
    // Of half a strand and the cells of the deposit, mm.
    private const double Margin = 2;

    // What is farther away is not touched, mm.
    private readonly double _reach = Margin + setup.Printer.HeadBoxes.Concat(setup.Printer.Gantry)
        .SelectMany(b => new[] { -b.Min.X, b.Max.X, -b.Min.Y, b.Max.Y }).Concat(setup.Printer.HeadOutline.Select(p => p.Radius)).Max();

    private readonly ObjectTop? _object = PrintedSoFar.ObjectOf(setup);

    /// <summary>Paths with the travels up, over and down between them.</summary>
    public IReadOnlyList<Step> Steps(IEnumerable<PrintPath> paths)
    {
        var steps = new List<Step>();
        var at = (Vec3?)null;
        foreach (var path in paths)
        {
            var over = path.Start.WithZ(travelHeight);
            steps.Add(new TravelStep(at is { } from ? [from.WithZ(travelHeight), over, path.Start] : [over, path.Start]));
            steps.Add(path);
            at = path.End;
        }
        return steps;
    }

    /// <summary>True if the head goes through the first of two paths, each of which is free, while it prints the second.</summary>
    public bool Collides(PrintPath first, PrintPath second)
    {
        if (second.Bounds.Min.Z >= first.Bounds.Max.Z) return false;
        var (near, b) = (first.Bounds.Grow(_reach), second.Bounds);
        if (setup.Printer.Gantry.Count == 0 && (near.Min.X > b.Max.X || near.Max.X < b.Min.X)) return false;
        return !(near.Min.Y > b.Max.Y) && !(near.Max.Y < b.Min.Y) && Collides([first, second]);
    }

    /// <summary>True if the head goes through a path while it prints it.</summary>
    public bool Collides(PrintPath path) => Collides([path]);

    private bool Collides(PrintPath[] paths)
    {
        var collides = false;
        var findings = new Findings(setup.Printer, _ => null, _ => null)
        {
            Heard = (code, _) => collides |= code.StartsWith("collision.", StringComparison.Ordinal),
        };
        var check = new DepositCheck(setup, findings, _object);
        var move = default(CheckedMove);
        foreach (var step in Steps(paths)) Show(step, ref move, check);
        Travel(move.End.WithZ(travelHeight), ref move, check);
        return collides;
    }

    private static void Show(Step step, ref CheckedMove move, DepositCheck check)
    {
        if (step is TravelStep travel)
        {
            foreach (var point in travel.Points) Travel(point, ref move, check);
        }
        else if (step is PathStep { Path: var path })
        {
            for (var i = 0; i < path.SegmentCount; i++)
            {
                (move.Kind, move.Role, move.Arc) = (MoveKind.Print, path.Role, path.ArcOf(i));
                move.Deposited = path.LengthOf(i) * path.BeadOf(i).Area;
                Show(path.EndOf(i), path.LengthOf(i), ref move, check);
            }
        }
    }

    private static void Travel(Vec3 to, ref CheckedMove move, DepositCheck check)
    {
        (move.Kind, move.Role, move.Arc) = (MoveKind.Travel, Role.Unspecified, null);
        Show(to, move.End.DistanceTo(to), ref move, check);
    }

    // The head comes to the first point from wherever it is.
    private static void Show(Vec3 to, double length, ref CheckedMove move, DepositCheck check)
    {
        (move.Start, move.End, move.Length) = (move.End, to, length);
        check.Move(move);
        move.StartKnown = true;
        move.Index++;
    }
}
