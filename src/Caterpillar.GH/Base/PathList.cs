namespace Caterpillar.GH.Base;

/// <summary>The print paths of a list input. They stay one object from solve to solve while they stay the same, as part of a key.</summary>
internal sealed class PathList(IReadOnlyList<PrintPathGoo> goos)
{
    public IReadOnlyList<PrintPathGoo> Goos { get; } = goos;

    public PrintPath[] Paths { get; } = goos.Select(g => g.Value).ToArray();

    public int Count => Paths.Length;

    /// <summary>True if these are the same paths in the same steps, made with the same setup.</summary>
    public bool Has(IReadOnlyList<PrintPathGoo> others)
    {
        if (others.Count != Goos.Count) return false;
        for (var i = 0; i < others.Count; i++)
        {
            var (one, other) = (Goos[i], others[i]);
            if (ReferenceEquals(other, one)) continue;
            var same = ReferenceEquals(other.Value, Paths[i]) && other.ToStep() == one.ToStep() && Equals(other.Setup, one.Setup);
            if (!same) return false;
        }
        return true;
    }
}
