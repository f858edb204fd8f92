using Caterpillar.GH.Base;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.Planning;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Components.Path;

/// <summary>Reverses or rotates paths so that they start near the end of the previous one.</summary>
public sealed class OrientPathsComponent() : CaterpillarComponent(
    "Orient Paths", "Orient",
        "Keeps the order of print paths, and reverses or rotates each to start near the end of the previous one.", Panel.Path, GH_Exposure.secondary)
{
    public override Guid ComponentGuid => new("b290ed56-f49f-4df9-98de-9e1484c57e53");

    private protected override void Inputs(InputPorts ports)
    {
        ports.PrintPaths();
        ports.Boolean("Reverse", "Re", "Allow open paths to be printed from their other end.", true);
        ports.Boolean("Rotate", "Ro", "Allow closed paths to start at any vertex.", true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Paths", "P", "Print paths, in the same order.", GH_ParamAccess.list);
        ports.Number("Travel", "T", "Total distance from the end of each path to the start of the next, in mm.");
    }

    private protected override void Solve(Run run)
    {
        var paths = run.Paths(0);
        var options = new SortOptions(SortRule.Orient, run.Get<bool>(1), run.Get<bool>(2));
        var oriented = run.Work("Orienting", [paths, options], (_, _) =>
        {
            var sorted = PathSorter.Sort(paths.Paths, options);
            return new Oriented(paths.Goos.Zip(sorted, (goo, path) => goo.With(path)).ToArray(), PathSorter.TravelBetween(paths.Paths),
                PathSorter.TravelBetween(sorted));
        });
        run.SetList(0, oriented.Paths);
        run.Set(1, oriented.Travel);
        run.Summarize($"{NumberFormatter.Format(oriented.Before, 1)} → {NumberFormatter.Format(oriented.Travel, 1)} mm");
    }

    private sealed record Oriented(PrintPathGoo[] Paths, double Before, double Travel);
}
