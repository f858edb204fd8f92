using Grasshopper.Kernel.Data;

namespace Caterpillar.GH.Components.GCode;

/// <summary>The end of each move as a plane, with its speed and flow, as trees with a branch per layer. Arcs become chords.</summary>
internal sealed class ToolpathFrames
{
    private const double ChordTolerance = 0.01;
    private const double Parallel = 1e-9;
    private Vec3 _ahead = Vec3.UnitX;

    public ToolpathFrames(Toolpath toolpath, DocumentUnits units, GH_Path root, CancellationToken cancel)
    {
        var axes = ToolTilt.AxesOf(toolpath);
        var layers = new LayerBranches(toolpath, root);
        foreach (var move in toolpath.Moves())
        {
            if ((move.Index & 0xFFF) == 0) cancel.ThrowIfCancellationRequested();
            layers.Changes(move);
            var tool = axes is { } known && toolpath.TurnsOf(move.Index) is { } turns ? ToolTilt.Direction(known, turns) : Vec3.UnitZ;
            var flow = move.Length > 0 && toolpath.VolumeOf(move) is { } volume ? volume / move.Length * move.Speed : 0;
            var (speed, rate, kind) = (new GH_Number(move.Speed), new GH_Number(flow), new GH_String(move.Kind.ToString()));
            var parts = move.Arc?.ChordCount(move.Start, ChordTolerance) ?? 1;
            var last = move.Start;
            for (var k = 1; k <= parts; k++)
            {
                var end = k == parts ? move.End : move.Arc!.Value.PointAt(move.Start, move.End, (double)k / parts);
                Planes.Append(new GH_Plane(RhinoGeometry.ToPlane(FrameAt(end, end - last, tool), units)), layers.Path);
                Speeds.Append(speed, layers.Path);
                Flows.Append(rate, layers.Path);
                Kinds.Append(kind, layers.Path);
                last = end;
            }
        }
    }

    public GH_Structure<GH_Plane> Planes { get; } = new();

    public GH_Structure<GH_Number> Speeds { get; } = new();

    public GH_Structure<GH_Number> Flows { get; } = new();

    public GH_Structure<GH_String> Kinds { get; } = new();

    // Along the motion as far as it is across the tool. In place and along the tool, the last direction holds.
    private Frame FrameAt(Vec3 tip, Vec3 motion, Vec3 tool)
    {
        var across = motion - tool * Vec3.Dot(motion, tool);
        if (across.LengthSquared > Parallel * Parallel) _ahead = across;
        var ahead = _ahead - tool * Vec3.Dot(_ahead, tool);
        if (!(ahead.LengthSquared > Parallel * Parallel)) ahead = Vec3.Cross(Math.Abs(tool.Y) < 0.9 ? Vec3.UnitY : Vec3.UnitZ, tool);
        return Frame.FromAxes(tip, ahead, Vec3.Cross(tool, ahead));
    }
}
