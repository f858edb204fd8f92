using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;

namespace Caterpillar.Bench;

/// <summary>
/// How long each stage of a slice takes, in one process: reading, sections and filling, planning, writing with all checks. The best of some rounds, and
/// walls of one width, walls of varying width and supports beside each other.
/// </summary>
internal static class Stages
{
    private const int Rounds = 3;

    /// <summary>A table in Markdown for meshes.</summary>
    public static void Run(string[] files)
    {
        Console.WriteLine("| mesh | read | slice | plan | write and check | slice, walls of one width | with grid supports | with trees |");
        Console.WriteLine("|---|---|---|---|---|---|---|---|");
        foreach (var file in files)
        {
            var setup = new PrintSetup();
            var settings = setup.Settings;
            var (read, models) = Best(() => MeshReader.Read(file).Value!.OnBed(setup.Printer));
            var (slice, layers) = Best(() => PlanarSlicer.Slice(models, settings).Value!);
            var steps = layers.ToSteps();
            var (plan, toolpath) = Best(() => Planner.Plan(steps, setup).Value!);
            var (write, _) = Best(() => SafeWriter.Write(toolpath, setup, Stream.Null, "bench"));
            var others = new[]
            {
                settings with { VariableWallWidth = false }, settings with { Support = SupportKind.Grid }, settings with { Support = SupportKind.Tree },
            }.Select(s => Best(() => PlanarSlicer.Slice(models, s)).Seconds);
            var cells = new[] { read, slice, plan, write }.Concat(others).Select(s => s.ToString("0.00", CultureInfo.InvariantCulture) + " s");
            Console.WriteLine($"| {Path.GetFileName(file)} | {string.Join(" | ", cells)} |");
        }
    }

    private static (double Seconds, T Value) Best<T>(Func<T> work)
    {
        var best = double.PositiveInfinity;
        var value = default(T);
        for (var i = 0; i < Rounds; i++)
        {
            var watch = Stopwatch.StartNew();
            value = work();
            best = Math.Min(best, watch.Elapsed.TotalSeconds);
        }
        return (best, value!);
    }
}
