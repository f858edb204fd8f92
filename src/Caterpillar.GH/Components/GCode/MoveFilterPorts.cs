using Caterpillar.GH.Base;
using Caterpillar.GH.Conversion;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Components.GCode;

/// <summary>The ports that choose moves: roles, layers, objects and a box.</summary>
internal static class MoveFilterPorts
{
    public const int Count = 5;

    public static void Declare(InputPorts ports)
    {
        ports.Choices<Role>("Roles", "R", "Roles of the moves to select, such as Outer Wall or Infill. Default: all.");
        ports.OptionalInteger("First Layer", "F", "First layer, by its number in the file or from 0. Default: no limit.");
        ports.OptionalInteger("Last Layer", "L", "Last layer, by its number in the file or from 0. Default: no limit.");
        ports.Text("Objects", "O", "Names of the objects to select, as in the file. Default: all.", access: GH_ParamAccess.list, optional: true);
        ports.Geometry("Box", "B", "Geometry whose bounding box contains the end points of the moves to select. Default: no limit.", optional: true);
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
        if (!box.IsValid) throw new InputProblem("Box is empty: connect geometry with a valid bounding box.");
        return filter with { Box = RhinoGeometry.ToBounds(box, run.Units) };
    }

    /// <summary>The parts of a filter, for comparison.</summary>
    public static object?[] Key(MoveFilter filter)
        => [filter with { Roles = null, Objects = null }, string.Join(",", filter.Roles ?? []), string.Join("\n", filter.Objects ?? [])];

    /// <summary>The same for edits that deform or move a print: start and end code, which belong to no layer, stay.</summary>
    public static MoveFilter ReadLayers(Run run, int first, Toolpath toolpath) => Read(run, first).InLayersOf(toolpath);
}
