namespace Caterpillar.GH.Base;

/// <summary>Declares the outputs of a component.</summary>
internal sealed class OutputPorts(GH_Component.GH_OutputParamManager manager)
{
    public const string DiagnosticsName = "Diagnostics";

    private const GH_ParamAccess Item = GH_ParamAccess.item;

    public void Number(string name, string nick, string description, GH_ParamAccess access = Item) => Add(new Param_Number(), name, nick, description, access);

    public void Integer(string name, string nick, string description, GH_ParamAccess access = Item)
        => Add(new Param_Integer(), name, nick, description, access);

    public void Text(string name, string nick, string description, GH_ParamAccess access = Item) => Add(new Param_String(), name, nick, description, access);

    public void Point(string name, string nick, string description, GH_ParamAccess access = Item) => Add(new Param_Point(), name, nick, description, access);

    public void Curve(string name, string nick, string description, GH_ParamAccess access = Item) => Add(new Param_Curve(), name, nick, description, access);

    /// <summary>The diagnostics of the solve. The base class sets them.</summary>
    public void Diagnostics() => Text(DiagnosticsName, "D", "Notes, warnings and errors, one line per kind.", GH_ParamAccess.list);

    /// <summary>A parameter of the plug-in.</summary>
    public void Add(IGH_Param param, string name, string nick, string description, GH_ParamAccess access = Item)
        => manager.AddParameter(param, name, nick, description, access);
}
