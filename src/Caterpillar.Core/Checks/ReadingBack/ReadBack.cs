namespace Caterpillar.Checks;

/// <summary>
/// Writes a toolpath and at the same time reads what is written, as the firmware of the printer does: start and end code, templates and raw lines too. What
/// was read is compared with the plan and checked. The toolpath may still be growing: <see cref="Write"/> as often as there is more, then <see cref="End"/> and
/// <see cref="Finish"/>.
/// </summary>
internal sealed class ReadBack : IDisposable
{
    private readonly PrintSetup _setup;
    private readonly GCodeFormat _format;
    private readonly CancellationToken _cancel;
    private readonly BytePipe _pipe = new();
    private readonly PipedStream _text;
    private readonly GCodeWriter _writer;
    private readonly Findings _compared;
    private readonly PlanComparison? _comparison;
    private readonly MoveChecks _checks;
    private readonly Task<DecodedGCode> _reading;
    private readonly bool _isWhole;
    private readonly bool _isChecked;
    private Toolpath _plan;
    private WrittenPlaces? _places;
    private int _written;
    private int _read;

    /// <param name="plan">The plan so far.</param>
    /// <param name="setup">The printer, material and settings.</param>
    /// <param name="format">The format of the file.</param>
    /// <param name="stream">The file; null = only check.</param>
    /// <param name="isWhole">True if the plan is complete. Otherwise it waits while much of it is not checked yet.</param>
    /// <param name="cancel">Cancels.</param>
    /// <param name="isChecked">True if the plan was checked before: what it prints is not looked at again.</param>
    public ReadBack(
        Toolpath plan, PrintSetup setup, GCodeFormat format, Stream? stream, bool isWhole, CancellationToken cancel, bool isChecked = false)
    {
        (_plan, _setup, _format, _cancel, _isWhole, _isChecked) = (plan, setup, format, cancel, isWhole, isChecked);
        _text = new PipedStream(stream, _pipe);
        _writer = new GCodeWriter(plan, format) { Written = Lines };
        _compared = NewFindings();
        if (_compared.LooksFor(PlanComparison.Codes)) _comparison = new PlanComparison(plan, format, Lines, _compared);
        _checks = new MoveChecks(setup, plan.Tools, NewFindings, cancel, isWhole ? int.MaxValue : MoveChecks.FewBlocks, !isChecked);
        _reading = OwnThread.Run(Decode);
    }

    /// <summary>The lines of the plan.</summary>
    public WrittenLines Lines { get; } = new();

    /// <summary>Number of lines and bytes that are written.</summary>
    public (long Lines, long Bytes) Size => (_writer.Lines, _writer.Bytes);

    /// <summary>All moves of the file, and the seconds that they take; null before <see cref="Finish"/>.</summary>
    public (Toolpath File, double Seconds)? Read { get; private set; }

    /// <summary>True if any check is on. Otherwise nothing is read back.</summary>
    public static bool IsAsked(PrintSetup setup)
        => setup.OwnChecks.Count > 0 || new Findings(setup.Printer, _ => null, _ => null).LooksFor(CheckCodes.All.Select(r => r.Code));

    /// <summary>The start code first, then the blocks of the plan that are not written yet.</summary>
    public void Write(Toolpath plan, IProgress<double>? progress = null)
    {
        GoOn(plan, _format);
        if (_written == 0) _writer.WriteStart(_text);
        for (; _written < plan.Blocks.Count; _written++)
        {
            _cancel.ThrowIfCancellationRequested();
            _writer.WriteBlock(_text, _written);
            progress?.Report((_written + 1.0) / plan.Blocks.Count);
        }
    }

    /// <summary>The end code, which may be known only now.</summary>
    public void End(GCodeFormat format)
    {
        GoOn(_plan, format);
        _writer.WriteEnd(_text);
        _pipe.Complete();
    }

    /// <summary>The findings of the whole file, when it is complete.</summary>
    public IReadOnlyList<Diagnostic> Finish(IProgress<double>? progress)
    {
        var file = OwnThread.Join(_reading);
        var modes = NewFindings();
        RawModes.Run(_plan, _format, modes, index => _places?.OfEvent(index));
        _comparison?.End(file.Toolpath, _read);
        var read = _setup.Printer.ToPart(AxisMapping.Unroll(file.Toolpath, _setup.Printer.AxisMappings, _cancel), _cancel);
        if (read.Tools.Count <= _plan.Tools.Count) read = read.With(tools: _plan.Tools);
        _places = new WrittenPlaces(_plan, move => move < 0 || move >= read.Count ? null : read[move].Source, Lines, _setup.Printer);
        var scope = CheckScope.OfWritten(file, _setup) with { FirstLine = Lines.Before(0, -1) + 1, IsOwnLine = IsOwnLine };
        var timing = OwnThread.Run(() => Time(read));
        // Start and end code that print are looked at together with the plan.
        using var all = !file.HasExpectedLayers || (_isChecked && ToolpathTotals.Of(read).PrintMoves != ToolpathTotals.Of(_plan).PrintMoves)
            ? new MoveChecks(_setup, read.Tools, NewFindings, _cancel) : null;
        var checks = (all ?? _checks).Finish(read, scope, progress);
        Read = (read, OwnThread.Join(timing));
        var compared = new DiagnosticList();
        compared.AddRange(modes.ToList());
        compared.AddRange(_compared.ToList());
        var problems = DecodingNotes.Of(file, null).Select(d => d.WithSource(s => s?.Line is { } line ? _places.OfLine(line) : s));
        return [.. compared.ToList(), .. checks, .. problems];
    }

    private double Time(Toolpath file)
    {
        var planner = new MotionPlanner(file, _setup, timesOnly: true, (_, _) => { });
        planner.Take(file, null, _cancel);
        // The figures of the file are asked for next.
        _ = ToolpathTotals.Of(file);
        return planner.End().Motion.TotalTime;
    }

    /// <summary>Nothing more is read, and nobody waits for that.</summary>
    public void Stop()
    {
        _pipe.Stop();
        _checks.Stop();
    }

    /// <summary>Stops unfinished work and waits for its end.</summary>
    public void Dispose()
    {
        Stop();
        _pipe.Complete();
        OwnThread.Wait(_reading);
        _checks.Dispose();
        _text.Dispose();
        _pipe.Dispose();
    }

    private void GoOn(Toolpath plan, GCodeFormat format)
    {
        _plan = plan;
        _writer.GoOn(plan, format);
        _comparison?.GoOn(plan);
    }

    // Events of the plan, except lines that the user wrote.
    private bool IsOwnLine(int line) => Lines.EventAt(line) is >= 0 and var what && _plan.Events[what].Event is not RawEvent;

    private DecodedGCode Decode()
    {
        var options = new DecodeOptions
        {
            Flavor = _setup.Printer.Flavor, FilamentDiameter = _setup.Material.FilamentDiameter, Take = Take,
            Heights = _isWhole ? FlatHeights.Of(_plan, _setup.Printer.DecimalsXyz) : null,
            // Another one writes.
            Threads = Math.Max(Environment.ProcessorCount - 1, 1),
        };
        try
        {
            return GCodeDecoder.DecodeStream(_pipe.Reader, options, "", null, _cancel).OrThrow();
        }
        finally
        {
            // What comes after a problem is not read, and nobody may wait for that.
            _pipe.Stop();
        }
    }

    private void Take(DecodedBlock block)
    {
        _comparison?.Take(block.Columns, block.Start);
        // Mapped and rotary axes are unrolled when the whole file is known.
        if (_setup.Printer.AxisMappings.Count == 0 && _setup.Printer.RotaryAxes.Count == 0) _checks.Take(block);
        _read++;
    }

    private Findings NewFindings() => new(_setup.Printer, move => _places?.Of(move), what => _places?.Of(what));
}
