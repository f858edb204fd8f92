using System.IO.Compression;
using System.Xml;
using Caterpillar.Files;

namespace Caterpillar.Geometry;

/// <summary>
/// Reads 3MF packages: a zip archive with models in XML. Every build item becomes one mesh in mm, with the transforms of the item and of its
/// components applied. An object of the type support or other is ignored.
/// </summary>
internal sealed class ThreeMfReader(MeshSource source, ZipArchive archive)
{
    private const int MaxDepth = 64;
    private const long MaxTriangles = 100_000_000;
    private const int MaxItems = 10_000;
    private const int MaxUses = 1_000_000;

    private readonly Dictionary<string, ThreeMfModel?> _models = new(StringComparer.OrdinalIgnoreCase);
    private long _triangles;
    private int _uses;

    public static bool Read(MeshSource source, List<NamedMesh> meshes)
    {
        try
        {
            using var archive = new ZipArchive(new MemoryStream(source.Bytes, false), ZipArchiveMode.Read);
            return new ThreeMfReader(source, archive).ReadItems(meshes);
        }
        catch (XmlException e)
        {
            return source.Fail("mesh.syntax", "The XML of the model is damaged.", new SourceLocation(source.Name, e.LineNumber, e.LinePosition));
        }
        catch (Exception e) when (e is not OperationCanceledException and not OutOfMemoryException and not DiagnosticException)
        {
            // The runtimes throw different kinds on damaged archives.
            return source.Fail("mesh.compression", "The zip archive is damaged or incomplete.");
        }
    }

    private bool ReadItems(List<NamedMesh> meshes)
    {
        var root = RootPath();
        if (root is null)
            return source.Fail("mesh.empty", "The 3MF package has no 3D model.");
        if (Model(root) is not { } model) return false;
        if (model.Items.Count > MaxItems)
        {
            var (there, most) = (NumberFormatter.Format(model.Items.Count), NumberFormatter.Format(MaxItems));
            return source.Fail("mesh.too_large", $"The plate has {there} items. The maximum is {most}.");
        }
        source.Afford(0, model.Items.Count);
        for (var i = 0; i < model.Items.Count; i++)
        {
            source.Pulse(i, model.Items.Count);
            var item = model.Items[i];
            var parts = new List<(TriMesh Mesh, Affine Map)>();
            if (!Collect(root, item, Affine.Identity, 0, parts)) return false;
            if (parts.Count == 0) continue;
            var builder = new MeshBuilder(parts.Sum(p => p.Mesh.VertexCount), parts.Sum(p => p.Mesh.TriangleCount));
            foreach (var (mesh, map) in parts) builder.Append(mesh, map.Then(Affine.Scale(model.Unit)));
            var name = Model(item.Path ?? root)!.Objects[item.ObjectId].Name;
            meshes.Add(new NamedMesh(name, builder.ToMesh(source.Name, false, source.Diagnostics)));
        }
        return true;
    }

    private bool Collect(string part, ThreeMfUse use, Affine outer, int depth, List<(TriMesh Mesh, Affine Map)> parts)
    {
        var place = new SourceLocation(source.Name, use.Line, use.Column, part);
        if (depth > MaxDepth || ++_uses > MaxUses)
            return source.Fail("mesh.syntax", "Components contain each other, or the file has too many.", place);
        var path = use.Path ?? part;
        if (Model(path) is not { } model) return false;
        if (!model.Objects.TryGetValue(use.ObjectId, out var item))
            return source.Fail("mesh.index", $"Object {NumberFormatter.Format(use.ObjectId)} does not exist.", place);
        if (item.Type is "support" or "other")
        {
            source.Note(Severity.Note, "mesh.ignored", "An object of the type support or other is ignored.", place);
            return true;
        }
        var map = use.Map.Then(outer);
        if (item.Mesh is { TriangleCount: > 0 } mesh)
        {
            _triangles += mesh.TriangleCount;
            if (_triangles > MaxTriangles)
                return source.Fail("mesh.too_large", $"The items have more than {NumberFormatter.Format(MaxTriangles)} triangles in total.", place);
            source.Afford(_triangles, _uses);
            parts.Add((mesh, map));
        }
        return item.Components.All(component => Collect(path, component, map, depth + 1, parts));
    }

    private ThreeMfModel? Model(string path)
    {
        if (_models.TryGetValue(path, out var known)) return known;
        ThreeMfModel? model = null;
        if (Entry(path) is { } entry)
        {
            if (entry.Length > GzipReader.Limit(entry.CompressedLength))
            {
                source.Fail("mesh.compression", GzipReader.TooLarge, new SourceLocation(source.Name, Key: path));
                return null;
            }
            using var stream = entry.Open();
            model = ThreeMfParser.Parse(source, path, stream);
        }
        else
        {
            source.Fail("mesh.syntax", "The 3MF package lacks this part.", new SourceLocation(source.Name, Key: path));
        }
        _models.Add(path, model);
        return model;
    }

    private ZipArchiveEntry? Entry(string path)
    {
        var name = path.TrimStart('/');
        return archive.GetEntry(name)
            ?? archive.Entries.FirstOrDefault(e => string.Equals(e.FullName.Replace('\\', '/').TrimStart('/'), name, StringComparison.OrdinalIgnoreCase));
    }

    // The target of the package's 3D model relationship, or the first part with the usual extension.
    private string? RootPath()
    {
        if (Entry("_rels/.rels") is { } rels)
        {
            using var stream = rels.Open();
            var settings = new XmlReaderSettings { DtdProcessing = DtdProcessing.Prohibit, XmlResolver = null, MaxCharactersInDocument = 1 << 20 };
            using var xml = XmlReader.Create(stream, settings);
            while (xml.Read())
            {
                if (xml.NodeType != XmlNodeType.Element || xml.LocalName != "Relationship") continue;
                var target = xml.GetAttribute("Target");
                var isModel = (xml.GetAttribute("Type") ?? "").EndsWith("/3dmodel", StringComparison.Ordinal);
                if (isModel && target is not null && Entry(target) is not null) return target;
            }
        }
        return archive.Entries.FirstOrDefault(e => e.FullName.EndsWith(".model", StringComparison.OrdinalIgnoreCase))?.FullName;
    }
}
