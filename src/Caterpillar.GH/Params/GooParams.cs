using Rhino.Commands;
using Rhino.Input;

namespace Caterpillar.GH.Params;

/// <summary>Data that comes from components only.</summary>
public abstract class VolatileParam<T>(string name, string nickname, string description, string panel)
    : GH_Param<T>(name, nickname, description, PluginInfo.Tab, panel, GH_ParamAccess.item)
    where T : class, IGH_Goo
{
    public override GH_Exposure Exposure => GH_Exposure.septenary | GH_Exposure.obscure;

    protected override Bitmap? Icon => Icons.Load(Icons.NameOf(GetType()));
}

/// <summary>Data that a user may also store in the definition. Text that cannot be read is answered with the reason.</summary>
public abstract class StoredParam<T>(string name, string nickname, string description, string panel)
    : GH_PersistentParam<T>(name, nickname, description, PluginInfo.Tab, panel)
    where T : class, IGH_Goo
{
    public override GH_Exposure Exposure => GH_Exposure.septenary | GH_Exposure.obscure;

    protected override Bitmap? Icon => Icons.Load(Icons.NameOf(GetType()));

    protected override T PreferredCast(object data) => TextProblem.Read(this, InstantiateT(), data)!;

    protected override void OnVolatileDataCollected() => TextProblem.Clean(m_data, goo => !goo.IsValid);

    /// <summary>Asks for text on Rhino's command line, which works on every platform.</summary>
    protected override GH_GetterResult Prompt_Singular(ref T value)
    {
        var text = "";
        if (RhinoGet.GetString(Question, false, ref text) != Result.Success || Made(text) is not { } made) return GH_GetterResult.cancel;
        value = made;
        return GH_GetterResult.success;
    }

    /// <summary>Asks until an empty answer.</summary>
    protected override GH_GetterResult Prompt_Plural(ref List<T> values)
    {
        var all = new List<T>();
        var text = "";
        while (RhinoGet.GetString(Question, true, ref text) == Result.Success && Made(text) is { } made)
        {
            all.Add(made);
            text = "";
        }
        if (all.Count == 0) return GH_GetterResult.cancel;
        values = all;
        return GH_GetterResult.success;
    }

    /// <summary>The prompt.</summary>
    private protected virtual string Question => $"{Name} profile";

    /// <summary>The value of an answer. Null if it can't be read.</summary>
    private protected virtual T? Made(string text)
    {
        if (string.IsNullOrWhiteSpace(text)) return null;
        var made = InstantiateT();
        return made.CastFrom(text.Trim()) ? made : null;
    }
}
