using Caterpillar.Geometry;
using Caterpillar.GH.Base;
using Caterpillar.GH.Conversion;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Components.GCode;

/// <summary>The ports by which components choose moves: roles, layers, objects and a box.</summary>
internal static class MoveFilterPorts
{
    public const int Count = 5;

    public static void Declare(InputPorts ports)
    {
        ports.Choices<Role>("Roles", "R", "Roles of the moves that are meant, such as Outer Wall or Infill; without any all are.");
        ports.OptionalInteger("First Layer", "F", "Number of the first layer that is meant, from 0; without it there is no limit.");
        ports.OptionalInteger("Last Layer", "L", "Number of the last layer that is meant, from 0; without it there is no limit.");
        ports.Text("Objects", "O", "Names of the objects that are meant, as the file has them; without any all are.", access: GH_ParamAccess.list,
            optional: true);
        ports.Geometry("Box", "B", "Geometry in whose bounding box a move ends that is meant, in document units; without it everywhere.", optional: true);
    }

    /// <summary>The filter of the ports from <paramref name="first"/> on.</summary>
    public static MoveFilter Read(Run run, int first)
    {
        var objects = run.List<string>(first + 3);
        var filter = new MoveFilter
        {
            Roles = run.Choices<Role>(first),
            FirstLayer = run.MaybeValue<int>(first + 1),
            LastLayer = run.MaybeValue<int>(first + 2),
            Objects = objects.Count > 0 ? objects : null,
        };
        if (run.Maybe<IGH_GeometricGoo>(first + 4) is not { } geometry) return filter;
        var box = geometry.Boundingbox;
        if (!box.IsValid) throw new InputProblem("Box has no extent.");
        var units = run.Units;
        return filter with { Region = new Bounds(RhinoGeometry.ToVec(box.Min, units), RhinoGeometry.ToVec(box.Max, units)) };
    }

    /// <summary>What a filter says, to compare it by.</summary>
    public static object?[] Key(MoveFilter filter)
        => [filter with { Roles = null, Objects = null }, string.Join(",", filter.Roles ?? []), string.Join("\n", filter.Objects ?? [])];

    /// <summary>The same for what bends or moves a print: start and end code, which are in no layer, stay.</summary>
    public static MoveFilter ReadLayers(Run run, int first, Toolpath toolpath) => Read(run, first).InLayersOf(toolpath);
}
