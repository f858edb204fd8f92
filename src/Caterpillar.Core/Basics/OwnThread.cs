namespace Caterpillar.Basics;

/// <summary>
/// Work on a thread of its own. For all that waits for others: the few threads that the runtime shares would be used up by it, and more come only slowly.
/// </summary>
internal static class OwnThread
{
    public static Task<T> Run<T>(Func<T> work)
        => Task.Factory.StartNew(work, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);

    public static Task Run(Action work) => Task.Factory.StartNew(work, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);

    /// <summary>Waits for the end, whatever it is.</summary>
    public static void Wait(Task work) => ((IAsyncResult)work).AsyncWaitHandle.WaitOne();

    /// <summary>The result, or the problem of the work as it was thrown.</summary>
    public static T Join<T>(Task<T> work)
    {
        Wait(work);
        return work.GetAwaiter().GetResult();
    }
}
