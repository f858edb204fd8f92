using System.Collections.Generic;
using System.Linq;
using Caterpillar.Simulation;

namespace Caterpillar.Tests;

/// <summary>The planned trapezoids of a timeline in order.</summary>
internal static class PlannedTrapezoids
{
    public static IEnumerable<Trapezoid> Trapezoids(this Timeline timeline) => Enumerable.Range(0, timeline.Motion.Count).Select(i => timeline.Motion[i]);
}
