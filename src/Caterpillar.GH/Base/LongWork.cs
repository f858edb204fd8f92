using System;
using System.Diagnostics;
using System.Runtime.ExceptionServices;
using System.Threading;
using System.Threading.Tasks;
using Grasshopper.Kernel;
using Rhino.UI;

namespace Caterpillar.GH.Base;

/// <summary>Runs work on another thread while the UI thread waits in short steps, watches the Escape key and moves Rhino's progress meter.</summary>
internal static class LongWork
{
    private const int StepMilliseconds = 25;
    private const int MeterAfterMilliseconds = 300;

    /// <exception cref="OperationCanceledException">The user pressed Escape.</exception>
    public static T Run<T>(string label, Func<IProgress<double>, CancellationToken, T> work)
    {
        using var cancel = new CancellationTokenSource();
        var progress = new Latest();
        var task = Task.Run(() => work(progress, cancel.Token));
        var waited = Stopwatch.StartNew();
        var shown = false;
        try
        {
            while (!Wait(task))
            {
                if (!cancel.IsCancellationRequested && GH_Document.IsEscapeKeyDown()) cancel.Cancel();
                if (!shown && waited.ElapsedMilliseconds >= MeterAfterMilliseconds)
                {
                    StatusBar.ShowProgressMeter(0, 100, label, true, true);
                    shown = true;
                }
                if (shown) StatusBar.UpdateProgressMeter((int)(100 * progress.Value), true);
            }
        }
        finally
        {
            if (shown) StatusBar.HideProgressMeter();
        }
        if (task.IsFaulted) ExceptionDispatchInfo.Capture(task.Exception!.GetBaseException()).Throw();
        if (task.IsCanceled) throw new OperationCanceledException();
        return task.Result;
    }

    private static bool Wait(Task task)
    {
        try
        {
            return task.Wait(StepMilliseconds);
        }
        catch (AggregateException)
        {
            return true;
        }
    }

    private sealed class Latest : IProgress<double>
    {
        private double _value;

        public double Value => Volatile.Read(ref _value);

        public void Report(double value) => Volatile.Write(ref _value, Math.Max(0, Math.Min(1, value)));
    }
}
