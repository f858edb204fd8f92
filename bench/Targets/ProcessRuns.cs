using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;

namespace Caterpillar.Bench;

/// <summary>Runs of a whole program, by GNU time: wall and processor time in seconds (medians), greatest memory in MB.</summary>
internal sealed record ProcessRuns(double Wall, double Processor, double Peak)
{
    public string Remark => string.Create(CultureInfo.InvariantCulture, $"{Processor:0.00} s processor, {Peak:0} MB");

    public static ProcessRuns Of(string program, string[] arguments, int runs = 5)
    {
        var times = Path.GetTempFileName();
        for (var run = 0; run < runs; run++)
        {
            using var process = Process.Start(new ProcessStartInfo("time", ["-a", "-o", times, "-f", "%e %U %S %M", program, .. arguments])
            {
                RedirectStandardError = true,
                RedirectStandardOutput = true,
            })!;
            var messages = process.StandardError.ReadToEndAsync();
            process.StandardOutput.BaseStream.CopyTo(Stream.Null);
            process.WaitForExit();
            if (process.ExitCode != 0) throw new InvalidOperationException($"{string.Join(' ', arguments)}: {messages.Result}");
        }
        var rows = File.ReadAllLines(times).Select(l => l.Split(' ').Select(w => double.Parse(w, CultureInfo.InvariantCulture)).ToArray()).ToArray();
        File.Delete(times);
        return new ProcessRuns(Median(rows.Select(r => r[0])), Median(rows.Select(r => r[1] + r[2])), rows.Max(r => r[3]) / 1024);
    }

    public static double Median(System.Collections.Generic.IEnumerable<double> values)
    {
        var sorted = values.Order().ToArray();
        return sorted[sorted.Length / 2];
    }
}
