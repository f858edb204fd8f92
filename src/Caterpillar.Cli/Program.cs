using System.Runtime.InteropServices;
using Microsoft.Win32.SafeHandles;

namespace Caterpillar.Cli;

internal static class Program
{
    private static int Main(string[] args)
    {
        // Where the runtime cannot reserve address space it ends abruptly, in any place.
        if (AddressSpace.TooSmall() is not { } problem) return Run(args);
        // The console needs memory, too.
        using var messages = new FileStream(new SafeFileHandle(2, false), FileAccess.Write, 0);
        messages.Write(Encoding.UTF8.GetBytes(problem + "\n"));
        return ExitCode.BadInput;
    }

    // Apart, since it loads the library.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static int Run(string[] args)
    {
        using var stop = new CancellationTokenSource();
        using var standardError = new StandardStream(Console.OpenStandardError(), true);
        using var messages = new StreamWriter(standardError, new UTF8Encoding(false)) { AutoFlush = true, NewLine = Environment.NewLine };
        var session = new Session(Console.OpenStandardInput, () => new StandardStream(Console.OpenStandardOutput(), false), messages)
        {
            Cancel = stop.Token,
            IsTerminal = !Console.IsErrorRedirected,
            EnforceMemory = Enforce,
            Profiles = new ProfileLibrary(Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.ApplicationData), "Caterpillar", "printers")),
        };
        // The first Ctrl-C stops the work cleanly, the second one at once.
        Console.CancelKeyPress += (_, press) => press.Cancel = Stop(stop, session);
        using var terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, signal => signal.Cancel = Stop(stop, session));
        using var hangUp = PosixSignalRegistration.Create(PosixSignal.SIGHUP, signal => signal.Cancel = Stop(stop, session));
        return App.Run(args, session);
    }

    private static void Enforce(MemoryLimit limit)
    {
        AppContext.SetData("GCHeapHardLimit", (ulong)limit.Bytes);
        GC.RefreshMemoryLimit();
    }

    // True for the first request to stop.
    private static bool Stop(CancellationTokenSource stop, Session session)
    {
        if (stop.IsCancellationRequested)
        {
            session.Unfinished.Delete();
            return false;
        }
        new Thread(() => EndSoon(session)) { IsBackground = true }.Start();
        stop.Cancel();
        return true;
    }

    private static void EndSoon(Session session)
    {
        Thread.Sleep(session.Grace);
        session.Abandon();
        Environment.Exit(ExitCode.Interrupted);
    }
}
