#if NET
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace Caterpillar.Tests.Architecture;

/// <summary>Inside a room of Core each folder uses only folders before it. Where types live is read from the debug information.</summary>
public class FolderOrderTests
{
    // Lowest first; the dot is what lies in the room's own folder.
    private static readonly Dictionary<string, string[]> Orders = new()
    {
        ["Basics"] = [".", "Numbers", "Diagnostics"],
        ["Files"] = ["Streams", ".", "Gzip", "Images"],
        ["Geometry"] =
        [
            ".", "Curves", "Regions/Engine", "Regions", "Thickness",
            "Meshes", "Meshes/Files", "Meshes/Repair", "Meshes/Scalars", "Meshes/Sections",
        ],
        ["Toolpaths"] = ["Paths", "Moves", "Deposits", "Editing"],
        ["Dialects"] = ["Rules", "Firmware", "."],
        ["Machines"] = [".", "Values", "Templates", "Keys", "Settings", "Setups", "Profiles", "Import"],
        ["Turtles"] = [".", "Commands", "LSystems", "Programs"],
        ["Drawings"] = ["Curves", "Tables", "Svg", "."],
        ["Slicing"] = ["Infill", "Walls", "Work", "Models", "Cutting", "Outlines", "Areas", "Seams", "Bed", "Supports", "Pipeline"],
        ["Curved"] = ["Surfaces", "Boundaries", "Fields", "Bending", "Lifting", "Patches", "Pipeline"],
        ["Planning"] = ["Sorting", "Rules", "Moves", "Travels", "."],
        ["GCode"] =
        [
            "Text", "Binary", "Documents",
            "Decoding/Parsing", "Decoding/State", "Decoding/Machine", "Decoding/Comments", "Decoding/Commands", "Decoding",
            "Writing",
            "Editing/Lines", "Editing/Plan", "Editing/Comments", "Editing/Moves", "Editing",
        ],
        ["Simulation"] = ["Limits", "Motion", "."],
        ["Display"] = [".", "Viewing"],
        ["Checks"] = ["Findings", "Moves", "Deposits", "WholeFiles", "Runs", "ReadingBack", "Writing"],
    };

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
}
#endif
