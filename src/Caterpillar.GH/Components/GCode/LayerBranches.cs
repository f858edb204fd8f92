using Grasshopper.Kernel.Data;

namespace Caterpillar.GH.Components.GCode;

/// <summary>A branch for each layer of a toolpath. A move without a layer belongs to the branch of the move before it.</summary>
internal sealed class LayerBranches
{
    private readonly Toolpath _toolpath;
    private readonly GH_Path _root;
    private readonly int _lowest;
    private GH_Path? _path;

    public LayerBranches(Toolpath toolpath, GH_Path root)
    {
        (_toolpath, _root) = (toolpath, root);
        // Numbers of rafts may begin below 0, branches do not.
        var numbers = toolpath.NumbersOfLayers();
        _lowest = numbers.Count > 0 ? Math.Min(numbers[0], 0) : 0;
    }

    /// <summary>The branch of the last move that was asked for.</summary>
    public GH_Path Path => _path ??= _root.AppendElement(0);

    /// <summary>The branch of the layer of a move. Null without a layer.</summary>
    public GH_Path? PathOf(Move move) => _toolpath.NumberOfLayer(move) is { } number ? _root.AppendElement(number - _lowest) : null;

    /// <summary>Goes on to the next move. True if its branch is another one than that of the last.</summary>
    public bool Changes(Move move)
    {
        if (_path is not null && (_toolpath.NumberOfLayer(move) is not { } number || _path.Indices[_path.Length - 1] == number - _lowest)) return false;
        _path = PathOf(move) ?? Path;
        return true;
    }
}
