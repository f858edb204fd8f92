using System.Collections.Generic;
using Caterpillar.Geometry;

namespace Caterpillar.Toolpaths;

/// <summary>Collects the moves of an edited block.</summary>
internal sealed class BlockEditor
{
    private readonly ToolpathBuilder _builder = new(MoveSource.Lines, null);

    public void Add(Vec3 end, double e, double deposited, double speed, MoveKind kind, Role role, int layer, int tool, int source, Arc? arc)
        => _builder.Add(end, e, deposited, speed, kind, role, layer, tool, source, arc);

    public IReadOnlyList<ToolpathBlock> ToBlocks() => _builder.Build([]).Blocks;
}
