using System.Collections;

namespace Caterpillar.GH.Base;

/// <summary>One item of a solve: its inputs, its cached and running work, its outputs and its messages.</summary>
internal sealed class Run(CaterpillarComponent component, IGH_DataAccess access, Upstream upstream, SolveCache cache, Background background)
    : ItemInputs(component, access, upstream)
{
    private readonly List<Action<IGH_DataAccess>> _given = [];
    private readonly List<string> _diagnostics = [];

    /// <summary>Number of the item in this solution, from 0.</summary>
    public int Iteration => Access.Iteration;

    /// <summary>The print paths of a list, one at least.</summary>
    public PathList Paths(int input)
    {
        var goos = Some<PrintPathGoo>(input);
        return cache.Renew<PathList>([input, Access.Iteration], (last, _) => last?.Has(goos) == true ? last : new PathList(goos));
    }

    /// <summary>The steps of a list for a setup.</summary>
    public StepList Steps(IReadOnlyList<StepGoo> goos, PrintSetup setup)
        => cache.Renew<StepList>([setup, Access.Iteration], (last, _) => last?.Has(goos) == true ? last : new StepList(goos, setup));

    /// <summary>Models of a list, each kept from the last solve while its geometry has the same content.</summary>
    /// <inheritdoc cref="ModelOf" path="/exception"/>
    public ModelMesh[] Models(int input, double tolerance)
        => List<IGH_GeometricGoo>(input).Select(goo => ModelOf(goo, tolerance)).ToArray();

    /// <summary>The model in any geometry. The tolerance, in mm, is the maximum deviation of facets from a curved surface.</summary>
    /// <exception cref="InputProblem">It has no surface, or Rhino can't mesh it.</exception>
    public ModelMesh ModelOf(IGH_GeometricGoo goo, double tolerance)
    {
        var geometry = Wrapped.Bare(goo.ScriptVariable()) ?? throw new InputProblem("Geometry is null.");
        return Cached([.. ModelMesh.Content(geometry), tolerance, Units.ToMillimeters], () => ModelMesh.Of(geometry, tolerance, Units));
    }

    /// <summary>A value that is kept from the last solve if the parts of its key are the same.</summary>
    public T Cached<T>(object?[] key, Func<T> make)
        where T : class
        => cache.Get(key, _ => make());

    /// <summary>A value that may take long, cached like the others. It is made on another thread, which must not use this run.</summary>
    /// <exception cref="OperationCanceledException">The user pressed Escape.</exception>
    public T Work<T>(string label, object?[] key, Func<IProgress<double>, CancellationToken, T> work)
        where T : class
        => cache.Get(key, k => background.Get(k, label, work));

    /// <summary>Work that has to be done before the solve ends, such as writing a file.</summary>
    /// <inheritdoc cref="Work" path="/exception"/>
    public T Wait<T>(string label, Func<IProgress<double>, CancellationToken, T> work)
        where T : class
        => LongWork.Run(label, work);

    /// <summary>True if all inputs are up to date. False, with a warning, while a component upstream is working or was canceled.</summary>
    public bool MayAct()
    {
        if (Upstream.Any is not { } name) return true;
        Component.AddRuntimeMessage(GH_RuntimeMessageLevel.Warning, $"Nothing was done because {name} is not up to date. Press again when it is.");
        return false;
    }

    /// <summary>A short message below the component.</summary>
    public void Summarize(string text) => Component.Message = text;

    /// <summary>The value of a result whose diagnostics are reported. Without one the item ends here and gives null.</summary>
    public T Require<T>(Result<T> result)
        where T : class
        => Accept(result) ?? throw new NoResult();

    /// <summary>The value of a result whose diagnostics are reported. Null if it has none.</summary>
    public T? Accept<T>(Result<T> result)
        where T : class
    {
        Report(result.Diagnostics);
        return result.Value;
    }

    /// <summary>Messages for diagnostics. The output Diagnostics gives the same texts.</summary>
    public void Report(IEnumerable<Diagnostic> diagnostics)
    {
        foreach (var diagnostic in diagnostics)
        {
            var text = diagnostic.ToString();
            _diagnostics.Add(text);
            Report(Level(diagnostic.Severity), text);
        }
    }

    /// <summary>Sets the first outputs, one after the other.</summary>
    public void SetAll(params object?[] values)
    {
        for (var i = 0; i < values.Length; i++) Set(i, values[i]);
    }

    public void Set(int output, object? value) => _given.Add(a => a.SetData(output, value));

    public void SetList(int output, IEnumerable values)
    {
        // Lists that are made while they are read are made now, where a problem is one of this item.
        var list = values as ICollection ?? values.Cast<object?>().ToArray();
        _given.Add(a => a.SetDataList(output, list));
    }

    /// <summary>Gives a copy of a tree, which is kept: what Grasshopper does with it (reverse, graft) must not reach the next solve.</summary>
    public void SetTree<T>(int output, GH_Structure<T> tree)
        where T : IGH_Goo
        => _given.Add(a => a.SetDataTree(output, tree.ShallowDuplicate()));

    /// <summary>Shows something in the viewports, as long as the result of the item.</summary>
    public void Show(IDrawn drawn) => _given.Add(_ => Component.Show(drawn));

    /// <summary>The path of this item's data in an output.</summary>
    public GH_Path PathOf(int output) => Access.ParameterTargetPath(output);

    /// <summary>Null for every item output. Lists and trees stay empty.</summary>
    public void SetNulls()
    {
        for (var i = 0; i < Component.Params.Output.Count; i++)
        {
            if (Component.Params.Output[i].Access == GH_ParamAccess.item) Set(i, null);
        }
    }

    /// <summary>Gives the outputs that were set.</summary>
    public void Give()
    {
        SetDiagnostics();
        foreach (var give in _given) give(Access);
    }

    /// <summary>Gives null for items, and the lists and trees that were set.</summary>
    public void GiveNulls()
    {
        SetNulls();
        if (_diagnostics.Count > 0) SetDiagnostics();
        foreach (var give in _given) give(Access);
    }

    /// <summary>Gives null for items and nothing else.</summary>
    public void GiveOnlyNulls()
    {
        _given.Clear();
        _diagnostics.Clear();
        GiveNulls();
    }

    private void SetDiagnostics()
    {
        var output = Component.Params.Output.FindIndex(p => p.Name == OutputPorts.DiagnosticsName);
        if (output >= 0) SetList(output, _diagnostics);
    }

    private static GH_RuntimeMessageLevel Level(Severity severity) => severity switch
    {
        Severity.Error => GH_RuntimeMessageLevel.Error,
        Severity.Warning => GH_RuntimeMessageLevel.Warning,
        _ => GH_RuntimeMessageLevel.Remark,
    };
}
