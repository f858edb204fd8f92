using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>The result of a run of the program.</summary>
internal sealed record CliRun(int Code, byte[] Output, string Messages)
{
    public string Text => Encoding.UTF8.GetString(Output);
}

/// <summary>Runs the program in the test's process, in its own folder.</summary>
public abstract class CliFixture
{
    private string _before = "";

    protected string Folder { get; private set; } = "";

    [SetUp]
    public void EnterFolder()
    {
        _before = Environment.CurrentDirectory;
        Folder = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N"));
        Directory.CreateDirectory(Folder);
        Environment.CurrentDirectory = Folder;
    }

    [TearDown]
    public void LeaveFolder()
    {
        Environment.CurrentDirectory = _before;
        Directory.Delete(Folder, recursive: true);
    }

    private protected static CliRun Run(params string[] words) => Run([], words);

    private protected static CliRun Run(byte[] input, string[] words, CancellationToken cancel = default, bool terminal = false, Func<Stream>? output = null)
    {
        using var memory = new MemoryStream();
        using var messages = new StringWriter();
        var session = new Session(() => new MemoryStream(input), output ?? (() => new Unclosed(memory)), messages)
        {
            Cancel = cancel,
            IsTerminal = terminal,
            Profiles = new ProfileLibrary("profiles"),
        };
        var code = App.Run(words, session);
        return new CliRun(code, memory.ToArray(), messages.ToString());
    }

    /// <summary>Names of everything in the folder, including hidden files.</summary>
    protected static string[] Files() => new DirectoryInfo(".").GetFileSystemInfos().Select(f => f.Name).OrderBy(n => n, StringComparer.Ordinal).ToArray();

    /// <summary>An ASCII STL of a box with one corner at the origin, mm.</summary>
    protected static string Box(double x, double y, double z) => BoxAt(x, y, z, 0);

    /// <summary>The same with the x and y of its corner.</summary>
    protected static string BoxAt(double x, double y, double z, double corner)
    {
        double[][] p = [[0, 0, 0], [x, 0, 0], [x, y, 0], [0, y, 0], [0, 0, z], [x, 0, z], [x, y, z], [0, y, z]];
        int[][] faces = [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4], [1, 2, 6], [1, 6, 5], [2, 3, 7], [2, 7, 6], [3, 0, 4], [3, 4, 7]];
        var text = new StringBuilder("solid box\n");
        foreach (var face in faces)
        {
            text.Append("facet normal 0 0 0\nouter loop\n");
            foreach (var i in face) text.Append(FormattableString.Invariant($"vertex {p[i][0] + corner} {p[i][1] + corner} {p[i][2]}\n"));
            text.Append("endloop\nendfacet\n");
        }
        return text.Append("endsolid box\n").ToString();
    }

    private sealed class Unclosed(Stream inner) : Stream
    {
        public override bool CanRead => false;

        public override bool CanSeek => false;

        public override bool CanWrite => true;

        public override long Length => inner.Length;

        public override long Position { get => inner.Position; set => throw new NotSupportedException(); }

        public override void Flush() => inner.Flush();

        public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

        public override void SetLength(long value) => throw new NotSupportedException();

        public override void Write(byte[] buffer, int offset, int count) => inner.Write(buffer, offset, count);
    }
}
