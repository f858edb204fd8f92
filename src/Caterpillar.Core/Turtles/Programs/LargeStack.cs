using System.Runtime.ExceptionServices;

namespace Caterpillar.Turtles;

/// <summary>Runs deeply nested work on a thread with a large stack, since the stack size of the host's threads varies.</summary>
internal static class LargeStack
{
    // For functions that call each other a thousand levels deep.
    private const int Bytes = 64 << 20;

    /// <summary>Waits for the end of the work and throws its exceptions here.</summary>
    public static void Run(Action work)
    {
        ExceptionDispatchInfo? failure = null;
        var thread = new Thread(
            () =>
            {
                try
                {
                    work();
                }
                catch (Exception e)
                {
                    failure = ExceptionDispatchInfo.Capture(e);
                }
            },
            Bytes) { IsBackground = true };
        thread.Start();
        thread.Join();
        failure?.Throw();
    }
}
