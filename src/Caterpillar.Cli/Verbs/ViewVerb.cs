using System.Diagnostics;
using System.Net;
using Caterpillar.Display;

namespace Caterpillar.Cli;

/// <summary>Writes or serves a web page that shows a print, a model or a design in 3D.</summary>
internal sealed class ViewVerb : Verb
{
    private const string Reason = "Made to be looked at in a viewer page, not to be printed.";

    private readonly Argument<string> _file = new("FILE")
    {
        Description = "G-code (also binary or packed with gzip), a mesh (STL, OBJ, PLY, 3MF), a turtle program (.turtle) or curves (.csv, .svg, .json); "
            + "- is G-code from standard input.",
    };

    private readonly Described<string?> _out = new("--output",
        "The page, one file that needs no network; - is standard output. By default the name of the input with .html, in the current folder.",
        "FILE.html", "-o");

    private readonly Described<bool> _open = new("--open", "Open the page in the browser.");

    private readonly Described<int?> _serve = new("--serve",
        "Serve the page on this machine instead, and keep it up to date while the file changes, until Ctrl-C.", "PORT") { Arity = ArgumentArity.ZeroOrOne };

    private readonly Described<bool> _noLines = new("--no-lines", "Leave the text of the G-code out of the page, which is smaller then.");
    private readonly SetupOptions _setup = new();

    public ViewVerb()
        : base("view", "Show a print, a model or a design in 3D in the browser.")
    {
        Arguments.Add(_file);
        Add([_out, _open, _serve, _noLines, .. _setup.All]);
        Validators.Add(result =>
        {
            if (result.GetResult(_serve) is not null && result.GetResult(_out) is not null) result.AddError("Use --serve or --output, not both.");
            if (result.GetResult(_serve) is not null && result.GetValue(_file) == "-") result.AddError("--serve needs a file, not standard input.");
        });
        AllowBatches();
    }

    public override IReadOnlyList<(string Line, string Does)> Examples =>
    [
        ("view part.gcode -o part.html", "one page to look at or to send"),
        ("view part.gcode --printer ender3", "with the bed of a printer, and what its checks find"),
    ];

    public override string[] Writes => ["a page"];

    public override string? Ending => ".html";

    public override int Run(ParseResult arguments, Session session)
    {
        var file = arguments.GetValue(_file)!;
        var source = new ViewSource(_setup, arguments, !arguments.GetValue(_noLines), design => GCodeOf(design, arguments, session), session);
        if (arguments.GetResult(_serve) is not null) return Serve(file, source, arguments, session);
        var output = arguments.GetValue(_out) ?? Path.GetFileNameWithoutExtension(file == "-" ? "view" : file) + ".html";
        if (output == "-" && arguments.GetValue(_open)) throw new CliException(ExitCode.Usage, "--open needs a file to open: give -o FILE.html.");
        var content = source.Read(file);
        var bytes = Page(content, session);
        session.Write(output, stream => stream.Write(bytes));
        session.Say(() => $"{Session.NameOfOutput(output)}: {PrintSummary.Size(bytes.Length)}; {Session.NameOf(file)}: {source.Summary}");
        if (arguments.GetValue(_open)) Open(Path.GetFullPath(output));
        return ExitCode.Done;
    }

    // The verb writes what it would write for a printer, whatever the checks find: that is what is looked at.
    private byte[] GCodeOf(string file, ParseResult arguments, Session session)
    {
        using var memory = new MemoryStream();
        var inner = new Session(() => Stream.Null, () => memory, session.Messages)
        {
            IsPart = true, Cancel = session.Cancel, Profiles = session.Profiles, Quiet = session.Quiet, Memory = session.Memory,
        };
        Verb verb = ViewSource.Ending(file) == ".TURTLE" ? new TurtleVerb() : new CurvesVerb();
        string[] given = [file, "--output", "-", "--override", Reason, .. _setup.Given(arguments)];
        var code = verb.Run(verb.Parse(given), inner);
        return code == ExitCode.Done ? memory.ToArray() : throw new CliException(code);
    }

    private static byte[] Page(ViewerContent content, Session session)
    {
        using var memory = new MemoryStream();
        session.WithProgress("Writing", progress =>
        {
            ViewerPage.Write(content, memory, progress, session.Cancel);
            return 0;
        });
        return memory.ToArray();
    }

    private int Serve(string file, ViewSource source, ParseResult arguments, Session session)
    {
        var port = arguments.GetValue(_serve) ?? 8417;
        if (port is < 1 or > 65535) throw new CliException(ExitCode.Usage, "--serve needs a port from 1 to 65535.");
        using var server = Started(port);
        var read = File.GetLastWriteTimeUtc(file);
        server.Show(Page(source.Read(file), session));
        session.Messages.WriteLine($"{server.Address} shows {file}; Ctrl-C stops.");
        var answering = server.Run(session.Cancel);
        if (arguments.GetValue(_open)) Open(server.Address);
        while (!session.Cancel.WaitHandle.WaitOne(300))
        {
            if (File.GetLastWriteTimeUtc(file) is var written && written == read) continue;
            read = written;
            try
            {
                server.Show(Page(source.Read(file), session));
                session.Messages.WriteLine($"{file} has changed; the page shows it.");
            }
            catch (Exception bad) when (bad is CliException or IOException)
            {
                // The last good page stays until the file is repaired.
                if (bad.Message.Length > 0) session.Messages.WriteLine(bad.Message);
            }
        }
        answering.Wait(CancellationToken.None);
        return ExitCode.Done;
    }

    private static PageServer Started(int port)
    {
        try
        {
            return new PageServer(port);
        }
        catch (HttpListenerException taken)
        {
            throw new CliException(ExitCode.BadInput, $"Port {port} cannot be used: {taken.Message} Choose another with --serve PORT.");
        }
    }

    private static void Open(string place)
    {
        try
        {
            using var browser = Process.Start(new ProcessStartInfo(place) { UseShellExecute = true });
        }
        catch (Exception none) when (none is System.ComponentModel.Win32Exception or PlatformNotSupportedException)
        {
            throw new CliException(ExitCode.BadInput, $"No browser could be started; open {place} yourself.");
        }
    }
}
