#if NET
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace Caterpillar.Tests.Architecture;

/// <summary>Inside a room of Core each folder uses only folders before it. Where types live is read from the debug information.</summary>
public class FolderOrderTests
{
    // Stated in CONTRIBUTING.md.
    private static readonly Dictionary<string, string[]> Orders = Stated();

    private static readonly List<FolderUse> Uses =
        FolderUses.Of(typeof(Caterpillar.Basics.Diagnostic).Assembly.Location, Path.Combine(TestData.Repository, "src", "Caterpillar.Core"));

    [TestCaseSource(nameof(Rooms))]
    public void Folders_of_a_room_use_only_those_before_them(string room)
        => Assert.That(FolderOrder.Offenses(Uses, room, Orders[room]), Is.Empty);

    [Test]
    public void Every_room_with_folders_has_an_order()
    {
        var folders = Uses.SelectMany(u => new[] { u.From, u.To }).Distinct();
        Assert.That(folders.Where(f => f.Contains('/')).Select(f => f.Split('/')[0]).Distinct(), Is.SubsetOf(Orders.Keys));
    }

    [Test]
    public void A_use_against_the_order_is_found()
    {
        var offenses = FolderOrder.Offenses(Uses, "Toolpaths", ["Editing", "Paths", "Deposits", "Moves"]);
        Assert.That(offenses, Has.Some.StartsWith("Toolpaths: Editing uses Moves: "));
    }

    private static IEnumerable<string> Rooms() => Orders.Keys;

    private static Dictionary<string, string[]> Stated()
        => File.ReadLines(Path.Combine(TestData.Repository, "CONTRIBUTING.md"))
            .SkipWhile(line => line != "| room | folders, lowest first |").Skip(2).TakeWhile(line => line.StartsWith("|", StringComparison.Ordinal))
            .Select(line => line.Split('|')).ToDictionary(cells => cells[1].Trim(), cells => cells[2].Split(',').Select(folder => folder.Trim()).ToArray());
}
#endif
