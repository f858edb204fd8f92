using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.GH.Base;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.Planning;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Components.Path;

/// <summary>Turns paths so that they begin near the end of the one before.</summary>
public sealed class OrientPathsComponent() : CaterpillarComponent(
    "Orient Paths", "Orient", "Keeps the order of paths, and turns or rotates each so that it begins near the end of the one before.", Panel.Path,
        GH_Exposure.secondary)
{
    public override Guid ComponentGuid => new("b290ed56-f49f-4df9-98de-9e1484c57e53");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Paths", "P", "Paths in the order in which they are printed.", GH_ParamAccess.list);
        ports.Boolean("Reverse", "Re", "True where open paths may be printed from their other end.", true);
        ports.Boolean("Rotate", "Ro", "True where closed paths may begin at any of their vertices.", true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Paths", "P", "The same paths in the same order.", GH_ParamAccess.list);
        ports.Number("Way", "W", "Length of the ways from the end of each path to the start of the next, in mm.");
    }

    private protected override void Solve(Run run)
    {
        var goos = run.List<PrintPathGoo>(0);
        var paths = goos.Select(g => g.Value).ToArray();
        var options = new SortOptions(SortRule.Orient, run.Get<bool>(1), run.Get<bool>(2));
        var oriented = run.Cached([.. paths, options], () => PathSorter.Sort(paths, options));
        var way = PathSorter.WayBetween(oriented);
        run.SetList(0, goos.Zip(oriented, (goo, path) => goo.With(path)));
        run.Set(1, way);
        run.Summarize($"{NumberFormatter.Format(PathSorter.WayBetween(paths), 1)} → {NumberFormatter.Format(way, 1)} mm");
    }
}
