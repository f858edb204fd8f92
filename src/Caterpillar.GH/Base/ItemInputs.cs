namespace Caterpillar.GH.Base;

/// <summary>
/// The inputs of one item of a solve. A missing or wrong input is an <see cref="InputProblem"/> that names its port. Reading one that depends on a result
/// that is not there yet is <see cref="StillWorking"/>, whatever the wire gives: a list could be incomplete, and items could be those of others.
/// </summary>
internal abstract class ItemInputs(CaterpillarComponent component, IGH_DataAccess access, Upstream upstream)
{
    private readonly Dictionary<int, List<IGH_Goo?>> _lists = [];
    private DocumentUnits? _units;

    public GH_Document? Document => Component.OnPingDocument();

    /// <summary>Conversion between document units and mm. Reports once if they differ.</summary>
    public DocumentUnits Units
    {
        get
        {
            if (_units is { } known) return known;
            var units = DocumentUnits.Current;
            if (!units.AreMillimeters)
                Component.AddRuntimeMessage(GH_RuntimeMessageLevel.Remark, $"The document is in {units.Name}. Geometry is scaled to mm.");
            _units = units;
            return units;
        }
    }

    protected CaterpillarComponent Component { get; } = component;

    protected IGH_DataAccess Access { get; } = access;

    protected Upstream Upstream { get; } = upstream;

    /// <summary>
    /// Checks that every connected port that is not required gets data: a failure upstream must not turn into a default. Required items are checked
    /// when they are read. A required list may contain nulls. An optional list may not, because its meaning would change without them.
    /// </summary>
    /// <exception cref="InputProblem">A connected port gets no valid data.</exception>
    public void CheckSources()
    {
        for (var i = 0; i < Component.Params.Input.Count; i++)
        {
            var port = Component.Params.Input[i];
            if (port.SourceCount > 0 && Upstream.Of(i) is null && !Arrives(i, port.Access, Component.IsRequired(i)))
                throw new InputProblem($"{port.Name}: the connected source gives no valid data.");
        }
    }

    /// <summary>Place of an input by its name. A port that is not shown for what is chosen has a negative one, and its default.</summary>
    public int this[string name] => Component.Params.IndexOfInputParam(name) is >= 0 and var place ? place
        : -1 - Component.Declared.Select(d => d.Param.Name).ToList().IndexOf(name);

    /// <summary>A required item.</summary>
    /// <exception cref="InputProblem">It is null or missing.</exception>
    public T Get<T>(int input)
    {
        var value = default(T);
        return Read(input, ref value) && value is not null
            ? value
            : throw new InputProblem($"{Port(input).Name} is missing.") { IsMissing = true };
    }

    /// <summary>An item that may be absent.</summary>
    public T? Maybe<T>(int input)
        where T : class
    {
        var value = default(T);
        return Read(input, ref value) ? value : null;
    }

    /// <inheritdoc cref="Maybe{T}(int)"/>
    public T? MaybeValue<T>(int input)
        where T : struct
    {
        var value = default(T);
        return Read(input, ref value) ? value : null;
    }

    /// <summary>A list without its nulls, which are reported.</summary>
    public List<T> List<T>(int input)
        where T : class
    {
        var goos = Goos(input);
        var some = new List<T>(goos.Count);
        var lost = 0;
        foreach (var goo in goos)
        {
            if (goo is T item) some.Add(item);
            else if (goo is null) lost++;
            else return Converted<T>(input);
        }
        ReportNulls(input, lost);
        return some;
    }

    /// <summary>A list with its nulls, for items that belong to the items of another list.</summary>
    public IReadOnlyList<T?> WithNulls<T>(int input)
        where T : class
        => Goos(input).ConvertAll(goo => goo as T);

    /// <summary>A list with one item at least. Its nulls are reported.</summary>
    /// <exception cref="InputProblem">It is empty.</exception>
    public List<T> Some<T>(int input)
        where T : class
    {
        var items = List<T>(input);
        return items.Count > 0 ? items : throw Missing(input);
    }

    /// <summary>A whole tree with one item at least.</summary>
    /// <exception cref="InputProblem">It is empty.</exception>
    public GH_Structure<T> Tree<T>(int input)
        where T : class, IGH_Goo
        => MaybeTree<T>(input) ?? throw Missing(input);

    /// <summary>A whole tree. Null if it is empty.</summary>
    public GH_Structure<T>? MaybeTree<T>(int input)
        where T : class, IGH_Goo
    {
        Await(input);
        return Access.GetDataTree(input, out GH_Structure<T> tree) && tree.AllData(true).Any() ? tree : null;
    }

    /// <summary>A number greater than zero.</summary>
    /// <exception cref="InputProblem">It is missing, not finite, or not greater than zero.</exception>
    public double Positive(int input)
    {
        var value = Finite(input);
        return value > 0 ? value : throw new InputProblem($"{Port(input).Name} must be greater than zero, not "
            + $"{NumberFormatter.Format(value, 6)}.");
    }

    /// <summary>A number of 0 or more.</summary>
    /// <exception cref="InputProblem">It is missing, not finite, or negative.</exception>
    public double NotNegative(int input) => Finite(input) is >= 0 and var value
        ? value : throw new InputProblem($"{Port(input).Name} must be 0 or more.");

    /// <summary>A number from a least to a greatest value, which <paramref name="meaning"/> states.</summary>
    /// <exception cref="InputProblem">It is missing, or outside.</exception>
    public double Within(int input, double least, double most, string meaning)
        => Finite(input) is var value && value >= least && value <= most
            ? value : throw new InputProblem($"{Port(input).Name} must be {meaning}, not {NumberFormatter.Format(value, 6)}.");

    /// <summary>A finite number. From an angle port always in degrees.</summary>
    public double Finite(int input)
    {
        var value = Get<double>(input);
        if (Port(input) is Param_Number { AngleParameter: true, UseDegrees: false }) value = Angle.ToDegrees(value);
        return !double.IsNaN(value) && !double.IsInfinity(value)
            ? value
            : throw new InputProblem($"{Port(input).Name} must be a finite number.");
    }

    /// <summary>The value of a choice port.</summary>
    /// <exception cref="InputProblem">The number is not one of the choices.</exception>
    public T Choice<T>(int input)
        where T : struct, Enum
        => ToChoice<T>(input, Get<int>(input));

    /// <summary>The values of a port for several choices. Null for none, which means all.</summary>
    /// <inheritdoc cref="Choice" path="/exception"/>
    public IReadOnlyList<T>? Choices<T>(int input)
        where T : struct, Enum
    {
        var numbers = List<GH_Integer>(input);
        return numbers.Count == 0 ? null : numbers.Select(n => ToChoice<T>(input, n.Value)).ToArray();
    }

    /// <summary>The selected moves: all by default.</summary>
    public MoveFilter Filter() => Maybe<MoveFilter>(this["Filter"]) ?? new MoveFilter();

    /// <summary>A point in mm. Null if there is none.</summary>
    public Vec3? MaybePoint(int input) => MaybeValue<Rg.Point3d>(input) is { } point ? RhinoGeometry.ToVec(point, Units) : null;

    /// <summary>A plane as a frame in mm. The world's by default.</summary>
    public Frame FrameOf(int input) => MaybeValue<Rg.Plane>(input) is { } plane ? RhinoGeometry.ToFrame(plane, Units) : Frame.World;

    /// <summary>The full path of a file: relative paths start at the folder of the definition, if it has been saved.</summary>
    public string PathTo(string file)
    {
        var folder = Document is { IsFilePathDefined: true } document ? Path.GetDirectoryName(document.FilePath) : null;
        return Path.GetFullPath(folder is not null && !Path.IsPathRooted(file) ? Path.Combine(folder, file) : file);
    }

    /// <summary>An existing file. The name is read as in <see cref="PathTo"/>.</summary>
    /// <exception cref="InputProblem">It does not exist.</exception>
    public FileInfo FileAt(string name)
    {
        var file = new FileInfo(PathTo(name));
        return file.Exists ? file : throw new InputProblem($"File not found: {file.FullName}");
    }

    /// <summary>A message that names the branch and the item.</summary>
    public void Report(GH_RuntimeMessageLevel level, string message) => Component.AddRuntimeMessage(level, $"{Place()}: {message}");

    /// <summary>The problem of a required input that is missing.</summary>
    public InputProblem Missing(int input)
    {
        var name = Port(input).Name;
        var plural = name.EndsWith("s", StringComparison.Ordinal);
        return new InputProblem($"{name} {(plural ? "are" : "is")} missing.") { IsMissing = true };
    }

    private bool Arrives(int input, GH_ParamAccess kind, bool required)
    {
        if (kind == GH_ParamAccess.list)
        {
            var goos = Goos(input);
            return goos.Count > 0 && (required ? !goos.TrueForAll(g => g is null) : !goos.Contains(null));
        }
        if (kind == GH_ParamAccess.tree)
        {
            var tree = Component.Params.Input[input].VolatileData;
            return Enumerable.Range(0, tree.PathCount).Any(i => tree.get_Branch(i).Cast<object?>().Any(g => g is not null));
        }
        IGH_Goo? goo = null;
        return required || (Access.GetData(input, ref goo) && goo is not null);
    }

    private bool Read<T>(int input, ref T? value)
    {
        if (input < 0)
        {
            var known = Component.Declared[-1 - input].Default is T;
            if (known) value = (T)Component.Declared[-1 - input].Default!;
            return known;
        }
        Await(input);
        return Access.GetData(input, ref value!);
    }

    private IGH_Param Port(int input) => input < 0 ? Component.Declared[-1 - input].Param : Component.Params.Input[input];

    private void Await(int input)
    {
        if (Upstream.Of(input) is { } name) throw new StillWorking(name);
    }

    // A list is read once.
    private List<IGH_Goo?> Goos(int input)
    {
        if (input < 0) return [];
        Await(input);
        if (_lists.TryGetValue(input, out var known)) return known;
        var goos = new List<IGH_Goo?>();
        Access.GetDataList(input, goos!);
        return _lists[input] = goos;
    }

    // What Grasshopper makes of the goo.
    private List<T> Converted<T>(int input)
        where T : class
    {
        var all = new List<T?>();
        Access.GetDataList(input, all!);
        var some = all.Where(item => item is not null).Select(item => item!).ToList();
        ReportNulls(input, all.Count - some.Count);
        return some;
    }

    private void ReportNulls(int input, int lost)
    {
        if (lost == 0) return;
        Report(GH_RuntimeMessageLevel.Warning,
            $"{Port(input).Name}: {lost} null {(lost == 1 ? "item is" : "items are")} ignored.");
    }

    private T ToChoice<T>(int input, int number)
        where T : struct, Enum
    {
        foreach (T value in Enum.GetValues(typeof(T)))
        {
            if (Convert.ToInt32(value, System.Globalization.CultureInfo.InvariantCulture) == number) return value;
        }
        throw new InputProblem(((ChoiceParam)Port(input)).Refuse(NumberFormatter.Format(number)));
    }

    // The path of an item output is the branch of the inputs; a list output of an item appends the index of the item.
    private string Place()
    {
        if (Component.Params.Output.Count == 0) return "Item " + NumberFormatter.Format(Access.Iteration);
        var items = Component.Params.Input.Any(p => p.Access == GH_ParamAccess.item);
        var output = Component.Params.Output.FindIndex(p => p.Access == GH_ParamAccess.item);
        if (output >= 0) return $"{Access.ParameterTargetPath(output)}[{NumberFormatter.Format(Access.ParameterTargetIndex(output))}]";
        var path = Access.ParameterTargetPath(0);
        return items && path.Length > 1 ? $"{path.CullElement()}[{NumberFormatter.Format(path.Indices[path.Length - 1])}]" : path.ToString();
    }
}
