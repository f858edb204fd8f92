using System;
using System.Collections.Generic;
using System.IO;

namespace Caterpillar.GH.Tests.Api;

/// <summary>
/// Facts that the lists do not contain, each with a public source. A line is <c>kind subject | source</c>; the kinds are <c>public</c> and <c>protected</c> for
/// a
/// member,
/// <c>base</c> for <c>type : base</c>, and <c>abstract</c> for a member that types of ours must implement.
/// </summary>
internal sealed class AllowList
{
    public HashSet<string> Public { get; } = new(StringComparer.Ordinal);

    public HashSet<string> Protected { get; } = new(StringComparer.Ordinal);

    public HashSet<string> Bases { get; } = new(StringComparer.Ordinal);

    public HashSet<string> Abstract { get; } = new(StringComparer.Ordinal);

    /// <summary>Entries that a check has used.</summary>
    public HashSet<string> Used { get; } = new(StringComparer.Ordinal);

    public static AllowList Read(string file)
    {
        var list = new AllowList();
        foreach (var line in File.ReadAllLines(file))
        {
            if (line.Length == 0 || line[0] == '#') continue;
            var bar = line.IndexOf(" | ", StringComparison.Ordinal);
            if (bar < 0 || !line.Substring(bar + 3).StartsWith("http", StringComparison.Ordinal)) throw new InvalidDataException("No source: " + line);
            var space = line.IndexOf(' ');
            var subject = line.Substring(space + 1, bar - space - 1).Trim();
            var set = line.Substring(0, space) switch
            {
                "public" => list.Public,
                "protected" => list.Protected,
                "base" => list.Bases,
                "abstract" => list.Abstract,
                var kind => throw new InvalidDataException("No such kind: " + kind),
            };
            set.Add(subject);
        }
        return list;
    }

    public bool Allows(HashSet<string> set, string subject) => set.Contains(subject) && Used.Add(subject) | true;
}
