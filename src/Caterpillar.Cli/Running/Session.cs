using Spectre.Console;

namespace Caterpillar.Cli;

/// <summary>Environment of a verb: streams, profiles, cancellation, progress and messages.</summary>
internal sealed class Session(Func<Stream> input, Func<Stream> output, TextWriter messages)
{
    /// <summary>Advice if the memory limit is exceeded.</summary>
    public const string MoreMemory = "Raise the limit, for example with --memory-limit 8GB.";

    /// <summary>The message when the work was canceled.</summary>
    public const string Interrupted = "Interrupted. Nothing was written.";

    /// <summary>Code of the note about words of a file without effect, such as M84.</summary>
    public const string Harmless = "gcode.ignored";

    private readonly TextWriter _messages = messages;

    /// <summary>Output for messages: standard error.</summary>
    public TextWriter Messages { get; } = new VisibleText(messages);

    public CancellationToken Cancel { get; init; }

    /// <summary>Time for the work to end by itself when it is canceled.</summary>
    public TimeSpan Grace { get; set; } = TimeSpan.FromSeconds(0.4);

    /// <summary>Files that are being written.</summary>
    public UnfinishedFiles Unfinished { get; init; } = new();

    /// <summary>Standard error is a terminal, so progress may be drawn.</summary>
    public bool IsTerminal { get; init; }

    public ProfileLibrary Profiles { get; init; } = new();

    /// <summary>Only errors and warnings are printed.</summary>
    public bool Quiet { get; set; }

    /// <summary>The work is part of other work, which prints its own summary.</summary>
    public bool IsPart { get; init; }

    /// <summary>The work is one of many runs, whose figures are collected for a table.</summary>
    public bool Collects { get; init; }

    /// <summary>Figures of the written file, if they are collected.</summary>
    public WrittenFigures? Written { get; private set; }

    /// <summary>The work ended because memory ran out.</summary>
    public bool LacksMemory { get; set; }

    /// <summary>The first error that was found.</summary>
    public Diagnostic? FirstError { get; private set; }

    /// <summary>Memory limit of the work.</summary>
    public MemoryLimit Memory { get; set; } = MemoryLimit.Default;

    /// <summary>Makes the runtime enforce the limit if an estimate fails; null = other code shares the process.</summary>
    public Action<MemoryLimit>? EnforceMemory { get; init; }

    /// <summary>The bytes of a file, or of standard input for <c>-</c>.</summary>
    public byte[] ReadBytes(string file)
    {
        using var stream = OpenRead(file);
        if (stream.CanSeek && stream.Length > 0) return File.ReadAllBytes(file);
        using var memory = new MemoryStream();
        stream.CopyTo(memory);
        return memory.ToArray();
    }

    /// <summary>A file as a stream, or standard input for <c>-</c>.</summary>
    public Stream OpenRead(string file)
    {
        if (file == "-") return new StoppableStream(input(), Cancel);
        NoFolder(file);
        // A named pipe waits here for its writer.
        var opened = Task.Run(() => new FileStream(file, FileMode.Open, FileAccess.Read, FileShare.Read, 1, FileOptions.SequentialScan), Cancel);
        OwnThread.WaitOr(opened, Cancel);
        var stream = opened.GetAwaiter().GetResult();
        return stream.CanSeek ? stream : new StoppableStream(stream, Cancel);
    }

    /// <summary>The name of an input in messages.</summary>
    public static string NameOf(string file) => file == "-" ? "standard input" : file;

    /// <summary>The name of an output in messages.</summary>
    public static string NameOfOutput(string file) => file == "-" ? "standard output" : file;

    /// <summary>Writes a file whole or not at all, or standard output for <c>-</c>.</summary>
    public void Write(string file, Action<Stream> write) => Write(file, (stream, _) => write(stream));

    /// <summary>The same. The second argument of <paramref name="write"/> is true if the output is discarded on failure.</summary>
    public void Write(string file, Action<Stream, bool> write)
    {
        if (file == "-")
        {
            // It may be written several times.
            var stream = output();
            write(stream, false);
            stream.Flush();
            return;
        }
        NoFolder(file);
        using var whole = new AtomicFile(file);
        Unfinished.Add(whole);
        try
        {
            write(whole.Stream, whole.IsTemporary);
            whole.Commit();
        }
        finally
        {
            Unfinished.Remove(whole);
        }
    }

    /// <summary>Writes text in UTF-8.</summary>
    public void WriteText(string file, Action<TextWriter> write) => Write(file, stream =>
    {
        using var writer = new StreamWriter(stream, new UTF8Encoding(false), 1 << 16, leaveOpen: true) { NewLine = "\n" };
        write(file == "-" ? new VisibleText(writer) : writer);
    });

    /// <summary>Prints a line of the summary.</summary>
    public void Say(Func<string> line)
    {
        if (!Quiet) Messages.WriteLine(line());
    }

    /// <summary>Prints the summary of the written file, and keeps its figures for a table.</summary>
    public void Made(Func<PrintFigures> print, long lines, long bytes, Func<PrintFigures, string> line)
    {
        if (Quiet && !Collects) return;
        var figures = print();
        Written = new WrittenFigures(figures, lines, bytes);
        if (!Quiet && !IsPart) Messages.WriteLine(line(figures));
    }

    /// <summary>Keeps the first error of findings that are not printed as messages.</summary>
    public void Found(IEnumerable<Diagnostic> findings) => FirstError ??= findings.FirstOrDefault(d => d.Severity == Severity.Error);

    /// <summary>Prints diagnostics, one line each, except the note about words without effect.</summary>
    public void Print(IEnumerable<Diagnostic> diagnostics)
    {
        foreach (var diagnostic in diagnostics)
        {
            Found([diagnostic]);
            if (diagnostic.Severity == Severity.Note && (Quiet || diagnostic.Code == Harmless)) continue;
            Messages.WriteLine(diagnostic.ToString());
            if (diagnostic.Code == MemoryLimit.Code) Messages.WriteLine(MoreMemory);
        }
    }

    /// <summary>The decoded file. A file that is not G-code is bad input.</summary>
    /// <exception cref="CliException">The file cannot be decoded.</exception>
    public DecodedGCode GCodeOrFail(Result<DecodedGCode> result)
        => result.Value?.NotGCode is { } none ? ValueOrFail(new Result<DecodedGCode>(null, [none])) : ValueOrFail(result);

    /// <summary>The result of long work, with a progress bar on a terminal. Its diagnostics are printed.</summary>
    /// <exception cref="CliException">The work failed.</exception>
    public T Run<T>(string label, Func<IProgress<double>?, Result<T>> work)
        where T : class
        => ValueOrFail(WithProgress(label, work));

    /// <summary>Decodes a file while it is read.</summary>
    /// <exception cref="CliException">It is not G-code.</exception>
    public DecodedGCode Decode(string file, DecodeOptions options) => GCodeOrFail(Read(file, options));

    /// <summary>The same, but nothing is printed.</summary>
    public Result<DecodedGCode> Read(string file, DecodeOptions options)
    {
        using var stream = OpenRead(file);
        return Decode(stream, NameOf(file), options);
    }

    /// <summary>Decodes a stream while it is read.</summary>
    public Result<DecodedGCode> Decode(Stream stream, string name, DecodeOptions options)
        => WithProgress("Reading " + name, progress => GCodeDecoder.DecodeStream(stream, options, name, progress, Cancel));

    /// <summary>The written file.</summary>
    /// <exception cref="CliException">Nothing was written.</exception>
    public WrittenGCode WrittenOrFail(Result<WrittenGCode> result)
        => result.Value ?? throw new CliException(result.Diagnostics.Any(d => d.Code == SafeWriter.Refused) ? ExitCode.Refused : ExitCode.BadInput);

    /// <summary>Prints the diagnostics and returns the value.</summary>
    /// <exception cref="CliException">The result has no value.</exception>
    public T ValueOrFail<T>(Result<T> result, int code = ExitCode.BadInput)
        where T : class
    {
        Print(result.Diagnostics);
        return result.Value ?? throw new CliException(code);
    }

    /// <summary>Runs long work, with a progress bar on a terminal.</summary>
    public T WithProgress<T>(string label, Func<IProgress<double>?, T> work)
    {
        if (!IsTerminal) return work(null);
        var console = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(_messages) });
        return console.Progress().AutoClear(true).HideCompleted(true)
            .Columns(new TaskDescriptionColumn(), new ProgressBarColumn(), new PercentageColumn(), new RemainingTimeColumn())
            .Start(context => work(new Bar(context.AddTask(Markup.Escape(LongWords.OneLine(label))))));
    }

    /// <summary>The end of work that does not stop by itself.</summary>
    public void Abandon()
    {
        Unfinished.Delete();
        // A progress bar hides the cursor.
        if (IsTerminal) _messages.Write("\u001B[?25h\n");
        Messages.WriteLine(Interrupted);
    }

    private static void NoFolder(string file)
    {
        if (string.IsNullOrWhiteSpace(file)) throw CliException.Usage("A file name is empty.");
        if (Directory.Exists(file)) throw new CliException(ExitCode.BadInput, $"{file} is a folder, not a file.");
    }

    private sealed class Bar(ProgressTask task) : IProgress<double>
    {
        public void Report(double value) => task.Value = Math.Clamp(value, 0, 1) * task.MaxValue;
    }
}

/// <summary>A written G-code file: its print, lines and bytes.</summary>
internal sealed record WrittenFigures(PrintFigures Print, long Lines, long Bytes);
