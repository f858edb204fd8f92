using System.Diagnostics;
using System.Diagnostics.CodeAnalysis;
using Grasshopper;
using Grasshopper.Kernel;
using Rhino;

namespace Caterpillar.GH.Base;

/// <summary>
/// The long work of one component. A solve waits for half a second. Longer work goes on after it, one job after the other, and the component is solved
/// again when all is done. On a server, in a cluster or in a script, a solve waits for the end.
/// </summary>
[SuppressMessage("Design", "CA1001", Justification = "Grasshopper never disposes of components: the timer is disposed when the last work ends.")]
internal sealed class Background
{
    public const string WaitSetting = "Caterpillar:Wait";
    // While inputs change again and again, as with a slider, earlier work is canceled: each solve is short.
    private const int HurriedMilliseconds = 50;
    private const int PulseMilliseconds = 100;
    private readonly CaterpillarComponent _component;
    private readonly Solver _solver;
    private readonly Dictionary<SolveKey, Job> _jobs = [];
    private readonly HashSet<SolveKey> _asked = [];
    private readonly Stopwatch _waited = new();
    private Timer? _timer;
    private int _posted;

    public Background(CaterpillarComponent component, Solver solver)
    {
        _component = component;
        _solver = solver;
        MayLeave = IsOnCanvas;
    }

    /// <summary>True if a solution may end before the work. Tests set their own rule.</summary>
    public Func<GH_Document?, bool> MayLeave { get; set; }

    /// <summary>Runs an action on the UI thread. Tests set their own.</summary>
    public Action<Action> Post { get; set; } = action => RhinoApp.InvokeOnUiThread(action);

    /// <summary>Milliseconds that a solve waits if no work is running when it begins. Tests wait less.</summary>
    public int UsualPatience { get; set; } = 500;

    /// <summary>Milliseconds that this solve waits for all of its work. int.MaxValue = no limit.</summary>
    public int Patience { get; private set; }

    /// <summary>The work that must end before the next one begins. Tests hold work back with it.</summary>
    public Task Queue { get; set; } = Task.CompletedTask;

    /// <summary>The current work and its progress in percent.</summary>
    public string Words
    {
        get
        {
            var done = _jobs.Values.Sum(j => j.Progress) / Math.Max(1, _jobs.Count);
            var label = _jobs.Values.FirstOrDefault(j => !j.IsDone)?.Label ?? "Working";
            return $"{label} {NumberFormatter.Format(Math.Floor(100 * done + 1e-6), 0)} %";
        }
    }

    /// <summary>A solve begins. True if it may end before the work.</summary>
    public bool Begin(GH_Document? document)
    {
        var leaves = MayLeave(document);
        if (!leaves && _jobs.Count > 0) Cancel();
        Patience = !leaves ? int.MaxValue : _jobs.Values.All(j => j.IsDone) ? UsualPatience : HurriedMilliseconds;
        _waited.Reset();
        _asked.Clear();
        return leaves;
    }

    /// <summary>The result of some work, which begins now if it has not begun.</summary>
    /// <exception cref="StillWorking">It takes longer than this solve waits.</exception>
    /// <exception cref="OperationCanceledException">The user pressed Escape.</exception>
    public T Get<T>(SolveKey key, string label, Func<IProgress<double>, CancellationToken, T> work)
        where T : class
    {
        _asked.Add(key);
        if (!_jobs.TryGetValue(key, out var job))
        {
            _jobs.Add(key, job = new Job(label, work, Queue));
            Queue = job.Task;
        }
        _waited.Start();
        var done = LongWork.Wait(job, Patience == int.MaxValue ? Patience : Math.Max(0, Patience - (int)_waited.ElapsedMilliseconds));
        _waited.Stop();
        if (!done) throw new StillWorking();
        _jobs.Remove(key);
        return (T)job.Result;
    }

    /// <summary>A solve ends: work that it did not request is canceled, the rest is watched.</summary>
    public void End()
    {
        foreach (var key in _jobs.Keys.Where(key => !_asked.Contains(key)).ToList())
        {
            _jobs[key].Cancel();
            _jobs.Remove(key);
        }
        if (_jobs.Count == 0) Stop();
        else _timer ??= new Timer(_ => PostPulse(), null, PulseMilliseconds, PulseMilliseconds);
    }

    /// <summary>Cancels all work.</summary>
    public void Cancel()
    {
        foreach (var job in _jobs.Values) job.Cancel();
        _jobs.Clear();
        Stop();
    }

    /// <summary>Requests a solution if all work is done, for example after the document was hidden.</summary>
    public void Collect()
    {
        if (_jobs.Count > 0 && _jobs.Values.All(j => j.IsDone)) _component.OnPingDocument()?.ScheduleSolution(1, _ => _component.ExpireSolution(false));
    }

    /// <summary>Watches the work on the UI thread: shows progress, checks the Escape key, and requests a solution at the end.</summary>
    public void Pulse()
    {
        Interlocked.Exchange(ref _posted, 0);
        if (_jobs.Count == 0 || _timer is null) return;
        if (_component.Locked || GH_Document.IsEscapeKeyDown())
        {
            Cancel();
            _solver.ShowCanceled();
        }
        else if (_jobs.Values.All(j => j.IsDone))
        {
            Stop();
            Collect();
        }
        else
        {
            _solver.ShowProgress();
        }
    }

    // A definition that is open in the editor itself: not in a cluster, not on a server, not opened by a script.
    private static bool IsOnCanvas(GH_Document? document)
        => document is { Owner: null } && Instances.IsDocumentServer && Instances.DocumentServer.Contains(document) && !RhinoApp.IsRunningHeadless
            && !Instances.Settings.GetValue(WaitSetting, false);

    private void PostPulse()
    {
        if (Interlocked.Exchange(ref _posted, 1) == 0) Post(Pulse);
    }

    private void Stop()
    {
        _timer?.Dispose();
        _timer = null;
        _posted = 0;
        if (_jobs.Count == 0) Queue = Task.CompletedTask;
    }
}
