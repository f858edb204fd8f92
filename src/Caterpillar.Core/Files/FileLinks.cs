#if !NET8_0_OR_GREATER
using System.Runtime.InteropServices;
using System.Text;
#endif

namespace Caterpillar.Files;

/// <summary>Links, devices and permissions of files, on Windows and Unix.</summary>
internal static class FileLinks
{
    private const int Buffer = 1 << 16;

    private static bool IsUnix => Path.DirectorySeparatorChar == '/';

    /// <summary>The file that a path refers to after following links, whether it exists or not.</summary>
    /// <exception cref="IOException">The links form a cycle.</exception>
    public static string Target(string path)
    {
#if NET8_0_OR_GREATER
        var target = new FileInfo(path).LinkTarget is null ? path : File.ResolveLinkTarget(path, returnFinalTarget: true)!.FullName;
        // A pipe has no name but that of its link, such as /dev/stdout; other links may lead to a file that is still to be written.
        return path.StartsWith("/dev/", StringComparison.Ordinal) && !File.Exists(target) ? path : target;
#else
        if (!IsUnix || !File.Exists(path)) return path;
        var name = new byte[Encoding.UTF8.GetMaxByteCount(path.Length) + 1];
        Encoding.UTF8.GetBytes(path, 0, path.Length, name, 0);
        var real = new byte[4097];
        if (RealPath(name, real) == IntPtr.Zero) return path;
        return Encoding.UTF8.GetString(real, 0, Array.IndexOf(real, (byte)0));
#endif
    }

    /// <summary>Opens a device or a pipe, which must be written directly. Null for regular files.</summary>
    /// <exception cref="IOException">It cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">No permission to write it.</exception>
    public static FileStream? Special(string file)
    {
        if (!MayBeSpecial(file)) return null;
        if (IsDevice(file)) return Open(file);
        FileStream stream;
        try
        {
            // A pipe waits here for its reader, which must stay connected.
            stream = Open(file);
        }
        catch (UnauthorizedAccessException)
        {
            return null;
        }
        if (!stream.CanSeek) return stream;
        stream.Dispose();
        return null;
    }

    /// <summary>True for devices, and for files without length, such as pipes.</summary>
    public static bool MayBeSpecial(string file) => IsUnix && File.Exists(file) && (IsDevice(file) || new FileInfo(file).Length == 0);

    /// <summary>A new file that will replace another one.</summary>
    public static FileStream Create(string file, string target)
    {
#if !NET8_0_OR_GREATER
        // Mono has no call for permissions; a copy keeps them.
        if (IsUnix && File.Exists(target))
        {
            try
            {
                File.Copy(target, file);
                return new FileStream(file, FileMode.Truncate, FileAccess.Write, FileShare.None, Buffer);
            }
            catch (UnauthorizedAccessException)
            {
                File.Delete(file);
            }
        }
#endif
        return new FileStream(file, FileMode.CreateNew, FileAccess.Write, FileShare.None, Buffer);
    }

    /// <summary>Replaces the other file and takes its permissions.</summary>
    public static void Replace(string file, string target)
    {
        if (!File.Exists(target))
        {
            File.Move(file, target);
            return;
        }
#if NET8_0_OR_GREATER
        if (!OperatingSystem.IsWindows())
        {
            File.SetUnixFileMode(file, File.GetUnixFileMode(target));
            File.Move(file, target, overwrite: true);
            return;
        }
#endif
        File.Replace(file, target, null, true);
    }

    private static bool IsDevice(string file)
        => file.StartsWith("/dev/", StringComparison.Ordinal) || file.StartsWith("/proc/", StringComparison.Ordinal)
            || (File.GetAttributes(file) & FileAttributes.Device) != 0;

    private static FileStream Open(string file) => new(file, FileMode.Open, FileAccess.Write, FileShare.ReadWrite, Buffer);

#if !NET8_0_OR_GREATER
    [DllImport("libc", EntryPoint = "realpath")]
    private static extern IntPtr RealPath(byte[] path, byte[] resolved);
#endif
}
