using System;
using System.IO;

namespace Caterpillar.Cli;

/// <summary>Writes files whole or not at all.</summary>
internal static class WholeFile
{
    /// <summary>Writes to a temporary file beside the target, which then takes its place; what is no regular file (a device, a pipe) is written directly.</summary>
    public static void Write(string file, Func<Stream> standardOutput, Action<Stream> write)
    {
        if (file == "-")
        {
            using var output = standardOutput();
            write(output);
            output.Flush();
            return;
        }
        var target = Path.GetFullPath(file);
        if (Directory.Exists(target)) throw new CliException(ExitCode.BadInput, $"{file}: is a folder, not a file.");
        if (File.Exists(target) && File.ResolveLinkTarget(target, returnFinalTarget: true) is { } link) target = link.FullName;
        if (IsSpecial(target))
        {
            using var direct = new FileStream(target, FileMode.Open, FileAccess.Write);
            write(direct);
            return;
        }
        var temporary = Path.Combine(Path.GetDirectoryName(target)!, "." + Path.GetFileName(target) + "." + Path.GetRandomFileName());
        try
        {
            using (var stream = new FileStream(temporary, FileMode.CreateNew, FileAccess.Write, FileShare.None, 1 << 16)) write(stream);
            if (!OperatingSystem.IsWindows() && File.Exists(target)) File.SetUnixFileMode(temporary, File.GetUnixFileMode(target));
            File.Move(temporary, target, overwrite: true);
        }
        catch
        {
            File.Delete(temporary);
            throw;
        }
    }

    private static bool IsSpecial(string file)
    {
        if (OperatingSystem.IsWindows() || !File.Exists(file)) return false;
        if (file.StartsWith("/dev/", StringComparison.Ordinal) || file.StartsWith("/proc/", StringComparison.Ordinal)) return true;
        var info = new FileInfo(file);
        return (info.Attributes & FileAttributes.Device) != 0;
    }
}
