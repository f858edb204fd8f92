using System;
using System.Collections.Generic;
using System.Drawing;
using System.Linq;
using Caterpillar.GH.Plugin;
using GH_IO.Serialization;
using Grasshopper.Kernel;
using Rhino;
using Rhino.DocObjects;

namespace Caterpillar.GH.Base;

/// <summary>
/// Base of all components: declares ports, solves item by item so that a bad one does not stop the rest, reports problems with branch and item, keeps
/// long work off the UI thread, and corrects what Grasshopper's own base class does with previews and baking.
/// </summary>
public abstract class CaterpillarComponent : GH_Component
{
    private const string VersionKey = "CaterpillarVersion";
    private readonly SolveCache _cache = new();
    private readonly LastResults _last = new();
    private readonly Background _background;
    private readonly List<IDrawn> _drawn = [];

    // Filled while Grasshopper's constructor registers the ports.
    private readonly HashSet<int> _required = [];
    private Version? _newer;
    private bool _canceled;
    private bool _leaves;
    private int _pending;
    private int _shownLast;
    private string? _waitsFor;

    protected CaterpillarComponent(string name, string nickname, string description, string panel, GH_Exposure exposure = GH_Exposure.primary)
        : base(name, nickname, description, PluginInfo.Tab, panel)
    {
        Exposure = exposure;
        _background = new Background(this);
    }

    public override GH_Exposure Exposure { get; }

    /// <summary>True if an output can be previewed.</summary>
    public sealed override bool IsPreviewCapable => Params.Output.OfType<IGH_PreviewObject>().Any(p => p.IsPreviewCapable) || DrawsItself;

    /// <summary>Of the outputs that are shown; empty while hidden, which Grasshopper's own does not check.</summary>
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

    /// <summary>The name of the component whose new result is still worked on, this one or one before it; null if all that is given is up to date.</summary>
    internal string? Pending => _pending > 0 ? NickName : _waitsFor;

    internal Background Background => _background;

    /// <summary>True if an output can be baked; Grasshopper's own checks the inputs.</summary>
    public sealed override bool IsBakeCapable => Params.Output.OfType<IGH_BakeAwareObject>().Any(p => p.IsBakeCapable);

    protected sealed override Bitmap? Icon => Icons.Load(Icons.NameOf(GetType()));

    /// <summary>True for components that draw a preview of their own.</summary>
    private protected virtual bool DrawsItself => false;

    private IEnumerable<IGH_PreviewObject> Shown
        => Hidden || Locked ? [] : Params.Output.OfType<IGH_PreviewObject>().Where(p => !p.Hidden && p.IsPreviewCapable);

    private IEnumerable<IDrawn> Drawn => Hidden || Locked ? [] : _drawn;

    private string ProgressMessage => _background.Words + (_shownLast > 0 ? ", last result" : "");

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

    /// <summary>Does nothing if nothing can be baked; the menu item does not check.</summary>
    public sealed override void BakeGeometry(RhinoDoc doc, ObjectAttributes att, List<Guid> obj_ids)
    {
        if (IsBakeCapable) base.BakeGeometry(doc, att, obj_ids);
    }

    /// <summary>Forgets the message too: without inputs there is no solve that would replace it.</summary>
    public override void ClearData()
    {
        Message = "";
        _drawn.Clear();
        base.ClearData();
    }

    public override void DocumentContextChanged(GH_Document document, GH_DocumentContext context)
    {
        if (context == GH_DocumentContext.Close) _background.Cancel();
        else if (context != GH_DocumentContext.Unloaded) _background.Collect();
        base.DocumentContextChanged(document, context);
    }

    public override void RemovedFromDocument(GH_Document document)
    {
        _background.Cancel();
        _cache.Clear();
        _last.Clear();
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
    internal bool IsRequired(int input) => _required.Contains(input);

    private protected abstract void Inputs(InputPorts ports);

    private protected abstract void Outputs(OutputPorts ports);

    /// <summary>What happens for each item even if its other inputs turn out to be bad.</summary>
    private protected virtual void Prepare(Run run)
    {
    }

    /// <summary>Solves one item. Throws <see cref="InputProblem"/> (or lets the library's argument exceptions through) if the item can't be used.</summary>
    private protected abstract void Solve(Run run);

    protected sealed override void RegisterInputParams(GH_InputParamManager pManager) => Inputs(new InputPorts(pManager, _required));

    protected sealed override void RegisterOutputParams(GH_OutputParamManager pManager) => Outputs(new OutputPorts(pManager));

    protected sealed override void BeforeSolveInstance()
    {
        _canceled = false;
        Message = "";
        _drawn.Clear();
        _pending = 0;
        _shownLast = 0;
        _waitsFor = Upstream.Pending(this);
        _cache.Begin();
        _leaves = _background.Begin(OnPingDocument());
        if (_newer is not null)
        {
            AddRuntimeMessage(GH_RuntimeMessageLevel.Warning,
                $"This component was saved by version {_newer} of Caterpillar; this is {PluginInfo.Current}. Some of what it stored may be lost.");
        }
        if (_waitsFor is not null) AddRuntimeMessage(GH_RuntimeMessageLevel.Remark, $"Uses the last result of {_waitsFor}, which is not up to date.");
    }

    protected sealed override void AfterSolveInstance()
    {
        _cache.End(complete: _pending == 0);
        _background.End();
        if (_pending == 0)
        {
            _last.Trim(_leaves ? RunCount + 1 : 0);
            return;
        }
        Message = ProgressMessage;
        if (_shownLast > 0) AddRuntimeMessage(GH_RuntimeMessageLevel.Remark, "The last result is shown while the new one is worked on.");
    }

    protected sealed override void SolveInstance(IGH_DataAccess DA)
    {
        if (_canceled) return;
        var run = new Run(this, DA, _cache, _background);
        try
        {
            Prepare(run);
            run.CheckSources();
            Solve(run);
            run.Give();
            if (_leaves) _last.Keep(DA.Iteration, run.Given);
        }
        catch (StillWorking)
        {
            _pending++;
            if (_last.Of(DA.Iteration) is { } given)
            {
                _shownLast++;
                foreach (var give in given) give(DA);
            }
            else
            {
                run.GiveOnlyNulls();
            }
        }
        catch (OperationCanceledException)
        {
            _canceled = true;
            _background.Cancel();
            AddRuntimeMessage(GH_RuntimeMessageLevel.Warning, "Canceled.");
            DA.AbortComponentSolution();
            OnPingDocument()?.RequestAbortSolution();
        }
        catch (InputProblem) when (_waitsFor is not null)
        {
            // What is missing or wrong may come with the new result.
            run.GiveNulls();
        }
        catch (InputProblem problem)
        {
            run.Report(problem.IsMissing ? GH_RuntimeMessageLevel.Warning : GH_RuntimeMessageLevel.Error, problem.Message);
            run.GiveNulls();
        }
        catch (Exception e) when (e is not OutOfMemoryException)
        {
            run.Report(GH_RuntimeMessageLevel.Error, WithoutParameterName(e.Message));
            run.GiveNulls();
        }
    }

    /// <summary>Shows something for the item that is being solved.</summary>
    internal void Show(IDrawn drawn) => _drawn.Add(drawn);

    /// <summary>Shows how far long work has come since the solution ended.</summary>
    internal void ShowProgress()
    {
        var message = ProgressMessage;
        if (message == Message) return;
        Message = message;
        OnDisplayExpired(true);
    }

    /// <summary>Says that long work was given up; the last result stays.</summary>
    internal void ShowCanceled()
    {
        Message = _shownLast > 0 ? "canceled, last result" : "canceled";
        AddRuntimeMessage(GH_RuntimeMessageLevel.Warning, "Canceled; recompute to start again.");
        OnDisplayExpired(true);
    }

    private static string WithoutParameterName(string message)
    {
        var at = message.IndexOf("(Parameter '", StringComparison.Ordinal);
        if (at < 0) at = message.IndexOf("Parameter name:", StringComparison.Ordinal);
        return at <= 0 ? message : message.Substring(0, at).TrimEnd();
    }
}
