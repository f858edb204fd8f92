namespace Caterpillar.GH.Components.GCode;

/// <summary>The end of each move as a plane, with its speed and flow, as trees with a branch per layer.</summary>
internal sealed class ToolpathFrames
{
    private const double Parallel = 1e-9;
    private Vec3 _ahead = Vec3.UnitX;

    public ToolpathFrames(Toolpath toolpath, DocumentUnits units, GH_Path root, CancellationToken cancel)
    {
        var axes = Kinematics.Guess(toolpath);
        foreach (var (move, path) in new LayerBranches(toolpath, root).Moves())
        {
            if ((move.Index & 0xFFF) == 0) cancel.ThrowIfCancellationRequested();
            var tool = axes is not null && toolpath.TurnsOf(move.Index) is { } turns ? axes.Direction(turns) : Vec3.UnitZ;
            var flow = move.Length > 0 && toolpath.VolumeOf(move) is { } volume ? volume / move.Length * move.Speed : 0;
            Planes.Append(new GH_Plane(RhinoGeometry.ToPlane(FrameAt(move, tool), units)), path);
            Speeds.Append(new GH_Number(move.Speed), path);
            Flows.Append(new GH_Number(flow), path);
            Kinds.Append(new GH_String(move.Kind.ToString()), path);
        }
    }

    public GH_Structure<GH_Plane> Planes { get; } = new();

    public GH_Structure<GH_Number> Speeds { get; } = new();

    public GH_Structure<GH_Number> Flows { get; } = new();

    public GH_Structure<GH_String> Kinds { get; } = new();

    // Along the motion as far as it is across the tool. In place and along the tool, the last direction holds.
    private Frame FrameAt(Move move, Vec3 tool)
    {
        var across = Across(move.End - move.Start, tool);
        if (across.Length > Parallel) _ahead = across;
        var ahead = Across(_ahead, tool);
        if (!(ahead.Length > Parallel)) ahead = Vec3.Cross(Math.Abs(tool.Y) < 0.9 ? Vec3.UnitY : Vec3.UnitZ, tool);
        return Frame.FromAxes(move.End, ahead, Vec3.Cross(tool, ahead));
    }

    private static Vec3 Across(Vec3 motion, Vec3 tool) => motion - tool * Vec3.Dot(motion, tool);
}
