using System.Diagnostics;
using Rhino.UI;

namespace Caterpillar.GH.Base;

/// <summary>Waits for work on another thread: in short steps that watch the Escape key and move Rhino's progress meter.</summary>
internal static class LongWork
{
    private const int StepMilliseconds = 25;
    private const int MeterAfterMilliseconds = 300;

    /// <exception cref="OperationCanceledException">The user pressed Escape.</exception>
    public static T Run<T>(string label, Func<IProgress<double>, CancellationToken, T> work)
        where T : class
    {
        var job = new Job(label, work);
        Wait(job);
        return (T)job.Result;
    }

    /// <summary>Waits for the end of a job, or for so many milliseconds. True if it has ended. Escape cancels it.</summary>
    public static bool Wait(Job job, int patience = int.MaxValue)
    {
        var waited = Stopwatch.StartNew();
        var shown = false;
        var canceled = false;
        try
        {
            while (!job.Wait(Math.Min(StepMilliseconds, patience)))
            {
                if (!canceled && GH_Document.IsEscapeKeyDown())
                {
                    canceled = true;
                    job.Cancel();
                }
                if (!canceled && waited.ElapsedMilliseconds >= patience) return false;
                if (!shown && patience == int.MaxValue && waited.ElapsedMilliseconds >= MeterAfterMilliseconds)
                {
                    StatusBar.ShowProgressMeter(0, 100, job.Label, true, true);
                    shown = true;
                }
                if (shown) StatusBar.UpdateProgressMeter((int)(100 * job.Progress), true);
            }
        }
        finally
        {
            if (shown) StatusBar.HideProgressMeter();
        }
        return true;
    }
}
