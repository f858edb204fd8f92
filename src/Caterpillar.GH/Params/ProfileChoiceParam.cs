namespace Caterpillar.GH.Params;

/// <summary>
/// A port for a profile: its menu lists the installed ones. It also takes the name or the file of a profile as text, and a profile from a wire. Numbers of
/// names stay the same when profiles are added.
/// </summary>
public abstract class ProfileChoiceParam<T> : Param_Integer
    where T : class, IGH_Goo, new()
{
    private const string NameKey = "ProfileName";
    private const string StoredKey = "StoredProfile";
    private readonly Dictionary<int, string> _names = [];

    // Internalized profiles. In the file they are numbers, too: Grasshopper reads plain integers back.
    private Dictionary<int, T> _stored = [];

    // The names of the installed profiles.
    private readonly Func<ProfileLibrary, IReadOnlyList<string>> _installed;

    private protected ProfileChoiceParam(string name, Func<ProfileLibrary, IReadOnlyList<string>> installed)
    {
        _installed = installed;
        Name = name;
        NickName = name;
        Refresh();
    }

    public override GH_Exposure Exposure => GH_Exposure.hidden;

    public override string TypeName => new T().TypeName;

    protected override Bitmap? Icon => Icons.Load(Icons.NameOf(GetType()));

    /// <summary>Lists the profiles that are installed now.</summary>
    public void Refresh()
    {
        ClearNamedValues();
        foreach (var name in _installed(Profiles.Library))
        {
            AddNamedValue(name, NumberOf(name));
            _names[NumberOf(name)] = name;
        }
    }

    /// <summary>Number of a name in the menu and in files: FNV-1a without its sign.</summary>
    public static int NumberOf(string name)
    {
        var hash = 2166136261u;
        foreach (var c in name) hash = unchecked((hash ^ c) * 16777619u);
        return (int)(hash & 0x7fffffff);
    }

    // The names that were chosen, for a place where they are not installed.
    public override bool Write(GH_IWriter writer)
    {
        var chosen = PersistentData.AllData(true).OfType<GH_Integer>().Select(i => i.Value).Where(_names.ContainsKey).Distinct().ToArray();
        for (var i = 0; i < chosen.Length; i++) writer.SetString(NameKey, i, _names[chosen[i]]);
        var stored = new Dictionary<int, T>();
        foreach (var item in PersistentData.AllData(true).OfType<GH_Integer>())
        {
            if (ProfileOf(item) is not { } profile) continue;
            item.Value = stored.Count;
            profile.Write(writer.CreateChunk(StoredKey, stored.Count));
            stored.Add(stored.Count, profile);
        }
        _stored = stored;
        return base.Write(writer);
    }

    public override bool Read(GH_IReader reader)
    {
        for (var i = 0; reader.ItemExists(NameKey, i); i++) _names[NumberOf(reader.GetString(NameKey, i))] = reader.GetString(NameKey, i);
        _stored = [];
        for (var i = 0; reader.ChunkExists(StoredKey, i); i++)
        {
            var profile = new T();
            profile.Read(reader.FindChunk(StoredKey, i));
            _stored.Add(i, profile);
        }
        var read = base.Read(reader);
        Refresh();
        return read;
    }

    protected override GH_Integer InstantiateT() => new ProfileChoice<T>();

    protected override GH_Integer? PreferredCast(object data)
    {
        if (data is ProfileChoice<T>) return null;
        if (Wrapped.Text(data) is { } text) return Read(text);
        if (Wrapped.Number(data) is { } number) return new GH_Integer((int)number);
        var choice = new ProfileChoice<T>();
        return choice.CastFrom(data) ? choice : null;
    }

    // Numbers from the menu become profiles. What is not found is null on the wire.
    protected override void OnVolatileDataCollected()
    {
        foreach (var path in m_data.Paths)
        {
            var branch = m_data.EnsurePath(path);
            for (var i = 0; i < branch.Count; i++)
            {
                if (branch[i] is { } number and not ProfileChoice<T>)
                {
                    branch[i] = ProfileOf(number) is { } profile ? new ProfileChoice<T>(profile)
                        : Read(_names.TryGetValue(number.Value, out var name) ? name : "unknown");
                }
                if (branch[i] is ProfileChoice<T> { IsValid: false }) branch[i] = null!;
            }
        }
    }

    private T? ProfileOf(GH_Integer item)
        => item is ProfileChoice<T> choice ? choice.Profile : _stored.TryGetValue(item.Value, out var profile) ? profile : null;

    private ProfileChoice<T> Read(string text)
    {
        var profile = new T();
        if (!profile.CastFrom(FileOf(text.Trim())))
            AddRuntimeMessage(GH_RuntimeMessageLevel.Error, $"{Name}: {(profile as IReadsText)?.Problem}");
        return new ProfileChoice<T>(profile);
    }

    // Files are relative to the definition.
    private string FileOf(string text)
    {
        if (!text.EndsWith(".json", StringComparison.OrdinalIgnoreCase) || OnPingDocument() is not { IsFilePathDefined: true } document) return text;
        return System.IO.Path.Combine(System.IO.Path.GetDirectoryName(document.FilePath)!, text);
    }
}

/// <summary>A choice among the installed printers.</summary>
public sealed class PrinterChoiceParam() : ProfileChoiceParam<PrinterGoo>("Printer", l => l.Names<Printer>())
{
    public override Guid ComponentGuid => new("2a9d1f60-52c3-4f7e-9b0b-6a5c0f1d7e21");
}

/// <summary>A choice among the installed materials.</summary>
public sealed class MaterialChoiceParam() : ProfileChoiceParam<MaterialGoo>("Material", l => l.Names<Material>())
{
    public override Guid ComponentGuid => new("7b4c8e03-91da-4e25-8d6f-3f2b9a0c5d22");
}

/// <summary>A choice among the installed print settings.</summary>
public sealed class SettingsChoiceParam() : ProfileChoiceParam<SettingsGoo>("Settings", l => l.Names<PrintSettings>())
{
    public override Guid ComponentGuid => new("c15e7d92-08ab-4b3d-a6f4-8d0e1b7c4f23");
}
