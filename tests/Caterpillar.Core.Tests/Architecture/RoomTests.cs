using System;
using System.Collections.Generic;
using System.Linq;
using Mono.Cecil;
using NUnit.Framework;

namespace Caterpillar.Tests.Architecture;

/// <summary>Reads the compiled Core and checks which of its rooms uses which.</summary>
public class RoomTests
{
    private static readonly string[] Data = ["Basics", "Files", "Geometry", "Expressions", "Toolpaths", "Flavors", "Machines"];

    private static readonly Dictionary<string, string[]> Allowed = new()
    {
        ["Basics"] = [],
        ["Files"] = ["Basics"],
        ["Geometry"] = ["Basics", "Files"],
        ["Expressions"] = ["Basics", "Files"],
        ["Toolpaths"] = ["Basics", "Files", "Geometry", "Expressions"],
        ["Flavors"] = ["Basics", "Files", "Geometry", "Expressions", "Toolpaths"],
        ["Machines"] = ["Basics", "Files", "Geometry", "Expressions", "Toolpaths", "Flavors"],
        ["Turtles"] = [.. Data, "Traces", "Shaping"],
        ["Traces"] = Data,
        ["Drawings"] = Data,
        ["Slicing"] = Data,
        ["Curved"] = [.. Data, "Slicing"],
        ["Shaping"] = Data,
        ["Planning"] = Data,
        ["GCode"] = Data,
        ["Simulation"] = Data,
        ["Display"] = Data,
        ["Checks"] = [.. Data, "Planning", "GCode", "Simulation", "Display"],
        ["Jobs"] = [.. Data, "Turtles", "Traces", "Drawings", "Slicing", "Curved", "Shaping", "Planning", "GCode", "Simulation", "Display", "Checks"],
    };

    private static readonly Lazy<(string From, string To, string Where)[]> OfCore
        = new(() => Uses(typeof(Caterpillar.Basics.Diagnostic).Assembly.Location).ToArray());

    [Test]
    public void Rooms_depend_downwards_only()
    {
        var offences = OfCore.Value
            .Where(u => u.From != u.To && !(Allowed.TryGetValue(u.From, out var allowed) && allowed.Contains(u.To)))
            .Select(u => $"{u.From} uses {u.To}: {u.Where}")
            .Distinct().OrderBy(t => t, StringComparer.Ordinal).ToArray();
        Assert.That(offences, Is.Empty);
    }

    [Test]
    public void Every_room_is_known()
    {
        using var assembly = AssemblyDefinition.ReadAssembly(typeof(Caterpillar.Basics.Diagnostic).Assembly.Location);
        var rooms = assembly.MainModule.Types.Where(t => t.Namespace.StartsWith("Caterpillar", StringComparison.Ordinal)).Select(t => t.Namespace).Distinct();
        Assert.That(rooms, Is.SubsetOf(Allowed.Keys.Select(room => "Caterpillar." + room)));
    }

    [Test]
    public void The_graph_of_rooms_has_no_cycle()
    {
        var uses = OfCore.Value.Where(u => u.From != u.To).Select(u => (u.From, u.To)).Distinct().ToList();
        // Rooms that use no remaining room are removed until none is left; a cycle is never removed.
        while (uses.Count > 0 && uses.RemoveAll(u => uses.All(other => other.From != u.To)) > 0)
        {
        }
        Assert.That(uses, Is.Empty);
    }

    [Test]
    public void The_check_sees_uses_in_method_bodies()
    {
        // Toolpaths certainly calls Geometry from a method body; if the reader missed bodies, this would be absent.
        Assert.That(OfCore.Value.Any(u => u.From == "Toolpaths" && u.To == "Geometry" && u.Where.Contains("ToolpathSums::Add")), Is.True);
    }

    [Test]
    public void Core_keeps_no_static_state_that_can_change()
    {
        using var assembly = AssemblyDefinition.ReadAssembly(typeof(Caterpillar.Basics.Diagnostic).Assembly.Location);
        var fields = assembly.MainModule.Types.SelectMany(Nested)
            .Where(t => t.Namespace.StartsWith("Caterpillar", StringComparison.Ordinal) || t.DeclaringType is not null)
            .Where(t => !t.Name.StartsWith("<", StringComparison.Ordinal))
            .SelectMany(t => t.Fields)
            .Where(f => f.IsStatic && !f.IsInitOnly && !f.IsLiteral && !f.Name.StartsWith("<", StringComparison.Ordinal))
            .Select(f => f.FullName).ToArray();
        Assert.That(fields, Is.Empty);
    }

    private static IEnumerable<(string From, string To, string Where)> Uses(string file)
    {
        using var assembly = AssemblyDefinition.ReadAssembly(file);
        foreach (var type in assembly.MainModule.Types.SelectMany(Nested))
        {
            var from = Room(type);
            if (from is null) continue;
            foreach (var (used, where) in TypeUses.Of(type))
            {
                if (Room(used) is { } to) yield return (from, to, where);
            }
        }
    }

    private static IEnumerable<TypeDefinition> Nested(TypeDefinition type) => new[] { type }.Concat(type.NestedTypes.SelectMany(Nested));

    private static string? Room(TypeReference type)
    {
        while (type.DeclaringType is not null) type = type.DeclaringType;
        var name = type.Namespace;
        return name.StartsWith("Caterpillar.", StringComparison.Ordinal) ? name.Substring("Caterpillar.".Length).Split('.')[0] : null;
    }
}
