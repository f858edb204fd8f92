using System.Runtime.ExceptionServices;

namespace Caterpillar.GH.Base;

/// <summary>A piece of work on another thread: its progress, its result, and the means to stop it.</summary>
[SuppressMessage("Design", "CA1001", Justification = "A source of cancellation without a timer or a wait handle holds nothing to dispose of.")]
internal sealed class Job : IProgress<double>
{
    private readonly CancellationTokenSource _cancel = new();
    private readonly Task<object> _task;
    private double _progress;

    /// <summary>Begins at once, or when earlier work has ended.</summary>
    public Job(string label, Func<IProgress<double>, CancellationToken, object> work, Task? earlier = null)
    {
        Label = label;
        object Work()
        {
            _cancel.Token.ThrowIfCancellationRequested();
            return work(this, _cancel.Token);
        }
        _task = earlier is null || earlier.IsCompleted
            ? Task.Run(Work)
            : earlier.ContinueWith(_ => Work(), CancellationToken.None, TaskContinuationOptions.None, TaskScheduler.Default);
    }

    public string Label { get; }

    /// <summary>The part of the work that is done, from 0 to 1.</summary>
    public double Progress => IsDone ? 1 : Volatile.Read(ref _progress);

    public bool IsDone => _task.IsCompleted;

    public Task Task => _task;

    /// <summary>The result, once it is done.</summary>
    /// <exception cref="OperationCanceledException">It was canceled. Other exceptions are those of the work itself.</exception>
    public object Result
    {
        get
        {
            if (_task.IsFaulted) ExceptionDispatchInfo.Capture(_task.Exception!.GetBaseException()).Throw();
            if (_task.IsCanceled) throw new OperationCanceledException();
            return _task.Result;
        }
    }

    public void Report(double value) => Volatile.Write(ref _progress, Math.Max(0, Math.Min(1, value)));

    public void Cancel() => _cancel.Cancel();

    /// <summary>Waits for its end. False if that takes longer.</summary>
    public bool Wait(int milliseconds)
    {
        try
        {
            return _task.Wait(milliseconds);
        }
        catch (AggregateException)
        {
            return true;
        }
    }
}
