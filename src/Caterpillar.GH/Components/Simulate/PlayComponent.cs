using System.Diagnostics;

namespace Caterpillar.GH.Components.Simulate;

/// <summary>Runs through a print as time passes.</summary>
public sealed class PlayComponent() : CaterpillarComponent("Play", "Play", "Moves a position through a print as time passes, for Simulate.", Panel.Simulate,
    GH_Exposure.secondary)
{
    private const int FrameMilliseconds = 40;
    private readonly Stopwatch _clock = Stopwatch.StartNew();
    private double _position;
    private double _last;
    private bool? _pressed;

    public override Guid ComponentGuid => new("d7f20c3c-2a54-4a39-9c8e-5f0a6f5a7a02");

    /// <summary>Seconds of the clock. A test has its own.</summary>
    internal Func<double>? Seconds { get; set; }

    /// <summary>True while the position moves.</summary>
    internal bool Plays { get; private set; }

    private double Now => Seconds?.Invoke() ?? _clock.Elapsed.TotalSeconds;

    public override void RemovedFromDocument(GH_Document document)
    {
        Plays = false;
        base.RemovedFromDocument(document);
    }

    public override void DocumentContextChanged(GH_Document document, GH_DocumentContext context)
    {
        if (context is GH_DocumentContext.Close or GH_DocumentContext.Unloaded or GH_DocumentContext.Lock) Plays = false;
        base.DocumentContextChanged(document, context);
    }

    private protected override void Inputs(InputPorts ports)
    {
        ports.Toolpath();
        ports.Boolean("Run", "R", "Starts when this changes from false to true. Stops when false.", false);
        ports.Number("Speed", "V", "Speed factor. 1 = as long as the print.", 60);
        ports.Boolean("Reset", "Re", "Go back to the start.", false);
    }

    private protected override void Outputs(OutputPorts ports) => ports.Number("Position", "t", "Position in the print by time, from 0 to 1.");

    private protected override void Prepare(Run run)
    {
        // A definition that was saved while it ran stands still until Run has been false.
        var pressed = run.MaybeValue<bool>(1) ?? true;
        if (pressed && _pressed == false)
        {
            Plays = true;
            _last = Now;
            if (_position >= 1) _position = 0;
        }
        if (!pressed) Plays = false;
        _pressed = pressed;
    }

    private protected override void Solve(Run run)
    {
        if (run.Iteration > 0) throw new InputProblem("Play takes only one toolpath. Use one Play for each.");
        var goo = run.Get<ToolpathGoo>(0);
        var speed = run.Positive(2);
        if (run.Get<bool>(3)) _position = 0;
        var setup = SetupPort.Of(run, -1, goo);
        var timeline = run.Work("Timing", [goo.Value, setup], (progress, cancel) => Timeline.Of(goo.Value, setup, progress, cancel));
        var now = Now;
        // Frames are as long as solving takes: slow definitions skip some.
        if (Plays && timeline.Duration > 0) _position = Math.Min(1, _position + (now - _last) * speed / timeline.Duration);
        _last = now;
        if (_position >= 1) Plays = false;
        if (Plays) run.Document?.ScheduleSolution(FrameMilliseconds, Next);
        run.Set(0, _position);
        run.Summarize($"{NumberFormatter.Format(_position * timeline.Duration, 0)} of {NumberFormatter.Format(timeline.Duration, 0)} s");
    }

    private void Next(GH_Document document)
    {
        if (Plays && !Locked) ExpireSolution(false);
        else Plays = false;
    }
}
