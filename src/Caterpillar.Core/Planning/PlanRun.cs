using System;
using System.Collections.Generic;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Planning;

/// <summary>Planning with resolved rules: checks the steps, sorts them, writes the moves.</summary>
internal static class PlanRun
{
    public static Result<Plan> Run(IReadOnlyList<Step> steps, PlanRules rules, PlanOptions options, IProgress<double>? progress, CancellationToken cancel)
    {
        var diagnostics = new DiagnosticList();
        for (var i = 0; i < steps.Count; i++) CheckTool(steps[i], i, rules.Tools.Length, diagnostics);
        if (diagnostics.HasErrors) return new Result<Plan>(null, diagnostics.ToList());
        if (steps.Count == 0) diagnostics.Add(Severity.Warning, "plan.empty", "There is nothing to plan.");

        if (TooMuch(steps, options.Memory) is { } tooMuch)
        {
            diagnostics.Add(tooMuch);
            return new Result<Plan>(null, diagnostics.ToList());
        }
        var sort = rules.AddsNothing ? new SortOptions(SortRule.None) : options.Sort with { Start = options.Start };
        var ordered = StepOrder.Find(steps, sort, progress.Part(0, 0.5), cancel);
        var counts = new PlanReport();
        for (var i = 1; i < ordered.Length; i++)
        {
            if (ordered[i - 1].Path is { } before && ordered[i].Path is { } after) counts.SortedTravel += before.End.DistanceTo(after.Start);
            if (steps[i - 1] is PathStep a && steps[i] is PathStep b) counts.UnsortedTravel += a.Path.End.DistanceTo(b.Path.Start);
        }
        var toolpath = new StepPlanner(rules, ordered, options, counts, diagnostics).Run(progress.Part(0.5, 1), cancel);
        if (counts.EmptySegments > 0)
            diagnostics.Add(Severity.Remark, "plan.repeated_point", "A path repeats a point; the segment without length is dropped.", null,
                counts.EmptySegments);
        progress?.Report(1);
        return new Result<Plan>(new Plan(toolpath, counts), diagnostics.ToList());
    }

    // Every segment becomes a move.
    private static Diagnostic? TooMuch(IReadOnlyList<Step> steps, MemoryLimit memory)
    {
        double moves = 0;
        foreach (var step in steps) moves += step is PathStep path ? path.Path.RawPoints.Length : 1;
        return memory.Refuse(moves * ToolpathBlock.BytesPerMove, $"A toolpath of {NumberFormatter.Format(moves, 0)} moves");
    }

    private static void CheckTool(Step step, int index, int tools, DiagnosticList diagnostics)
    {
        if (step is null) throw new ArgumentException("A step is null.", nameof(step));
        var tool = step switch { PathStep p => p.Path.Tool, EventStep { Event: ToolEvent e } => e.Tool, _ => 0 };
        if (tool >= 0 && tool < tools) return;
        diagnostics.Add(
            Severity.Error, "plan.unknown_tool",
                $"Tool {NumberFormatter.Format(tool)} is requested, but the printer has {NumberFormatter.Format(tools)}, counted from 0.",
            new SourceLocation(Step: index));
    }
}
