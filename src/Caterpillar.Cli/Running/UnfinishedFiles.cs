namespace Caterpillar.Cli;

/// <summary>Files that are being written. They are removed if the program must end at once.</summary>
internal sealed class UnfinishedFiles
{
    private readonly List<AtomicFile> _files = [];

    public void Add(AtomicFile file)
    {
        lock (_files) _files.Add(file);
    }

    public void Remove(AtomicFile file)
    {
        lock (_files) _files.Remove(file);
    }

    /// <summary>Removes them while others still write.</summary>
    public void Delete()
    {
        lock (_files) _files.ForEach(f => f.Abandon());
    }
}
