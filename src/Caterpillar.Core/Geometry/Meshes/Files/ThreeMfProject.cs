using System.Xml;

namespace Caterpillar.Geometry;

/// <summary>A part of an object in a project: an object of its own, or a range of triangles.</summary>
internal sealed class ThreeMfPart(int id, int first, int last)
{
    public int Id { get; } = id;

    public int First { get; } = first;

    public int Last { get; } = last;

    /// <summary>Keys of the slicer with their values.</summary>
    public Dictionary<string, string> Settings { get; } = new(StringComparer.Ordinal);

    /// <summary>Parts of an object.</summary>
    public List<ThreeMfPart> Parts { get; } = [];

    public string? Name => Settings.TryGetValue("name", out var name) && name.Length > 0 ? name : null;
}

/// <summary>
/// What a project of PrusaSlicer (<c>Slic3r_PE_model.config</c>), OrcaSlicer or Bambu Studio (<c>model_settings.config</c>) says of its objects: settings,
/// parts and plates.
/// </summary>
internal sealed class ThreeMfProject
{
    public static readonly string[] Paths = ["Metadata/Slic3r_PE_model.config", "Metadata/model_settings.config"];

    /// <summary>The objects by their IDs.</summary>
    public Dictionary<int, ThreeMfPart> Objects { get; } = [];

    /// <summary>The objects of each plate.</summary>
    public List<HashSet<int>> Plates { get; } = [];

    public static ThreeMfProject Read(XmlReader xml)
    {
        var project = new ThreeMfProject();
        ThreeMfPart? item = null, part = null;
        while (xml.Read())
        {
            if (xml.NodeType == XmlNodeType.EndElement && xml.LocalName is "part" or "volume") part = null;
            if (xml.NodeType != XmlNodeType.Element) continue;
            switch (xml.LocalName)
            {
                case "object":
                    item = project.Objects[Number("id")] = new ThreeMfPart(Number("id"), 0, 0);
                    part = null;
                    break;
                case "part" or "volume" when item is not null:
                    part = new ThreeMfPart(Number("id"), Number("firstid"), Number("lastid"));
                    if (xml.GetAttribute("subtype") is { } subtype) part.Settings["subtype"] = subtype;
                    item.Parts.Add(part);
                    break;
                case "plate":
                    item = part = null;
                    project.Plates.Add([]);
                    break;
                case "metadata" when xml.GetAttribute("key") is { } key && xml.GetAttribute("value") is { } value:
                    if (item is not null && !IsPlain(key, value)) (part ?? item).Settings[key] = value;
                    else if (key == "object_id" && project.Plates.Count > 0) project.Plates[project.Plates.Count - 1].Add(Number("value"));
                    break;
                case "assemble":
                    return project;
            }
        }
        return project;

        // What says nothing about how a part is printed.
        static bool IsPlain(string key, string value)
            => key == "matrix" || (key == "extruder" && value is "0" or "1") || key.StartsWith("source_", StringComparison.Ordinal);

        int Number(string attribute) => NumberReader.TryParseInt(xml.GetAttribute(attribute), out var number) ? number : -1;
    }
}
