namespace Caterpillar.GH.Base;

/// <summary>The print paths of a list input. They stay one object from solve to solve while they stay the same, as part of a key.</summary>
internal sealed class PathList
{
    public PathList(IReadOnlyList<PrintPathGoo> goos)
    {
        Goos = goos;
        Paths = new PrintPath[goos.Count];
        for (var i = 0; i < Paths.Length; i++) Paths[i] = goos[i].Value;
    }

    public IReadOnlyList<PrintPathGoo> Goos { get; }

    public PrintPath[] Paths { get; }

    public int Count => Paths.Length;

    /// <summary>True if these are the same paths in the same steps, made with the same setup.</summary>
    public bool Has(IReadOnlyList<PrintPathGoo> goos)
    {
        if (goos.Count != Goos.Count) return false;
        for (var i = 0; i < goos.Count; i++)
        {
            if (ReferenceEquals(goos[i], Goos[i])) continue;
            var same = ReferenceEquals(goos[i].Value, Paths[i]) && StepList.Same(goos[i].ToStep(), Goos[i].ToStep()) && Equals(goos[i].Setup, Goos[i].Setup);
            if (!same) return false;
        }
        return true;
    }
}
