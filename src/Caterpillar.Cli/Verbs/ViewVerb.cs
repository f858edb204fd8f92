using System.Diagnostics;

namespace Caterpillar.Cli;

/// <summary>Writes or serves a web page that shows a print, a model or a design in 3D.</summary>
internal sealed class ViewVerb : Verb
{
    private const string Reason = "For a viewer page, not for printing.";

    private readonly Argument<string> _file = new("FILE")
    {
        Description = "G-code (text, .bgcode, gzip), mesh (STL, OBJ, PLY, 3MF), turtle program (.turtle) or curves (.csv, .svg, .json); - = G-code from "
            + "standard input.",
    };

    private readonly Described<string?> _out = new("--output",
        "Output HTML file, which needs no network; FILE.js = a script with an element for pages of your own; - = standard output. "
            + CommonOptions.DefaultOutput, "FILE.html", "-o");

    private readonly Described<bool> _open = new("--open", "Open the page in the browser.");

    private readonly Described<int?> _serve = new("--serve",
        "Serve the page on this machine instead, and update it when the file changes, until Ctrl-C. Default port: 8417.",
        "PORT") { Arity = ArgumentArity.ZeroOrOne };

    private readonly Described<bool> _noGCode = new("--no-gcode", "Leave the G-code text out of the page, to make it smaller.");
    private readonly SetupOptions _setup = new("If given, findings of its checks are shown. " + SetupOptions.FromFile);

    public ViewVerb()
        : base("view", "Show a print, model or design in 3D in the browser.", ["a page", "a script"], ".html")
    {
        Arguments.Add(_file);
        Add([_out, _open, _serve, _noGCode, .. _setup.All]);
        Validators.Add(result =>
        {
            if (result.GetResult(_serve) is not null && result.GetResult(_out) is not null) result.AddError("--serve cannot be combined with --output.");
            if (result.GetResult(_serve) is not null && result.GetValue(_file) == "-") result.AddError("--serve needs a file, not standard input.");
        });
        AllowBatches();
    }

    public override int Run(ParseResult arguments, Session session)
    {
        var file = arguments.GetValue(_file)!;
        var source = new ViewSource(_setup, arguments, !arguments.GetValue(_noGCode), design => GCodeOf(design, arguments, session), session);
        if (arguments.GetResult(_serve) is not null) return Serve(file, source, arguments, session);
        var output = arguments.GetValue(_out) ?? Path.GetFileNameWithoutExtension(file == "-" ? "view" : file) + ".html";
        if (arguments.GetValue(_open) && (output == "-" || ViewerPage.IsScript(output))) throw CliException.Usage("--open needs a page. Give -o FILE.html.");
        var content = source.Read(file);
        var bytes = Page(content, session, ViewerPage.IsScript(output));
        session.Write(output, stream => stream.Write(bytes));
        session.Say(() => $"{Session.NameOfOutput(output)}: {PrintSummary.Size(bytes.Length)}; {Session.NameOf(file)}: {source.Summary}");
        if (arguments.GetValue(_open)) Open(Path.GetFullPath(output));
        return ExitCode.Done;
    }

    // The same G-code as for a printer, even if a check would refuse it.
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

    private static byte[] Page(ViewerContent content, Session session, bool asScript = false)
    {
        using var memory = new MemoryStream();
        session.WithProgress("Writing", progress =>
        {
            if (asScript) ViewerPage.WriteScript(content, memory, progress, session.Cancel);
            else ViewerPage.Write(content, memory, progress, session.Cancel);
            return 0;
        });
        return memory.ToArray();
    }

    private int Serve(string file, ViewSource source, ParseResult arguments, Session session)
    {
        var port = arguments.GetValue(_serve) ?? 8417;
        if (port is < 1 or > 65535) throw CliException.Usage("--serve needs a port from 1 to 65535.");
        using var server = Started(port);
        session.Grace = TimeSpan.FromSeconds(5);
        var read = File.GetLastWriteTimeUtc(file);
        server.Show(Page(source.Read(file), session));
        session.Messages.WriteLine($"Serving {file} at {server.Address}. Press Ctrl-C to stop.");
        var answering = server.Run(session.Cancel);
        if (arguments.GetValue(_open)) Open(server.Address);
        while (!session.Cancel.WaitHandle.WaitOne(300))
        {
            if (File.GetLastWriteTimeUtc(file) is var written && written == read) continue;
            read = written;
            try
            {
                server.Show(Page(source.Read(file), session));
                session.Messages.WriteLine($"{file} changed. The page is updated.");
            }
            catch (Exception bad) when (bad is CliException or IOException or DiagnosticException)
            {
                // The last good page stays until the file is corrected.
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
            throw new CliException(ExitCode.BadInput, $"Port {port} is not available: {taken.Message} Choose another one with --serve PORT.");
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
            throw new CliException(ExitCode.BadInput, $"The browser could not be started. Open {place} manually.");
        }
    }
}
