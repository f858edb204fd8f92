using System.Collections.Generic;
using System.Linq;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Tests.Host;

internal static class Structures
{
    /// <summary>All items of a tree, in order, with nulls.</summary>
    public static IEnumerable<IGH_Goo?> AllGoos(this IGH_Structure data)
        => Enumerable.Range(0, data.PathCount).SelectMany(i => data.get_Branch(i).Cast<IGH_Goo?>());
}
