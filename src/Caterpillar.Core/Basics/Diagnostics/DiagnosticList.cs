namespace Caterpillar.Basics;

/// <summary>
/// Collects diagnostics while something is read or computed. Problems of one kind (same code and severity) are kept once,
/// with the message and location of the first and a count, in the order of first appearance. Not thread-safe.
/// </summary>
public sealed class DiagnosticList
{
    private readonly List<Diagnostic> _items = [];
    private readonly Dictionary<(string Code, Severity Severity), int> _index = [];

    /// <summary>True if at least one error was added.</summary>
    public bool HasErrors { get; private set; }

    /// <summary>Adds a finding, or increases the count of its kind.</summary>
    public void Add(Severity severity, string code, string message, SourceLocation? source = null, int count = 1)
        => Add(new Diagnostic(severity, code, message, source, count));

    /// <inheritdoc cref="Add(Severity, string, string, SourceLocation?, int)"/>
    public void Add(Diagnostic diagnostic)
    {
        if (diagnostic is null) throw new ArgumentNullException(nameof(diagnostic));
        HasErrors |= diagnostic.Severity == Severity.Error;
        var kind = (diagnostic.Code, diagnostic.Severity);
        if (_index.TryGetValue(kind, out var at))
        {
            _items[at] = _items[at] with { Count = _items[at].Count + diagnostic.Count };
            return;
        }
        _index.Add(kind, _items.Count);
        _items.Add(diagnostic);
    }

    /// <inheritdoc cref="Add(Severity, string, string, SourceLocation?, int)"/>
    public void AddRange(IEnumerable<Diagnostic> diagnostics)
    {
        foreach (var diagnostic in diagnostics) Add(diagnostic);
    }

    /// <summary>True if the list has a finding of this kind, so that its message need not be built again.</summary>
    public bool Contains(string code, Severity severity) => _index.ContainsKey((code, severity));

    /// <summary>The findings so far, as an immutable copy.</summary>
    public IReadOnlyList<Diagnostic> ToList() => _items.ToArray();
}
