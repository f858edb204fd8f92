namespace Caterpillar.GH.Base;

/// <summary>
/// Solves a component item by item, so that a bad one does not stop the rest. Long work goes on after a solution. Until it is done, an item gives null.
/// </summary>
/// <param name="component">The component.</param>
/// <param name="solve">Solves one item.</param>
internal sealed class Solver(CaterpillarComponent component, Action<Run> solve)
{
    private readonly CaterpillarComponent _component = component;
    private readonly SolveCache _cache = new();
    private Upstream _upstream = new Upstream(component);
    private bool _canceled;
    private string? _pending;

    public Background Background { get; } = new Background(component);

    /// <summary>Nickname of the component that still works on an output, this one or one upstream. Null if all outputs are complete.</summary>
    public string? Pending => _component.Locked ? null : _pending;

    /// <summary>The outputs are cleared. Without valid inputs, no solve follows.</summary>
    public void Expire()
    {
        _pending = null;
        Background.Expire();
    }

    /// <summary>A solution begins.</summary>
    public void Begin()
    {
        _canceled = false;
        _pending = null;
        _upstream = new Upstream(_component);
        _cache.Begin();
        Background.Begin(_component.OnPingDocument());
    }

    /// <summary>A solution ends.</summary>
    public void End()
    {
        _cache.End(complete: _pending is null);
        Background.End();
        if (_pending is null) return;
        _component.Message = _canceled ? "canceled" : Background.IsWorking ? Background.Words : "waits for " + _pending;
    }

    /// <summary>Solves one item.</summary>
    public void Solve(IGH_DataAccess access)
    {
        if (_canceled) return;
        var run = new Run(_component, access, _upstream, _cache, Background);
        try
        {
            solve(run);
            run.Give();
        }
        catch (StillWorking working)
        {
            _pending ??= working.Component;
            run.GiveOnlyNulls();
        }
        catch (OperationCanceledException)
        {
            _canceled = true;
            _pending = _component.NickName;
            Background.Cancel();
            _component.AddRuntimeMessage(GH_RuntimeMessageLevel.Warning, "Canceled. Recompute to start again.");
            access.AbortComponentSolution();
            _component.OnPingDocument()?.RequestAbortSolution();
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

    /// <summary>Cancels all work and forgets all results.</summary>
    public void Clear()
    {
        Background.Cancel();
        _cache.Clear();
        _pending = null;
    }

    private static string WithoutParameterName(string message)
    {
        var at = message.IndexOf("(Parameter '", StringComparison.Ordinal);
        if (at < 0) at = message.IndexOf("Parameter name:", StringComparison.Ordinal);
        return at <= 0 ? message : message.Substring(0, at).TrimEnd();
    }
}
