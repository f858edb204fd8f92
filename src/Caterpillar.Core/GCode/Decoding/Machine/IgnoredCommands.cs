using System.Text;
using Caterpillar.Flavors;

namespace Caterpillar.GCode;

/// <summary>Commands without effect on the toolpath, by name, and their counts.</summary>
internal sealed class IgnoredCommands(FlavorRules rules, LineDiagnostics diagnostics)
{
    private const int MaxNames = 1000;
    private const int MaxShown = 20;
    private readonly SortedDictionary<string, int> _counts = new(StringComparer.Ordinal);

    public IReadOnlyDictionary<string, int> Counts => _counts;

    public void Add(char letter, double number)
    {
        var name = letter + NumberFormatter.Format(number is > -1e6 and < 1e6 ? number : 0, 1);
        Add(name);
        foreach (var other in rules.NotFollowed)
        {
            if (other == name) NotFollowed(name);
        }
    }

    public void Add(string name)
    {
        if (_counts.TryGetValue(name, out var count)) _counts[name] = count + 1;
        else if (_counts.Count < MaxNames) _counts.Add(name, 1);
        else _counts["others"] = _counts.TryGetValue("others", out var others) ? others + 1 : 1;
    }

    public void NotFollowed(string name)
        => diagnostics.Warn("gcode.unsupported_motion",
            $"{rules.Title}: {name} moves the head or shifts its coordinates, but the decoder cannot follow it. Positions after it may be wrong.");

    /// <summary>Adds one note about everything that was ignored.</summary>
    public void Report()
    {
        if (_counts.Count == 0) return;
        var names = new StringBuilder();
        var total = 0;
        var shown = 0;
        foreach (var pair in _counts)
        {
            total += pair.Value;
            if (shown++ < MaxShown)
            {
                names.Append(names.Length > 0 ? ", " : "").Append(pair.Key).Append(" (").Append(NumberFormatter.Format(pair.Value)) .Append(')');
            }
        }
        if (_counts.Count > MaxShown) names.Append(" and ").Append(NumberFormatter.Format(_counts.Count - MaxShown)).Append(" more");
        diagnostics.List.Add(Severity.Note, "gcode.ignored", "Commands without effect on the toolpath: " + names + ".", count: total);
    }
}
