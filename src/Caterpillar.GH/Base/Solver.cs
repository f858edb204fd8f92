using Grasshopper.Kernel;

namespace Caterpillar.GH.Base;

/// <summary>
/// Solves a component item by item, so that a bad one does not stop the rest. Long work goes on after a solution. Until it is done, an item gives its
/// last result.
/// </summary>
internal sealed class Solver
{
    private readonly CaterpillarComponent _component;
    private readonly Action<Run> _solve;
    private readonly SolveCache _cache = new();
    private readonly LastResults _last = new();
    private bool _canceled;
    private bool _leaves;
    private int _pending;
    private int _shownLast;
    private string? _waitsFor;

    /// <param name="component">The component.</param>
    /// <param name="solve">Solves one item.</param>
    public Solver(CaterpillarComponent component, Action<Run> solve)
    {
        _component = component;
        _solve = solve;
        Background = new Background(component, this);
    }

    public Background Background { get; }

    /// <summary>The name of the component that still computes a new result, this one or one upstream. Null if all outputs are up to date.</summary>
    public string? Pending => _pending > 0 ? _component.NickName : _waitsFor;

    private string Progress => Background.Words + (_shownLast > 0 ? ", last result" : "");

    /// <summary>A solution begins.</summary>
    public void Begin()
    {
        _canceled = false;
        _pending = 0;
        _shownLast = 0;
        _waitsFor = Upstream.Pending(_component);
        _cache.Begin();
        _leaves = Background.Begin(_component.OnPingDocument());
        if (_waitsFor is not null) Say(GH_RuntimeMessageLevel.Remark, $"Uses the last result of {_waitsFor}, which is not up to date.");
    }

    /// <summary>A solution ends.</summary>
    public void End()
    {
        _cache.End(complete: _pending == 0);
        Background.End();
        if (_pending == 0)
        {
            _last.Trim(_leaves ? _component.RunCount + 1 : 0);
            return;
        }
        _component.Message = Progress;
        if (_shownLast > 0) Say(GH_RuntimeMessageLevel.Remark, "The last result is shown while the new one is computed.");
    }

    /// <summary>Solves one item.</summary>
    public void Solve(IGH_DataAccess access)
    {
        if (_canceled) return;
        var run = new Run(_component, access, _cache, Background);
        try
        {
            _solve(run);
            run.Give();
            if (_leaves) _last.Keep(access.Iteration, run.Given);
        }
        catch (StillWorking)
        {
            GiveLast(run, access);
        }
        catch (OperationCanceledException)
        {
            _canceled = true;
            Background.Cancel();
            Say(GH_RuntimeMessageLevel.Warning, "Canceled.");
            access.AbortComponentSolution();
            _component.OnPingDocument()?.RequestAbortSolution();
        }
        catch (InputProblem) when (_waitsFor is not null)
        {
            // A missing or wrong input may come with the new result.
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

    /// <summary>Cancels all work and forgets all results.</summary>
    public void Clear()
    {
        Background.Cancel();
        _cache.Clear();
        _last.Clear();
    }

    /// <summary>Shows how far long work has come since the solution ended.</summary>
    public void ShowProgress()
    {
        var message = Progress;
        if (message == _component.Message) return;
        _component.Message = message;
        _component.OnDisplayExpired(true);
    }

    /// <summary>Reports that long work was canceled. The last result stays.</summary>
    public void ShowCanceled()
    {
        _component.Message = _shownLast > 0 ? "canceled, last result" : "canceled";
        Say(GH_RuntimeMessageLevel.Warning, "Canceled. Recompute to start again.");
        _component.OnDisplayExpired(true);
    }

    private static string WithoutParameterName(string message)
    {
        var at = message.IndexOf("(Parameter '", StringComparison.Ordinal);
        if (at < 0) at = message.IndexOf("Parameter name:", StringComparison.Ordinal);
        return at <= 0 ? message : message.Substring(0, at).TrimEnd();
    }

    private void GiveLast(Run run, IGH_DataAccess access)
    {
        _pending++;
        if (_last.Of(access.Iteration) is not { } given)
        {
            run.GiveOnlyNulls();
            return;
        }
        _shownLast++;
        foreach (var give in given) give(access);
    }

    private void Say(GH_RuntimeMessageLevel level, string text) => _component.AddRuntimeMessage(level, text);
}
