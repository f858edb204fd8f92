using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Runtime.ExceptionServices;
using System.Threading;
using Caterpillar.Expressions;

namespace Caterpillar.Turtles;

// Procedures, and functions that formulas call.
internal sealed partial class ScriptMachine
{
    /// <summary>Greatest nesting depth of functions that formulas call.</summary>
    public const int MaxFunctionDepth = 1000;

    // Where a function that a formula has called returns to.
    private const int ToFormula = -1;

    // For functions that call each other a thousand levels deep.
    private const int StackBytes = 64 << 20;

    private readonly List<CallFrame> _frames = [];
    private int _frameSize;
    private int _functions;
    private double _result;

    /// <summary>The value of a function in a formula.</summary>
    /// <exception cref="FormulaException">It failed, or returned no value.</exception>
    public double Call(Procedure procedure, Evaluator[] arguments, Token at)
    {
        if (_functions >= MaxFunctionDepth) throw TooDeep(at);
        try
        {
            RuntimeHelpers.EnsureSufficientExecutionStack();
        }
        catch (InsufficientExecutionStackException)
        {
            throw TooDeep(at);
        }
        // Formulas still see the caller's variables; the new frame comes after them.
        var given = new double[arguments.Length];
        for (var i = 0; i < given.Length; i++)
        {
            given[i] = arguments[i](_context);
            if (double.IsNaN(given[i] - given[i]))
            {
                throw new FormulaException("turtle.not_finite", $"A value for '{at.Text}' is not finite.", at.Line, at.Column);
            }
        }
        var current = _current;
        Enter(procedure, at.Line, at.Column, ToFormula, given);
        _functions++;
        Loop(procedure.Start);
        _functions--;
        _current = current;
        if (_stopped) throw new StopException();
        var result = _result;
        return double.IsNaN(result) ? throw new FormulaException("turtle.no_result", $"'{at.Text}' ended without 'return' and a value.", at.Line, at.Column)
            : result;
    }

    private void Call(Instruction at, int back)
    {
        var given = new double[at.Arguments.Length];
        for (var i = 0; i < given.Length; i++) given[i] = Number(at.Arguments[i]!);
        Enter(at.Procedure!, at.Line, at.Column, back, given);
    }

    private void Enter(Procedure procedure, int line, int column, int back, double[] given)
    {
        if (_frames.Count >= _limits.MaxDepth)
        {
            throw new FormulaException("turtle.recursion", $"Procedures call each other {Text(_limits.MaxDepth)} levels deep. Does a recursion never end?",
                line, column);
        }
        var start = _context.Base + _frameSize;
        _frames.Add(new CallFrame(back, _context.Base, _frameSize, _words.Count));
        var values = _context.Values;
        if (start + procedure.FrameSize > values.Length)
        {
            Array.Resize(ref values, 2 * (start + procedure.FrameSize));
            _context.Values = values;
        }
        given.CopyTo(values, start);
        for (var i = start + given.Length; i < start + procedure.FrameSize; i++) values[i] = double.NaN;
        _context.Base = start;
        _frameSize = procedure.FrameSize;
    }

    private int Return(Instruction at)
    {
        var value = at.Arguments.Length > 0 ? Number(at.Arguments[0]!) : double.NaN;
        var frame = _frames[_frames.Count - 1];
        _frames.RemoveAt(_frames.Count - 1);
        _context.Base = frame.Base;
        _frameSize = frame.Size;
        _words.RemoveRange(frame.Words, _words.Count - frame.Words);
        _result = value;
        return frame.Back;
    }

    // Functions in formulas nest on the thread's stack, whose size differs from host to host: they get a thread of their own.
    private static void OnLargeStack(Action work)
    {
        ExceptionDispatchInfo? failure = null;
        var thread = new Thread(
            () =>
            {
                try
                {
                    work();
                }
                catch (Exception e)
                {
                    failure = ExceptionDispatchInfo.Capture(e);
                }
            },
            StackBytes) { IsBackground = true };
        thread.Start();
        thread.Join();
        failure?.Throw();
    }

    private static FormulaException TooDeep(Token at) => new("turtle.recursion",
        $"Functions call each other {Text(MaxFunctionDepth)} levels deep. Does a recursion never end?", at.Line, at.Column);

    private readonly record struct CallFrame(int Back, int Base, int Size, int Words);

    // Ends the program from within a function.
    private sealed class StopException : Exception
    {
    }
}
