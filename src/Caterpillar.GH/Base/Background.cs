using System.Diagnostics;
using Grasshopper;

namespace Caterpillar.GH.Base;

/// <summary>
/// The long work of one component. A solve waits for half a second. Longer work goes on after it, one job after the other, and the component is solved
/// again when all is done. A job belongs to its inputs: only a solve with the same inputs gets its result. On a server, in a cluster, in a script or where a
/// component of the definition asks for it, a solve waits for the end.
/// </summary>
[SuppressMessage("Design", "CA1001", Justification = "Grasshopper never disposes of components: the timer is disposed when the last work ends.")]
internal sealed class Background(CaterpillarComponent component)
{
    // While inputs change again and again, as with a slider, earlier work is canceled: each solve is short.
    private const int HurriedMilliseconds = 50;
    private const int PulseMilliseconds = 333;
    private readonly Dictionary<SolveKey, Job> _jobs = [];
    private readonly HashSet<SolveKey> _asked = [];
    private readonly Stopwatch _waited = new();
    private Timer? _timer;
    private bool _isAwaited;
    private int _posted;

    /// <summary>True if a solution may end before the work. Tests set their own rule.</summary>
    public Func<GH_Document?, bool> MayLeave { get; set; } = IsOnCanvas;

    /// <summary>Runs an action on the UI thread. Tests set their own.</summary>
    public Action<Action> Post { get; set; } = action => RhinoApp.InvokeOnUiThread(action);

    /// <summary>Milliseconds that a solve waits if no work is running when it begins. Tests wait less.</summary>
    public int UsualPatience { get; set; } = 500;

    /// <summary>Milliseconds that this solve waits for all of its work. int.MaxValue = no limit.</summary>
    public int Patience { get; private set; }

    /// <summary>The work that must end before the next one begins. Tests hold work back with it.</summary>
    public Task Queue { get; set; } = Task.CompletedTask;

    public bool IsWorking => _jobs.Count > 0;

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

    private bool IsDone => _jobs.Values.All(j => j.IsDone);

    /// <summary>A solve begins.</summary>
    public void Begin(GH_Document? document)
    {
        Patience = !MayLeave(document) ? int.MaxValue : IsDone ? UsualPatience : HurriedMilliseconds;
        _waited.Reset();
        _asked.Clear();
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
            Queue.ContinueWith(_ => PostPulse(), TaskScheduler.Default);
        }
        _waited.Start();
        var done = LongWork.Wait(job, Patience == int.MaxValue ? Patience : Math.Max(0, Patience - (int)_waited.ElapsedMilliseconds));
        _waited.Stop();
        if (!done) throw new StillWorking(component.NickName);
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
        _isAwaited = true;
        if (_jobs.Count == 0) Stop();
        else _timer ??= new Timer(_ => PostPulse(), null, PulseMilliseconds, PulseMilliseconds);
    }

    /// <summary>Nobody waits for the work until the next solve requests it.</summary>
    public void Expire() => _isAwaited = false;

    /// <summary>Cancels all work.</summary>
    public void Cancel()
    {
        foreach (var job in _jobs.Values) job.Cancel();
        _jobs.Clear();
        Stop();
    }

    /// <summary>
    /// Watches the work on the UI thread: shows progress, and requests a solution at the end, as soon as the document can be solved. Cancels the work of a
    /// component that is locked or has lost an input.
    /// </summary>
    public void Pulse()
    {
        Interlocked.Exchange(ref _posted, 0);
        if (_timer is null) return;
        var document = component.OnPingDocument();
        if (document is null || component.Locked || (!_isAwaited && component.Phase != GH_SolutionPhase.Blank))
        {
            Cancel();
        }
        else if (!IsDone)
        {
            if (component.Message == Words) return;
            component.Message = Words;
            component.OnDisplayExpired(true);
        }
        else if (document.Enabled && GH_Document.EnableSolutions && document.SolutionState != GH_ProcessStep.Process)
        {
            Stop();
            document.ScheduleSolution(1, _ => component.ExpireSolution(false));
        }
    }

    // A definition that is open in the editor itself: not in a cluster, not on a server, not opened by a script.
    private static bool IsOnCanvas(GH_Document? document)
        => document is { Owner: null } && Instances.IsDocumentServer && Instances.DocumentServer.Contains(document) && !RhinoApp.IsRunningHeadless
            && !document.Objects.Any(o => o is CaterpillarComponent { LetsAllWait: true, Locked: false });

    private void PostPulse()
    {
        if (_timer is not null && Interlocked.Exchange(ref _posted, 1) == 0) Post(Pulse);
    }

    private void Stop()
    {
        _timer?.Dispose();
        _timer = null;
        _posted = 0;
        if (_jobs.Count == 0) Queue = Task.CompletedTask;
    }
}
