using System.Xml;

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
    private ThreeMfProject _project = new();
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
        ReadProject();
        for (var i = 0; i < model.Items.Count; i++)
        {
            source.Pulse(i, model.Items.Count);
            var item = model.Items[i];
            if (_project.Plates.Count > 1 && !_project.Plates[0].Contains(item.ObjectId)) continue;
            var pieces = new List<(ThreeMfObject Object, int Id, Affine Map)>();
            if (!Collect(root, item, Affine.Identity, 0, pieces)) return false;
            if (pieces.Count > 0) AddObject(Model(item.Path ?? root)!.Objects[item.ObjectId].Name, item.ObjectId, pieces, Affine.Scale(model.Unit), meshes);
        }
        return true;
    }

    // Parts without settings of their own are one mesh.
    private void AddObject(string name, int id, List<(ThreeMfObject Object, int Id, Affine Map)> pieces, Affine unit, List<NamedMesh> meshes)
    {
        _project.Objects.TryGetValue(id, out var known);
        var common = known?.Settings ?? [];
        var whole = new MeshBuilder(pieces.Sum(p => p.Object.Mesh!.VertexCount), pieces.Sum(p => p.Object.Mesh!.TriangleCount));
        var others = new List<NamedMesh>();
        var painted = new List<ThreeMfPaint>();
        foreach (var (piece, pieceId, map) in pieces)
        {
            var placed = map.Then(unit);
            painted.AddRange(piece.Paint.Select(p => p with { A = placed.Apply(p.A), B = placed.Apply(p.B), C = placed.Apply(p.C) }));
            var volumes = known?.Parts.Where(p => p.First >= 0).ToArray() ?? [];
            if (volumes.Length < 2) Add(known?.Parts.FirstOrDefault(p => p.First < 0 ? p.Id == pieceId : true), piece.Mesh!, placed);
            else foreach (var volume in volumes) Add(volume, piece.Triangles(volume.First, volume.Last), placed);
        }
        var mesh = whole.ToMesh(source.Name, false, source.Diagnostics);
        if (mesh.TriangleCount > 0 || others.Count == 0) meshes.Add(new NamedMesh(known?.Name ?? name, mesh) { Settings = common });
        meshes.AddRange(others);
        Painted("supports", painted.Where(p => !p.IsSeam && !p.IsBlocked), ThreeMfPaint.Bodies, "subtype", "support_enforcer");
        Painted("no supports", painted.Where(p => !p.IsSeam && p.IsBlocked), ThreeMfPaint.Bodies, "subtype", "support_blocker");
        Painted("seam", painted.Where(p => p.IsSeam && !p.IsBlocked), ThreeMfPaint.Faces, "painted", "seam");
        if (painted.Any(p => p.IsSeam && p.IsBlocked))
            source.Note(Severity.Note, "mesh.unsupported", "Faces painted to have no seam are ignored.");

        void Add(ThreeMfPart? part, TriMesh mesh, Affine map)
        {
            var own = part?.Settings.Where(s => s.Key != "name" && s.Value is not ("ModelPart" or "normal_part")).ToArray() ?? [];
            var builder = own.Length > 0 ? new MeshBuilder(mesh.VertexCount, mesh.TriangleCount) : whole;
            builder.Append(mesh, map);
            if (own.Length == 0) return;
            var settings = new Dictionary<string, string>(common);
            foreach (var pair in own) settings[pair.Key] = pair.Value;
            var made = builder.ToMesh(source.Name, false, source.Diagnostics);
            others.Add(new NamedMesh($"{known!.Name ?? name}: {part!.Name ?? "part"}", made) { Settings = settings });
        }

        void Painted(string what, IEnumerable<ThreeMfPaint> faces, Func<IEnumerable<ThreeMfPaint>, TriMesh> made, string key, string value)
        {
            if (made(faces) is { TriangleCount: > 0 } mesh)
                meshes.Add(new NamedMesh($"{known?.Name ?? name}: painted {what}", mesh) { Settings = new Dictionary<string, string> { [key] = value } });
        }
    }

    private void ReadProject()
    {
        if (ThreeMfProject.Paths.Select(Entry).FirstOrDefault(e => e is not null) is not { } entry) return;
        using var stream = entry.Open();
        using var xml = XmlReader.Create(stream, ThreeMfParser.Settings(Math.Min(int.MaxValue - 1024, GzipReader.Limit(source.Length))));
        _project = ThreeMfProject.Read(xml);
        if (_project.Plates.Count > 1)
            source.Note(Severity.Warning, "mesh.plates", $"The project has {NumberFormatter.Format(_project.Plates.Count)} plates. Only the first is read.");
    }

    private bool Collect(string part, ThreeMfUse use, Affine outer, int depth, List<(ThreeMfObject Object, int Id, Affine Map)> parts)
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
            parts.Add((item, use.ObjectId, map));
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
            using var xml = XmlReader.Create(stream, ThreeMfParser.Settings(1 << 20));
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
