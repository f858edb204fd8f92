using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
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
    /// <summary>Number of bytes that are read at a time: small, so that checks begin soon and what is read stays in the cache.</summary>
    internal const int ChunkSize = 64 * 1024;

    /// <summary>
    /// Writes to a stream, if there is one, and returns what was found; with the number of lines and bytes. Nothing is read where all checks are off.
    /// </summary>
    /// <param name="plan">What is written.</param>
    /// <param name="setup">The printer, material and settings.</param>
    /// <param name="format">The format of the file.</param>
    /// <param name="stream">The file; null where it is checked only.</param>
    /// <param name="early">Has checked the plan while it was made; null for nobody.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="cancel">Cancels.</param>
    public static (IReadOnlyList<Diagnostic> Findings, long Lines, long Bytes) Write(
        Toolpath plan, PrintSetup setup, GCodeFormat format, Stream? stream, EarlyCheck? early, IProgress<double>? progress, CancellationToken cancel)
    {
        var lines = new WrittenLines(plan.Count);
        var writer = new GCodeWriter(plan, format) { Written = lines };
        if (!new Findings(setup.Printer, plan).LooksFor([.. CheckCodes.All.Select(r => r.Code)]))
        {
            if (stream is not null) writer.WriteAll(stream, progress, cancel);
            return ([], writer.Lines, writer.Bytes);
        }
        using var strands = early is null && DepositCheck.IsAsked(setup.Printer) ? new DepositFollower(plan.Tools, setup, int.MaxValue, cancel) : null;
        strands?.Locate(plan, lines);
        early?.End();
        WrittenPlaces? places = null;
        var compared = NewFindings();
        RawModes.Run(plan, format, compared, index => places?.OfEvent(index));
        var comparison = compared.LooksFor(PlanComparison.Codes) ? new PlanComparison(plan, format, lines, compared) : null;
        var limits = new LimitFollower(plan.Tools, setup, NewFindings(), cancel);
        var blocks = 0;
        var file = Read(setup, writer, stream, Follow, progress.Part(0, 0.5), cancel);
        comparison?.End(file.Toolpath, blocks);
        var read = file.Toolpath.Tools.Count <= plan.Tools.Count ? file.Toolpath.WithTools(plan.Tools) : file.Toolpath;
        places = new WrittenPlaces(plan, move => move < 0 || move >= read.Count ? null : read[move].Source, lines, setup.Printer);
        var checks = PrintCheck.Run(read, setup, CheckScope.OfWritten(file, setup), NewFindings, progress.Part(0.5, 1), cancel, limits,
            (toolpath, heard) => early is null ? strands?.Finish(toolpath, places, heard) : early.Finish(toolpath, places, heard));
        return ([.. compared.ToList(), .. checks], writer.Lines, writer.Bytes);

        Findings NewFindings() => new(setup.Printer, move => places?.Of(move), what => places?.Of(what));

        void Follow(DecodedBlock block)
        {
            strands?.Take(block);
            comparison?.Take(block.Columns, block.Start);
            limits.Take(block);
            blocks++;
        }
    }

    /// <summary>Writes, and reads at the same time what is written; <paramref name="follow"/> gets each block that has been read.</summary>
    internal static DecodedGCode Read(
        PrintSetup setup, GCodeWriter writer, Stream? stream, Action<DecodedBlock> follow, IProgress<double>? progress, CancellationToken cancel)
    {
        var options = new DecodeOptions
        {
            Follow = follow, ChunkSize = ChunkSize,
            // Another one writes.
            Threads = Math.Max(Environment.ProcessorCount - 1, 1),
        };
        using var pipe = new BytePipe();
        var reading = OwnThread.Run(() => Decode(pipe, setup, options, cancel));
        try
        {
            using var both = new PipedStream(stream, pipe);
            writer.WriteAll(both, progress, cancel);
        }
        finally
        {
            pipe.Complete();
            // Its own problem counts only where writing had none.
            OwnThread.Wait(reading);
        }
        return OwnThread.Join(reading).OrThrow();
    }

    /// <summary>Reads what comes through a pipe, as the firmware of the printer does; then nothing more is taken from it.</summary>
    internal static Result<DecodedGCode> Decode(BytePipe pipe, PrintSetup setup, DecodeOptions options, CancellationToken cancel)
    {
        options = options with
        {
            Dialect = setup.Printer.Dialect, FilamentDiameter = setup.Material.FilamentDiameter, BlockSize = ToolpathBlock.FollowedSize,
        };
        try
        {
            return GCodeDecoder.DecodeStream(pipe.Reader, options, "", null, cancel);
        }
        finally
        {
            pipe.Stop();
        }
    }
}
