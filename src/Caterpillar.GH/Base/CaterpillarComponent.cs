using Rhino.DocObjects;

namespace Caterpillar.GH.Base;

/// <summary>
/// Base of all components: declares ports, solves item by item, and keeps the version in the file. It corrects how Grasshopper's base class previews and bakes.
/// </summary>
public abstract class CaterpillarComponent : GH_Component
{
    private const string VersionKey = "CaterpillarVersion";
    private readonly Solver _solver;
    private readonly List<IDrawn> _drawn = [];

    // Filled while Grasshopper's constructor registers the ports.
    private readonly List<DeclaredPort> _declared = [];
    private readonly HashSet<string> _required = [];
    private Version? _newer;

    protected CaterpillarComponent(string name, string nickname, string description, string panel, GH_Exposure exposure = GH_Exposure.primary)
        : base(name, nickname, description, PluginInfo.Tab, panel)
    {
        Exposure = exposure;
        _solver = new Solver(this, SolveItem);
    }

    public override GH_Exposure Exposure { get; }

    /// <summary>True if an output can be previewed.</summary>
    public sealed override bool IsPreviewCapable => Params.Output.OfType<IGH_PreviewObject>().Any(p => p.IsPreviewCapable) || DrawsItself;

    /// <summary>Bounds of the outputs that are shown. Empty while hidden, which Grasshopper's own property does not check.</summary>
    public override Rg.BoundingBox ClippingBox
    {
        get
        {
            var box = Rg.BoundingBox.Empty;
            foreach (var output in Shown) box.Union(output.ClippingBox);
            foreach (var drawn in Drawn) box.Union(drawn.Box);
            return box;
        }
    }

    /// <summary>True if an output can be baked. Grasshopper's own property checks the inputs.</summary>
    public sealed override bool IsBakeCapable => Params.Output.OfType<IGH_BakeAwareObject>().Any(p => p.IsBakeCapable);

    /// <inheritdoc cref="Solver.Pending"/>
    internal string? Pending => _solver.Pending;

    internal Background Background => _solver.Background;

    /// <summary>True for a component that makes all others of its definition wait for their results.</summary>
    internal virtual bool LetsAllWait => false;

    protected sealed override Bitmap? Icon => Icons.Load(Icons.NameOf(GetType()));

    /// <summary>True for components that draw a preview of their own.</summary>
    private protected virtual bool DrawsItself => false;

    private IEnumerable<IGH_PreviewObject> Shown
        => Hidden || Locked ? [] : Params.Output.OfType<IGH_PreviewObject>().Where(p => !p.Hidden && p.IsPreviewCapable);

    private IEnumerable<IDrawn> Drawn => Hidden || Locked ? [] : _drawn;

    private bool IsSelected => Attributes?.Selected ?? false;

    public override void DrawViewportWires(IGH_PreviewArgs args)
    {
        foreach (var output in Shown) output.DrawViewportWires(args);
        foreach (var drawn in Drawn) drawn.DrawWires(args, IsSelected);
    }

    public override void DrawViewportMeshes(IGH_PreviewArgs args)
    {
        foreach (var output in Shown) output.DrawViewportMeshes(args);
        foreach (var drawn in Drawn) drawn.DrawMeshes(args, IsSelected);
    }

    /// <summary>Does nothing if nothing can be baked, which the menu item does not check.</summary>
    public sealed override void BakeGeometry(RhinoDoc doc, ObjectAttributes att, List<Guid> obj_ids)
    {
        if (IsBakeCapable) base.BakeGeometry(doc, att, obj_ids);
    }

    /// <summary>Clears the message as well: without inputs, no solve replaces it.</summary>
    public override void ClearData()
    {
        Message = "";
        _drawn.Clear();
        _solver?.Expire();
        base.ClearData();
    }

    public override void DocumentContextChanged(GH_Document document, GH_DocumentContext context)
    {
        if (context == GH_DocumentContext.Close) Background.Cancel();
        base.DocumentContextChanged(document, context);
    }

    public override void RemovedFromDocument(GH_Document document)
    {
        _solver.Clear();
        base.RemovedFromDocument(document);
    }

    public override bool Write(GH_IWriter writer)
    {
        writer.SetString(VersionKey, PluginInfo.Current.ToString());
        return base.Write(writer);
    }

    public override bool Read(GH_IReader reader)
    {
        var text = "";
        _newer = reader.TryGetString(VersionKey, ref text) && Version.TryParse(text, out var version) && version > PluginInfo.Current ? version : null;
        return base.Read(reader);
    }

    /// <summary>True for an input without a default that is not optional.</summary>
    internal bool IsRequired(int input) => _required.Contains(Params.Input[input].Name);

    /// <summary>All inputs in their order, also those that are not shown for what is chosen.</summary>
    internal IReadOnlyList<DeclaredPort> Declared => _declared;

    /// <summary>Shows something for the item that is being solved.</summary>
    internal void Show(IDrawn drawn) => _drawn.Add(drawn);

    private protected abstract void Inputs(InputPorts ports);

    private protected abstract void Outputs(OutputPorts ports);

    /// <summary>What happens before the items are solved.</summary>
    private protected virtual void Begin()
    {
    }

    /// <summary>What happens for each item even if its other inputs turn out to be bad.</summary>
    private protected virtual void Prepare(Run run)
    {
    }

    /// <summary>Solves one item. Throws <see cref="InputProblem"/> (or lets the library's argument exceptions through) if the item can't be used.</summary>
    private protected abstract void Solve(Run run);

    protected sealed override void RegisterInputParams(GH_InputParamManager pManager)
    {
        Inputs(new InputPorts(pManager, _declared));
        _required.UnionWith(_declared.Where(d => d.IsRequired).Select(d => d.Param.Name));
    }

    protected sealed override void RegisterOutputParams(GH_OutputParamManager pManager) => Outputs(new OutputPorts(pManager));

    protected sealed override void BeforeSolveInstance()
    {
        Message = "";
        _drawn.Clear();
        if (_newer is not null)
        {
            AddRuntimeMessage(GH_RuntimeMessageLevel.Warning,
                $"This component was saved by Caterpillar {_newer}, but this is {PluginInfo.Current}. Some of its data may be lost. Update Caterpillar.");
        }
        Begin();
        _solver.Begin();
    }

    protected sealed override void AfterSolveInstance()
    {
        _solver.End();
        foreach (var output in Shown.OfType<IThinned>())
        {
            if (output.Note is { } note) AddRuntimeMessage(GH_RuntimeMessageLevel.Remark, note);
        }
    }

    protected sealed override void SolveInstance(IGH_DataAccess DA) => _solver.Solve(DA);

    private void SolveItem(Run run)
    {
        Prepare(run);
        run.CheckSources();
        try
        {
            Solve(run);
        }
        catch (NoResult)
        {
            run.SetNulls();
        }
    }
}
