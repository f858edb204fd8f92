using System.Diagnostics;
using System.Diagnostics.CodeAnalysis;
using Caterpillar.Basics;
using Grasshopper;
using Grasshopper.Kernel;
using Rhino;

namespace Caterpillar.GH.Base;

/// <summary>
/// The long work of one component. A solve waits for half a second; what takes longer goes on without it, one piece after the other, and the component is
/// solved again when all is done. Where nobody would see that (on a server, in a cluster, in a script) a solve waits for the end.
/// </summary>
[SuppressMessage("Design", "CA1001", Justification = "Grasshopper never disposes of components: the timer is disposed when the last work ends.")]
internal sealed class Background
{
    public const string WaitSetting = "Caterpillar:Wait";
    // While inputs change again and again, as with a slider, earlier work is given up: each solve is short.
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

    /// <summary>True where a solution may end before the work; a test has its own rule.</summary>
    public Func<GH_Document?, bool> MayLeave { get; set; }

    /// <summary>Runs something on the UI thread; a test has its own.</summary>
    public Action<Action> Post { get; set; } = action => RhinoApp.InvokeOnUiThread(action);

    /// <summary>Milliseconds that a solve waits if nothing is at work when it begins; a test waits less.</summary>
    public int UsualPatience { get; set; } = 500;

    /// <summary>Milliseconds that this solve waits for all of its work; the greatest number for ever.</summary>
    public int Patience { get; private set; }

    /// <summary>What has to end before the next work begins; a test holds it back with that.</summary>
    public Task Queue { get; set; } = Task.CompletedTask;

    /// <summary>What is done, and how much of it.</summary>
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

    /// <summary>The result of some work, which begins if it has not yet.</summary>
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

    /// <summary>A solve ends: what it did not ask for is canceled, and the rest watched.</summary>
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

    /// <summary>Gives up all work.</summary>
    public void Cancel()
    {
        foreach (var job in _jobs.Values) job.Cancel();
        _jobs.Clear();
        Stop();
    }

    /// <summary>Asks for a solution if all work is done, as after a time in which the document was not shown.</summary>
    public void Collect()
    {
        if (_jobs.Count > 0 && _jobs.Values.All(j => j.IsDone)) _component.OnPingDocument()?.ScheduleSolution(1, _ => _component.ExpireSolution(false));
    }

    /// <summary>Looks after the work, on the UI thread: shows the progress, hears the Escape key, and asks for a solution at the end.</summary>
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
