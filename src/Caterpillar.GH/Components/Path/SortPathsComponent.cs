namespace Caterpillar.GH.Components.Path;

/// <summary>Sorts print paths for short travel.</summary>
public sealed class SortPathsComponent() : CaterpillarComponent(
    "Sort Paths", "Sort", "Sorts print paths for short travel moves, or keeps their order and only turns them to start near the end of the "
        + "previous one (Orient).", Panel.Path)
{
    public override Guid ComponentGuid => new("b1d0a5ee-6f0e-4b7c-9a55-61c2f1a7d3e4");

    private protected override void Inputs(InputPorts ports)
    {
        ports.PrintPaths();
        ports.Choice("Rule", "R", "Sorting rule. None: as given. Orient: as given, each from its nearest end. Nearest: from each end to the nearest start. "
            + "Layer: by layer. Z: by lowest point. Tour: shortest tour found.", SortRule.Nearest);
        ports.Boolean("Reverse", "Re", "Allow open paths to be printed from their other end.", true);
        ports.Boolean("Rotate", "Ro", "Allow closed paths to start at any vertex.", true);
        ports.Add(new Param_Point(), "Start", "S", "Start position of the print head. Default: the first path stays first.", optional: true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Paths", "P", "Sorted print paths, reversed and rotated if allowed.", GH_ParamAccess.list);
        ports.Integer("Indices", "I", "Index of each path in the input, from 0.", GH_ParamAccess.list);
        ports.Number("Travel", "T", "Total distance from the end of each path to the start of the next, in mm.");
    }

    private protected override void Solve(Run run)
    {
        var paths = run.Paths(0);
        var start = run.MaybePoint(4);
        if (start is { IsFinite: false }) throw new InputProblem("Start must have finite coordinates.");
        var options = new SortOptions(run.Choice<SortRule>(1), run.Get<bool>(2), run.Get<bool>(3), start);
        var sorted = run.Work("Sorting", [paths, options], (progress, cancel) => Sorted.Of(paths, options, progress, cancel));
        run.SetList(0, sorted.Paths);
        run.SetList(1, sorted.Indices);
        run.Set(2, sorted.Travel);
        run.Summarize($"{NumberFormatter.Format(sorted.Travel, 1)} mm of {NumberFormatter.Format(sorted.Before, 1)}");
    }

    private sealed record Sorted(PrintPathGoo[] Paths, GH_Integer[] Indices, double Before, double Travel)
    {
        // Paths sorted here are printed in this order: they leave the groups of the slicer, unless each keeps its place.
        public static Sorted Of(PathList list, SortOptions options, IProgress<double> progress, CancellationToken cancel)
        {
            var paths = list.Paths;
            var order = PathSorter.Order(paths, options, progress, cancel);
            var placed = order.Select(place => place.Of(paths[place.Index])).ToArray();
            return new Sorted(placed.Select((p, i) => Goo(p, list.Goos[order[i].Index], options.Rule)).ToArray(),
                order.Select(place => new GH_Integer(place.Index)).ToArray(),
                PathSorter.TravelBetween(paths), PathSorter.TravelBetween(placed));
        }

        private static PrintPathGoo Goo(PrintPath path, PrintPathGoo before, SortRule rule)
            => rule is SortRule.None or SortRule.Orient ? before.With(path) : new PrintPathGoo(path, before.Setup);
    }
}
