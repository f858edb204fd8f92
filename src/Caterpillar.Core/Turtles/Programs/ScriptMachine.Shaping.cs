using System;
using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Expressions;
using Caterpillar.Geometry;

namespace Caterpillar.Turtles;

// Blocks that shape what is drawn in them, and printed lines.
internal sealed partial class ScriptMachine
{
    /// <summary>The most lines that a program may print; more are counted.</summary>
    public const int MaxPrints = 10_000;

    private readonly Stack<Open> _open = new();
    private readonly List<Diagnostic> _prints = [];
    private long _unprinted;

    /// <summary>What the program printed, line by line.</summary>
    public IEnumerable<Diagnostic> Prints()
    {
        foreach (var line in _prints) yield return line;
        if (_unprinted > 0)
        {
            yield return new Diagnostic(Severity.Remark, "turtle.print_limit",
                $"{Text(_unprinted)} more lines are not shown: a program prints up to {Text(MaxPrints)}.");
        }
    }

    private void Print(Instruction at)
    {
        var text = TextOf(at.Text!);
        if (_prints.Count < MaxPrints) _prints.Add(new Diagnostic(Severity.Remark, TurtleScript.PrintCode, text,
            new SourceLocation(at.File, at.Line, at.Column)));
        else _unprinted++;
    }

    private void BeginShaping(Instruction at) => _open.Push(new Open(at.Shaping!, Turtle.Pose, Turtle.BeginSteps(), _context.Base));

    private void EndShaping()
    {
        var block = _open.Pop();
        var (current, at) = (_context.Base, block.Rules.At);
        // A program that stops within a procedure ends the blocks around its calls as well.
        _context.Base = block.Base;
        var steps = Turtle.StepsFrom(block.First);
        if (_limits.Memory.Refuse(Bytes + 2 * Turtle.Bytes, "The deformed paths") is { } refusal)
            throw new FormulaException(refusal.Code, refusal.Message, at.Line, at.Column);
        var shaped = new Shaper(block.Rules, _context, block.Frame, Turtle).Apply(steps, _cancel);
        if (shaped.Value is null)
        {
            var problem = shaped.Diagnostics[0];
            throw new FormulaException(problem.Code, problem.Message, at.Line, at.Column);
        }
        foreach (var remark in shaped.Diagnostics) Remarks.Add(remark with { Source = new SourceLocation(_current.File, at.Line, at.Column) });
        Turtle.ReplaceSteps(block.First, shaped.Value);
        _context.Base = current;
        _pulse = Math.Min(_pulse, _steps);
    }

    private readonly record struct Open(ShapingRules Rules, Frame Frame, int First, int Base);
}
