namespace Caterpillar.GCode;

/// <summary>Reads the extrusions of a toolpath, forward only.</summary>
internal sealed class ExtrusionCursor(Toolpath toolpath)
{
    private int _block;
    private int _index;

    /// <summary>The first extrusion of a line after this one, or null.</summary>
    public Move? After(int line)
    {
        for (; _block < toolpath.Blocks.Count; _block++, _index = 0)
        {
            var c = toolpath.Blocks[_block].Columns;
            for (; _index < c.Count; _index++)
            {
                if (c.Kind[_index] == MoveKind.Print && c.Source[_index] > line) return toolpath[toolpath.FirstOf(_block) + _index];
            }
        }
        return null;
    }
}
