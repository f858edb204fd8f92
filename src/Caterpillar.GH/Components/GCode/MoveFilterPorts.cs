using Caterpillar.Geometry;
using Caterpillar.GH.Base;
using Caterpillar.GH.Conversion;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Components.GCode;

/// <summary>The ports by which components choose moves: roles, layers and a box.</summary>
internal static class MoveFilterPorts
{
    public static void Declare(InputPorts ports)
    {
        ports.Choices<Role>("Roles", "R", "Roles of the moves that are meant, such as Outer Wall or Infill; without any all are.");
        ports.OptionalInteger("First Layer", "F", "Number of the first layer that is meant, from 0; without it there is no limit.");
        ports.OptionalInteger("Last Layer", "L", "Number of the last layer that is meant, from 0; without it there is no limit.");
        ports.Geometry("Box", "B", "Geometry in whose bounding box a move ends that is meant, in document units; without it everywhere.", optional: true);
    }

    /// <summary>The filter of the four ports from <paramref name="first"/> on.</summary>
    public static MoveFilter Read(Run run, int first)
    {
        var filter = new MoveFilter { Roles = run.Choices<Role>(first), FirstLayer = run.MaybeValue<int>(first + 1), LastLayer = run.MaybeValue<int>(first + 2) };
        if (run.Maybe<IGH_GeometricGoo>(first + 3) is not { } geometry) return filter;
        var box = geometry.Boundingbox;
        if (!box.IsValid) throw new InputProblem("Box has no extent.");
        var units = run.Units;
        return filter with { Region = new Bounds(RhinoGeometry.ToVec(box.Min, units), RhinoGeometry.ToVec(box.Max, units)) };
    }
}
