using System.Runtime.InteropServices;
using System.Text;

namespace Caterpillar.Cli;

internal static class Program
{
    private static int Main(string[] args)
    {
        using var stop = new CancellationTokenSource();
        // The first Ctrl-C stops the work cleanly, the second one at once.
        Console.CancelKeyPress += (_, press) => press.Cancel = Stop(stop);
        using var terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, signal => signal.Cancel = Stop(stop));
        using var hangUp = PosixSignalRegistration.Create(PosixSignal.SIGHUP, signal => signal.Cancel = Stop(stop));
        using var messages = new StreamWriter(Console.OpenStandardError(), new UTF8Encoding(false)) { AutoFlush = true, NewLine = Environment.NewLine };
        var session = new Session(Console.OpenStandardInput, Console.OpenStandardOutput, messages)
        {
            Cancel = stop.Token,
            IsTerminal = !Console.IsErrorRedirected,
            EnforceMemory = Enforce,
            Profiles = new ProfileLibrary(Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.ApplicationData), "Caterpillar", "printers")),
        };
        return App.Run(args, session);
    }

    private static void Enforce(MemoryLimit limit)
    {
        AppContext.SetData("GCHeapHardLimit", (ulong)limit.Bytes);
        GC.RefreshMemoryLimit();
    }

    // True for the first request to stop.
    private static bool Stop(CancellationTokenSource stop)
    {
        if (stop.IsCancellationRequested) return false;
        stop.Cancel();
        return true;
    }
}
