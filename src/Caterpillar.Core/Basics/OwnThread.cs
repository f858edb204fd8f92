namespace Caterpillar.Basics;

/// <summary>Runs work on its own thread. For work that waits: it would use up the thread pool, which grows slowly.</summary>
internal static class OwnThread
{
    public static Task<T> Run<T>(Func<T> work)
        => Task.Factory.StartNew(work, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);

    public static Task Run(Action work) => Task.Factory.StartNew(work, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);

    /// <summary>Runs work on a thread with a stack of so many bytes and waits for it.</summary>
    public static void Run(Action work, int stack)
    {
        var task = new Task(work);
        var thread = new Thread(() => task.RunSynchronously(TaskScheduler.Default), stack) { IsBackground = true };
        thread.Start();
        thread.Join();
        task.GetAwaiter().GetResult();
    }

    /// <summary>Waits for the end, successful or not.</summary>
    public static void Wait(Task work) => ((IAsyncResult)work).AsyncWaitHandle.WaitOne();

    /// <summary>Waits for the end, successful or not, unless canceled.</summary>
    public static void WaitOr(Task work, CancellationToken cancel)
    {
        WaitHandle.WaitAny([((IAsyncResult)work).AsyncWaitHandle, cancel.WaitHandle]);
        if (!work.IsCompleted) cancel.ThrowIfCancellationRequested();
    }

    /// <summary>The result, or the original exception of the work.</summary>
    public static T Join<T>(Task<T> work)
    {
        Wait(work);
        return work.GetAwaiter().GetResult();
    }
}
