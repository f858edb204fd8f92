using System;
using System.Collections.Generic;
using System.Threading;
using Caterpillar.Geometry;
using Caterpillar.GH.Base;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Tests.Base;

/// <summary>A component whose work takes as long as a test wants.</summary>
internal sealed class SlowComponent() : CaterpillarComponent("Slow", "Slow", "Takes its time.", "Test")
{
    // Milliseconds.
    private const int Long = 20_000;
    private readonly Queue<Action> _posted = new();

    public override Guid ComponentGuid => new("5f0c3d0e-7c0e-4a3e-9a51-6f7f2c7c0f11");

    /// <summary>Open while work may end.</summary>
    public ManualResetEventSlim Gate { get; } = new(true);

    /// <summary>How often work has begun, and how often it was canceled.</summary>
    public int Begun;

    public int Canceled;

    // Pieces of work that wait at the gate.
    private int _held;

    /// <summary>How often it was solved for an item.</summary>
    public int Solved;

    /// <summary>Its work may outlive a solution, as on the canvas. While the gate is open, solutions wait for it however busy the machine is.</summary>
    public SlowComponent OnCanvas()
    {
        Background.MayLeave = _ => true;
        Background.UsualPatience = Long;
        Background.Post = action =>
        {
            lock (_posted) _posted.Enqueue(action);
        };
        return this;
    }

    /// <summary>Holds work back, for which solutions then wait only shortly.</summary>
    public void Close()
    {
        Gate.Reset();
        Background.UsualPatience = 50;
    }

    public void Open()
    {
        Gate.Set();
        Background.UsualPatience = Long;
    }

    /// <summary>
    /// After a solution that work outlives: waits until it stands at the closed gate, and shows its progress. On a busy machine it may begin late, and what is
    /// canceled before it begins never does.
    /// </summary>
    public void Settle()
    {
        var end = DateTime.UtcNow.AddSeconds(10);
        while (!Gate.IsSet && Background.IsWorking && Volatile.Read(ref _held) == 0 && DateTime.UtcNow < end) Thread.Sleep(1);
        if (Volatile.Read(ref _held) > 0) Background.Pulse();
    }

    /// <summary>Lets time pass as in Rhino, until something is true or so many seconds are over.</summary>
    public bool Until(Func<bool> done, double seconds = 10)
    {
        var end = DateTime.UtcNow.AddSeconds(seconds);
        while (!done() && DateTime.UtcNow < end)
        {
            Action? next = null;
            lock (_posted)
            {
                if (_posted.Count > 0) next = _posted.Dequeue();
            }
            next?.Invoke();
            if (next is null && OnPingDocument()?.RunSchedule() != true) Thread.Sleep(5);
        }
        return done();
    }

    private protected override void Inputs(InputPorts ports) => ports.Text("Value", "V", "A text.");

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Text("Result", "R", "The text.");
        ports.Add(new PrintPathParam(), "Paths", "P", "Two lines.", GH_ParamAccess.list);
    }

    private protected override void Solve(Run run)
    {
        Solved++;
        var value = run.Get<string>(0);
        run.Set(0, run.Work("Testing", [value], (progress, cancel) =>
        {
            Interlocked.Increment(ref Begun);
            progress.Report(0.42);
            Interlocked.Increment(ref _held);
            try
            {
                // Work for "quick" passes a closed gate.
                if (value != "quick") Gate.Wait(cancel);
            }
            catch (OperationCanceledException)
            {
                Interlocked.Increment(ref Canceled);
                throw;
            }
            finally
            {
                Interlocked.Decrement(ref _held);
            }
            return value == "bad" ? throw new InvalidOperationException("This is bad.") : value;
        }));
        var line = new PrintPath([new Vec3(50, 50, 0.2), new Vec3(60, 50, 0.2)], new Bead(0.08, 0.2, 40));
        run.SetList(1, new[] { new PrintPathGoo(line), new PrintPathGoo(line) });
        run.Summarize("done");
    }
}
