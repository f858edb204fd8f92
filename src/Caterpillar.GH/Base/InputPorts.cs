namespace Caterpillar.GH.Base;

/// <summary>Declares the inputs of a component. Descriptions end with a period and name the unit. Ports of several components are declared here once.</summary>
internal sealed class InputPorts(GH_Component.GH_InputParamManager manager, List<DeclaredPort> declared)
{
    private const GH_ParamAccess Item = GH_ParamAccess.item;

    // The default of the parameter that is added next.
    private object? _default;
    private PortCondition[] _conditions = [];

    /// <summary>Ports for some values of a choice port, which is declared before. Nested conditions must all hold.</summary>
    public void For<T>(string port, IEnumerable<T> values, Action declare)
        where T : struct, Enum
    {
        var outer = _conditions;
        _conditions = [.. outer, new PortCondition(port, [.. values.Select(v => Convert.ToInt32(v, System.Globalization.CultureInfo.InvariantCulture))])];
        declare();
        _conditions = outer;
    }

    public void Number(string name, string nick, string description, double? fallback = null, bool optional = false)
        => Add(Default(new Param_Number(), fallback), name, nick, description, optional: optional);

    /// <summary>An angle: degrees, or radians if the user switches the port.</summary>
    public void Angle(string name, string nick, string description, double? fallback = null, bool optional = false)
        => Add(Default(new Param_Number { AngleParameter = true, UseDegrees = true }, fallback), name, nick, description, optional: optional);

    public void Integer(string name, string nick, string description, int? fallback = null, GH_ParamAccess access = Item, bool optional = false)
        => Add(Default(new Param_Integer(), fallback), name, nick, description, access, optional);

    public void Boolean(string name, string nick, string description, bool fallback)
        => Add(Default(new Param_Boolean(), fallback), name, nick, description, Item);

    public void Text(string name, string nick, string description, string? fallback = null, GH_ParamAccess access = Item, bool optional = false)
        => Add(Default(new Param_String { Optional = optional }, fallback), name, nick, description, access);

    /// <summary>A file that expires the component when it changes on the disk.</summary>
    public void File(string name, string nick, string description, string filter, bool optional = false)
        => Add(new Param_FilePath { FileFilter = filter, ExpireOnFileEvent = true, Optional = optional }, name, nick, description, Item);

    /// <summary>A file to write: its changes expire nothing.</summary>
    public void Target(string name, string nick, string description, string filter)
        => Add(new Param_FilePath { FileFilter = filter }, name, nick, description, Item);

    /// <summary>Several choices among the values of an enum. None means all.</summary>
    public void Choices<T>(string name, string nick, string description)
        where T : struct, Enum
        => Add(ChoiceParam.Of<T>(), name, nick, description, GH_ParamAccess.list, optional: true);

    /// <summary>Several choices among the values of an enum, at first one of them.</summary>
    public void Choices<T>(string name, string nick, string description, T fallback)
        where T : struct, Enum
        => Choice(name, nick, description, fallback, GH_ParamAccess.list);

    /// <summary>A choice among the values of an enum: a number, a name, or the menu of the port.</summary>
    public void Choice<T>(string name, string nick, string description, T fallback, GH_ParamAccess access = Item)
        where T : struct, Enum
        => Add(Default(ChoiceParam.Of<T>(), Convert.ToInt32(fallback, System.Globalization.CultureInfo.InvariantCulture)), name, nick, description, access);

    /// <summary>The print paths that a component changes.</summary>
    public void PrintPaths() => Add(new PrintPathParam(), "Print Paths", "P", "Print paths, in printing order.", GH_ParamAccess.list);

    public void Toolpath() => Add(new ToolpathParam(), "Toolpath", "T", "Toolpath, from Plan Toolpath or Decode G-code.");

    /// <summary>The moves that a component works on.</summary>
    public void Filter() => Add(new MoveFilterParam(), "Filter", "F", "Moves to select, from Move Filter. Default: all.", optional: true);

    public void Bead(string more = "Default: line width and layer height of the setup.")
        => Add(new BeadParam(), "Bead", "B", "Bead, or its width in mm. " + more, optional: true);

    /// <summary>Printer, material, settings and what is printed on. <paramref name="more"/> states their use and the default.</summary>
    public void Setup(string more = "Default: generic.")
        => Add(new SetupParam(), "Setup", "Se", "Print setup, or the name of a printer profile. " + more, optional: true);

    /// <summary>A profile: from the menu, by name, from a file or from a wire.</summary>
    public void Profile(IGH_Param param, string name, string nick, string more, GH_ParamAccess access = Item)
        => Add(param, name, nick, $"Profile from the menu, its name, or a file (JSON). Or {name.ToLowerInvariant()} from another component. " + more,
            access, optional: true);

    /// <summary>Deviation of meshes from curved surfaces.</summary>
    public void MeshTolerance() => Number("Tolerance", "T", "Maximum deviation of the mesh from a curved surface, in mm.", 0.05);

    /// <summary>Length of the segments of curves.</summary>
    public void Subdivision(string nick) => Number("Subdivision", nick, "Maximum segment length on curves, in mm.", 1);

    public void Seed() => Integer("Seed", "Sd", "Seed of the random numbers, from 0.", 0);

    /// <summary>The coordinates of formulas.</summary>
    public void FormulaPlane()
        => Add(new Param_Plane(), "Plane", "Pl", "Plane of the coordinates. Its Z is the axis of the angles. Default: World XY.", optional: true);

    public void Geometry(string name, string nick, string description, GH_ParamAccess access = Item, bool optional = false)
        => Add(new Param_Geometry { Optional = optional }, name, nick, description, access);

    /// <summary>A parameter of the plug-in whose branches become one list, in order. The user may switch that off on the port.</summary>
    public void Flattened(IGH_Param param, string name, string nick, string description)
    {
        param.DataMapping = GH_DataMapping.Flatten;
        Add(param, name, nick, description, GH_ParamAccess.list);
    }

    /// <summary>A parameter of the plug-in.</summary>
    public void Add(IGH_Param param, string name, string nick, string description, GH_ParamAccess access = Item, bool optional = false)
    {
        if (optional) param.Optional = true;
        var shown = _conditions.All(c => c.Values.Contains((int)declared.First(d => d.Param.Name == c.Port).Default!));
        if (shown) manager.AddParameter(param, name, nick, description, access);
        else (param.Name, param.NickName, param.Description, param.Access) = (name, nick, description, access);
        declared.Add(new DeclaredPort(param, !param.Optional && _default is null, _default, _conditions));
        _default = null;
    }

    private TParam Default<TParam>(TParam param, object? value)
        where TParam : IGH_Param
    {
        _default = value;
        if (value is null) return param;
        switch (param)
        {
            case Param_Number number: number.SetPersistentData(new[] { value }); break;
            case Param_Integer integer: integer.SetPersistentData(new[] { value }); break;
            case Param_Boolean boolean: boolean.SetPersistentData(new[] { value }); break;
            case Param_String text: text.SetPersistentData(new[] { value }); break;
        }
        return param;
    }
}
