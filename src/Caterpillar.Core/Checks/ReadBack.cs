using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Caterpillar.Basics;
using Caterpillar.Files;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>
/// Writes a toolpath and at the same time reads what is written, as the firmware of the printer does: start and end code, templates and raw lines too. What
/// was read is compared with the plan and checked.
/// </summary>
internal static class ReadBack
{
    /// <summary>Writes to a stream, if there is one, and returns what was found; with the number of lines and bytes.</summary>
    public static (IReadOnlyList<Diagnostic> Findings, long Lines, long Bytes) Write(
        Toolpath plan, PrintSetup setup, GCodeFormat format, Stream? stream, IProgress<double>? progress, CancellationToken cancel)
    {
        var lines = new WrittenLines(plan.Count);
        var writer = new GCodeWriter(plan, format) { Written = lines };
        using var strands = new DepositFollower(plan, setup, lines, cancel);
        var file = Read(setup, writer, stream, strands.Take, progress.Part(0, 0.5), cancel);
        var read = file.Toolpath.Tools.Count <= plan.Tools.Count ? file.Toolpath.WithTools(plan.Tools) : file.Toolpath;
        var places = new WrittenPlaces(plan, move => move < 0 || move >= read.Count ? null : read[move].Source, lines, setup.Printer);
        Findings Make() => new(setup.Printer, places.Of, places.Of);
        var compared = Make();
        var comparing = Task.Run(() =>
        {
            RawModes.Run(plan, format, compared, places.OfEvent);
            PlanComparison.Run(plan, read, format, lines, compared);
        }, CancellationToken.None);
        IReadOnlyList<Diagnostic> checks;
        try
        {
            checks = PrintCheck.Run(read, setup, CheckScope.OfWritten(file, setup), Make, progress.Part(0.5, 1), cancel, strands);
        }
        finally
        {
            comparing.Wait(CancellationToken.None);
        }
        return ([.. compared.ToList(), .. checks], writer.Lines, writer.Bytes);
    }

    private static DecodedGCode Read(
        PrintSetup setup, GCodeWriter writer, Stream? stream, Action<DecodedBlock> follow, IProgress<double>? progress, CancellationToken cancel)
    {
        var options = new DecodeOptions { Dialect = setup.Printer.Dialect, FilamentDiameter = setup.Material.FilamentDiameter, Follow = follow };
        using var pipe = new BytePipe();
        var reading = Task.Run(() =>
        {
            try
            {
                return GCodeDecoder.DecodeStream(pipe.Reader, options, "", null, cancel);
            }
            finally
            {
                pipe.Stop();
            }
        }, CancellationToken.None);
        try
        {
            using var both = new PipedStream(stream, pipe);
            writer.WriteAll(both, progress, cancel);
        }
        finally
        {
            pipe.Complete();
            // Its own problem counts only where writing had none.
            ((IAsyncResult)reading).AsyncWaitHandle.WaitOne();
        }
        return reading.GetAwaiter().GetResult().OrThrow();
    }
}
