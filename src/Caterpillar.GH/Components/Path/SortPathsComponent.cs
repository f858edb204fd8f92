using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.GH.Base;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;

namespace Caterpillar.GH.Components.Path;

/// <summary>Sorts print paths for short travel.</summary>
public sealed class SortPathsComponent() : CaterpillarComponent(
    "Sort Paths", "Sort", "Sorts print paths for short travel; none is lost. Unsorted paths are printed in their order.",
        Panel.Path)
{
    public override Guid ComponentGuid => new("b1d0a5ee-6f0e-4b7c-9a55-61c2f1a7d3e4");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Paths", "P", "Paths to sort.", GH_ParamAccess.list);
        ports.Choice("Rule", "R",
            "The order: as given (None), as given but each from its nearest end (Orient), from each end to the nearest start, by layer, by lowest point, or "
                + "the shortest tour found.",
            SortRule.Nearest);
        ports.Boolean("Reverse", "Re", "True if open paths may be printed from their other end.", true);
        ports.Boolean("Rotate", "Ro", "True if closed paths may start at any of their vertices.", true);
        ports.Add(new Param_Point(), "Start", "S", "Start position of the head, in document units; by default the first path stays first.", optional: true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Paths", "P", "The paths in their new order, reversed and rotated if allowed.", GH_ParamAccess.list);
        ports.Integer("Indices", "I", "Index of each path in the input, from 0.", GH_ParamAccess.list);
        ports.Number("Travel", "T", "Total distance from the end of each path to the start of the next, in mm.");
    }

    private protected override void Solve(Run run)
    {
        var goos = run.List<PrintPathGoo>(0);
        if (goos.Count == 0) throw new InputProblem("Print Paths are missing.") { IsMissing = true };
        var paths = goos.Select(g => g.Value).ToArray();
        var start = run.MaybeValue<Rg.Point3d>(4) is { } point ? RhinoGeometry.ToVec(point, run.Units) : (Caterpillar.Geometry.Vec3?)null;
        if (start is { IsFinite: false }) throw new InputProblem("Start must be a point with finite coordinates.");
        var options = new SortOptions(run.Choice<SortRule>(1), run.Get<bool>(2), run.Get<bool>(3), start);
        var order = run.Work("Sorting", [.. paths, options], (progress, cancel) => PathSorter.Order(paths, options, progress, cancel));
        var sorted = order.Select(place => Placed(paths[place.Index], place)).ToArray();
        // Paths sorted here are printed in this order: they leave the groups of the slicer.
        run.SetList(0, sorted.Select(path => new PrintPathGoo(path)));
        run.SetList(1, order.Select(place => place.Index));
        var travel = PathSorter.TravelBetween(sorted);
        run.Set(2, travel);
        run.Summarize($"{NumberFormatter.Format(travel, 1)} mm of {NumberFormatter.Format(PathSorter.TravelBetween(paths), 1)}");
    }

    private static PrintPath Placed(PrintPath path, PathPlacement place)
        => place.Reversed ? path.Reversed() : place.Vertex > 0 ? path.StartingAt(place.Vertex) : path;
}
