using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry.Meshes;

[TestFixture]
public class MeshBadInputTests
{
    public static IEnumerable<TestCaseData> Files()
    {
        yield return new TestCaseData(MeshBytes.BinaryStl(), "x.stl").SetArgDisplayNames("binary STL");
        yield return new TestCaseData(MeshBytes.TextStl(), "x.stl").SetArgDisplayNames("ASCII STL");
        yield return new TestCaseData(MeshBytes.Obj(), "x.obj").SetArgDisplayNames("OBJ");
        yield return new TestCaseData(MeshBytes.TextPly(), "x.ply").SetArgDisplayNames("ASCII PLY");
        yield return new TestCaseData(MeshBytes.BinaryPly(false), "x.ply").SetArgDisplayNames("little-endian PLY");
        yield return new TestCaseData(MeshBytes.BinaryPly(true), "x.ply").SetArgDisplayNames("big-endian PLY");
        yield return new TestCaseData(MeshBytes.ThreeMf(), "x.3mf").SetArgDisplayNames("3MF");
        yield return new TestCaseData(MeshBytes.Gzip(MeshBytes.Obj()), "x.obj.gz").SetArgDisplayNames("gzip");
    }

    [TestCaseSource(nameof(Files))]
    public void Truncated_files_give_diagnostics(byte[] bytes, string name)
    {
        for (var length = 0; length < bytes.Length; length += length < 400 ? 1 : 3)
        {
            var read = Read(bytes.Take(length).ToArray(), name);
            // A text file may end in the middle of its last number or line end without anybody being able to tell.
            if (length < bytes.Length - 4 && read.Value is not null) Assert.That(read.Diagnostics, Is.Not.Empty, $"{length} bytes");
        }
    }

    [TestCaseSource(nameof(Files))]
    public void Mutated_files_never_throw(byte[] bytes, string name)
    {
        var random = new Random(20261);
        for (var round = 0; round < 1500; round++)
        {
            var copy = (byte[])bytes.Clone();
            var changes = 1 + random.Next(6);
            for (var i = 0; i < changes; i++)
            {
                copy[random.Next(copy.Length)] = random.Next(3) switch
                {
                    0 => (byte)random.Next(256),
                    1 => (byte)" \n-.0123456789e/<>\""[random.Next(19)],
                    _ => copy[random.Next(copy.Length)],
                };
            }
            var from = random.Next(copy.Length);
            if (round % 5 == 0) copy = [.. copy.Take(from), .. copy.Skip(from + random.Next(40))];
            Read(copy, name);
        }
    }

    [Test]
    public void Garbage_never_throws()
    {
        var random = new Random(4);
        foreach (var name in new[] { "x.stl", "x.obj", "x.ply", "x.3mf", "x", "x.gz" })
        {
            for (var round = 0; round < 200; round++)
            {
                var bytes = new byte[random.Next(600)];
                random.NextBytes(bytes);
                if (round % 4 == 0) MeshBytes.Text("ply\n").Take(bytes.Length).ToArray().CopyTo(bytes, 0);
                if (round % 4 == 1) MeshBytes.Text("PK\u0003\u0004").Take(bytes.Length).ToArray().CopyTo(bytes, 0);
                if (round % 4 == 2) MeshBytes.Text("solid facet ").Take(bytes.Length).ToArray().CopyTo(bytes, 0);
                Read(bytes, name);
            }
        }
    }

    private static Caterpillar.Basics.Result<IReadOnlyList<NamedMesh>> Read(byte[] bytes, string name)
    {
        var read = MeshReader.Read(bytes, name);
        Assert.That(read.Value is null, Is.EqualTo(read.HasErrors));
        foreach (var mesh in read.Value ?? [])
        {
            var bounds = mesh.Mesh.Bounds;
            var sections = MeshSections.At(mesh.Mesh, [bounds.Center.Z, bounds.Max.Z], new SectionOptions { Threads = 1 });
            Assert.That(sections.Value!.All(s => s.Loops.All(l => l.Count >= 3 && l.Points.All(p => p.IsFinite))));
        }
        return read;
    }
}
