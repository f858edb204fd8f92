using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;

namespace Caterpillar.Package;

/// <summary>A package for Rhino's package manager: a zip with a manifest, an icon, and the plug-in with the libraries it needs. The same files give the same
/// bytes.</summary>
internal sealed class YakPackage
{
    private const string Plugin = "Caterpillar.GH";
    private const string Id = "f3ff75ca-289b-45b6-9986-65dad16f12ef";

    // What Rhino brings along must not be in a package: it would be loaded twice.
    private static readonly string[] Hosts = ["RhinoCommon", "Grasshopper", "GH_IO", "GH_Util", "Rhino.UI", "Eto", "Ed.Eto", "System.Drawing.Common",
        "Microsoft.Win32.SystemEvents"];

    private readonly SortedDictionary<string, byte[]> _entries = new(StringComparer.Ordinal);

    private YakPackage(string version, string tag, string icon, string texts)
    {
        FileName = $"caterpillar-{version}-{tag}.yak";
        _entries.Add("manifest.yml", Encoding.UTF8.GetBytes(Manifest(version)));
        _entries.Add("icon.png", File.ReadAllBytes(icon));
        foreach (var name in new[] { "LICENSE", "THIRD-PARTY-NOTICES.md" }) _entries.Add(name, File.ReadAllBytes(Path.Combine(texts, name)));
    }

    /// <summary>Name, version, and the oldest Rhino it is for.</summary>
    public string FileName { get; }

    /// <summary>For Rhino 8 on .NET Framework and, from 8.20 on, on .NET.</summary>
    /// <exception cref="InvalidOperationException">A build lacks the plug-in, or holds a library of Rhino.</exception>
    public static YakPackage ForRhino8(string net48, string net8, string icon, string texts, string version)
    {
        var package = new YakPackage(version, "rh8_20-any", icon, texts);
        package.Add(net48, "net48/");
        package.Add(net8, "net8.0/");
        return package;
    }

    /// <summary>For Rhino 7, which knows no folders.</summary>
    /// <inheritdoc cref="ForRhino8" path="/exception"/>
    public static YakPackage ForRhino7(string net48, string icon, string texts, string version)
    {
        // The oldest version that it is compiled against.
        var package = new YakPackage(version, "rh7_37-any", icon, texts);
        package.Add(net48, "");
        return package;
    }

    public void Write(Stream stream)
    {
        using var zip = new ZipArchive(stream, ZipArchiveMode.Create, leaveOpen: true);
        foreach (var entry in _entries)
        {
            var made = zip.CreateEntry(entry.Key, CompressionLevel.Optimal);
            made.LastWriteTime = new DateTimeOffset(2000, 1, 1, 0, 0, 0, TimeSpan.Zero);
            using var content = made.Open();
            content.Write(entry.Value, 0, entry.Value.Length);
        }
    }

    private static string Manifest(string version) => $"""
        name: caterpillar
        version: {version}
        authors:
        - The Caterpillar authors
        description: Turns designs into 3D-printer motion, and G-code back into toolpaths.
        icon: icon.png
        keywords:
        - 3d-printing
        - g-code
        - slicer
        - turtle
        - toolpath
        - guid:{Id}

        """;

    // Every library of the build, whatever they are: what is needed later is not forgotten.
    private void Add(string folder, string at)
    {
        var files = Directory.Exists(folder) ? Directory.GetFiles(folder, "*.dll").Concat(Directory.GetFiles(folder, "*.gha")).ToArray() : [];
        foreach (var file in files)
        {
            var name = Path.GetFileNameWithoutExtension(file);
            if (Hosts.Contains(name)) throw new InvalidOperationException($"{file} belongs to Rhino and must not be packed.");
            // The plug-in itself is a .gha there.
            var entry = at + (name == Plugin ? Plugin + ".gha" : Path.GetFileName(file));
            _entries[entry] = File.ReadAllBytes(file);
        }
        if (!_entries.ContainsKey(at + Plugin + ".gha")) throw new InvalidOperationException($"{folder} holds no {Plugin}: build the release first.");
    }
}
