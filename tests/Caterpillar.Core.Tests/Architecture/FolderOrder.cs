#if NET
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Caterpillar.Tests.Architecture;

/// <summary>An order of the folders of a room or a program: each may use only those before it.</summary>
internal static class FolderOrder
{
    /// <summary>The room's own folder, where it has subfolders too.</summary>
    public const string Root = ".";

    /// <summary>What goes against the order: folders that it does not name, names without a folder, and uses of a folder by one before it.</summary>
    /// <param name="uses">The uses in the assembly.</param>
    /// <param name="room">The folder whose subfolders are ordered; empty for the whole program.</param>
    /// <param name="order">Names of all its folders that hold types, lowest first.</param>
    public static string[] Offenses(IEnumerable<FolderUse> uses, string room, string[] order)
    {
        var inside = uses.Where(u => IsIn(u.From, room) && IsIn(u.To, room)).Select(u => (Use: u, From: Name(u.From, room), To: Name(u.To, room))).ToList();
        var folders = inside.SelectMany(u => new[] { u.From, u.To }).Distinct().ToList();
        return
        [
            .. folders.Except(order).Select(name => $"{room}/{name} is not in the order"),
            .. order.Except(folders).Select(name => $"{room}/{name} holds nothing"),
            .. inside.Where(u => Array.IndexOf(order, u.To) > Array.IndexOf(order, u.From))
                .Select(u => $"{room}: {u.From} uses {u.To}: {u.Use.Where} uses {u.Use.Used}").Distinct().OrderBy(text => text, StringComparer.Ordinal),
        ];
    }

    private static bool IsIn(string folder, string room) => room.Length == 0 || folder == room || folder.StartsWith(room + "/", StringComparison.Ordinal);

    private static string Name(string folder, string room)
    {
        var name = folder.Substring(room.Length).TrimStart('/');
        return name.Length > 0 ? name : Root;
    }
}
#endif
