using System;
using System.Diagnostics;
using System.IO;
using System.Text;
using System.Threading.Tasks;
using Caterpillar.Checks;
using Caterpillar.Files;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

[Category("Runtime")]
public class WholeFileTests
{
    private string _folder = "";

    [SetUp]
    public void MakeFolder()
    {
        _folder = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N"));
        Directory.CreateDirectory(_folder);
    }

    [TearDown]
    public void RemoveFolder() => Directory.Delete(_folder, true);

    [Test]
    public void A_file_appears_once_it_is_complete()
    {
        var file = In("part.gcode");
        foreach (var text in new[] { "first", "2nd" })
        {
            var before = File.Exists(file) ? File.ReadAllText(file) : null;
            using (var whole = new AtomicFile(file))
            {
                Put(whole, text);
                whole.Stream.Flush();
                Assert.That(File.Exists(file) ? File.ReadAllText(file) : null, Is.EqualTo(before));
                whole.Commit();
                Assert.That(() => whole.Stream, Throws.InstanceOf<ObjectDisposedException>());
            }
            Assert.That(File.ReadAllText(file), Is.EqualTo(text));
        }
        Assert.That(Directory.GetFileSystemEntries(_folder), Has.Length.EqualTo(1));
    }

    [Test]
    public void Without_commit_nothing_changes()
    {
        var file = In("part.gcode");
        using (var whole = new AtomicFile(file)) Put(whole, "half");
        Assert.That(Directory.GetFileSystemEntries(_folder), Is.Empty);
        File.WriteAllText(file, "old");
        using (var whole = new AtomicFile(file)) Put(whole, "half");
        Assert.That(File.ReadAllText(file), Is.EqualTo("old"));
        Assert.That(Directory.GetFileSystemEntries(_folder), Has.Length.EqualTo(1));
    }

    [Test]
    public void Folders_and_missing_folders_are_errors()
    {
        Assert.That(() => new AtomicFile(_folder), Throws.InstanceOf<IOException>().With.Message.Contains("is a folder"));
        Assert.That(() => new AtomicFile(In("no/part.gcode")), Throws.InstanceOf<IOException>());
    }

    [Test]
    public void Names_may_be_as_long_as_the_disk_allows()
    {
        var file = In(new string('n', 240) + ".gcode");
        Save(file, "long");
        Assert.That(File.ReadAllText(file), Is.EqualTo("long"));
    }

    [Test]
    public void A_link_stays_a_link_and_permissions_stay()
    {
        Unix();
        File.WriteAllText(In("real.gcode"), "a longer old text");
        foreach (var rights in new[] { "600", "640", "755" })
        {
            Assert.That(Shell("chmod", rights, In("real.gcode")), Is.Empty);
            Shell("ln", "-sf", "real.gcode", In("first"));
            Shell("ln", "-sf", In("first"), In("second"));
            Save(In("second"), "new");
            Assert.That(File.ReadAllText(In("real.gcode")), Is.EqualTo("new"));
            Assert.That(Shell("ls", "-l", In("second")), Does.Contain("-> " + In("first")));
            Assert.That(Shell("ls", "-l", In("first")), Does.Contain("-> real.gcode"));
            Assert.That(Shell("ls", "-l", In("real.gcode")), Does.StartWith(rights switch { "600" => "-rw-------", "640" => "-rw-r-----", _ => "-rwxr-xr-x" }));
        }
        Assert.That(Directory.GetFileSystemEntries(_folder), Has.Length.EqualTo(3));
    }

    [Test]
    public void A_file_that_is_read_only_can_be_replaced_and_stays_so()
    {
        Unix();
        File.WriteAllText(In("a"), "old");
        Shell("chmod", "444", In("a"));
        Save(In("a"), "new");
        Assert.That(File.ReadAllText(In("a")), Is.EqualTo("new"));
        Assert.That(Directory.GetFileSystemEntries(_folder), Has.Length.EqualTo(1));
    }

    [Test]
    public void Devices_and_pipes_are_written_and_not_replaced()
    {
        Unix();
        Save("/dev/null", "gone");
        Assert.That(new FileInfo("/dev/null").Length, Is.Zero);
        if (File.Exists("/dev/full")) Assert.That(() => Save("/dev/full", "no room"), Throws.InstanceOf<IOException>());
        Shell("mkfifo", In("pipe"));
        var read = Task.Run(() =>
        {
            using var pipe = new FileStream(In("pipe"), FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
            using var text = new StreamReader(pipe);
            return text.ReadToEnd();
        });
        Save(In("pipe"), "through");
        Assert.That(read.Wait(20_000), Is.True);
        Assert.That(read.Result, Is.EqualTo("through"));
        Assert.That(Shell("ls", "-l", In("pipe")), Does.StartWith("p"));
    }

    private static void Unix()
    {
        if (Path.DirectorySeparatorChar != '/') Assert.Ignore("There are no such files here.");
    }

    private string In(string name) => Path.Combine(_folder, name);

    private static void Save(string file, string text)
    {
        using var whole = new AtomicFile(file);
        Put(whole, text);
        whole.Commit();
    }

    private static void Put(AtomicFile whole, string text) => whole.Stream.Write(Encoding.ASCII.GetBytes(text), 0, text.Length);

    private static string Shell(string program, params string[] arguments)
    {
        using var process = Process.Start(new ProcessStartInfo(program, string.Join(" ", arguments)) { RedirectStandardOutput = true,
            UseShellExecute = false })!;
        var output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return output;
    }
}
