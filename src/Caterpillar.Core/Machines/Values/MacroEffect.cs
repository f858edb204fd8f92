namespace Caterpillar.Machines;

/// <summary>What a macro of a printer does, as its key <c>macros</c> declares: <c>START_PRINT=homes heats</c>.</summary>
/// <param name="Name">Its name, in capitals.</param>
/// <param name="Homes">It homes all axes.</param>
/// <param name="Heats">It heats the nozzle.</param>
/// <param name="Cools">It switches the heaters off.</param>
internal sealed record MacroEffect(string Name, bool Homes, bool Heats, bool Cools)
{
    /// <summary>What is declared of a macro; null = nothing.</summary>
    public static MacroEffect? Of(ValueList<string> macros, string name)
        => macros.Select(line => Parse(line, out _)).FirstOrDefault(m => m is not null && m.Name == name);

    /// <summary>The first error in declarations, or null.</summary>
    public static Diagnostic? Error(ValueList<string> lines) => lines
        .Select((line, i) => Parse(line, out var problem) is null
            ? new Diagnostic(Severity.Error, "profile.macro", problem, new SourceLocation(Line: i + 1)) : null)
        .FirstOrDefault(d => d is not null);

    private static MacroEffect? Parse(string line, out string problem)
    {
        var parts = line.Split(['='], 2);
        var name = parts[0].Trim().ToUpperInvariant();
        var words = parts.Length < 2 ? [] : parts[1].Split([' ', ','], StringSplitOptions.RemoveEmptyEntries);
        var unknown = words.FirstOrDefault(w => w is not ("harmless" or "homes" or "heats" or "cools"));
        problem = name.Length == 0 || name.Any(c => !(char.IsLetterOrDigit(c) || c is '_' or '.')) ? $"\"{parts[0]}\" is not the name of a macro."
            : parts.Length == 2 && words.Length == 0 ? $"{name} needs harmless, homes, heats or cools after the equals sign."
            : unknown is not null ? $"{name} has \"{unknown}\". Use harmless, homes, heats or cools." : "";
        return problem.Length > 0 ? null : new MacroEffect(name, words.Contains("homes"), words.Contains("heats"), words.Contains("cools"));
    }
}
