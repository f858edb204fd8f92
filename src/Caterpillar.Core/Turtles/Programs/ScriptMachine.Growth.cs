using System;
using Caterpillar.Basics;

namespace Caterpillar.Turtles;

// L-systems: a word grows, then its letters are drawn one by one.
internal sealed partial class ScriptMachine
{
    // A letter with a value, in two generations.
    private const int LetterBytes = 64;

    private LSystemInterpretation? _standard;
    private double _standardStep;
    private double _standardAngle;

    private LSystemWord Grow(Instruction at)
    {
        var generations = (int)Integer(at.Arguments[0]!, 0, 1000);
        var seed = (int)_context.Random.NextInteger(0, int.MaxValue);
        var variables = new double[at.Variables.Count];
        for (var i = 0; i < variables.Length; i++)
        {
            var (name, slot, local) = at.Variables[i];
            variables[i] = _context.Values[local ? _context.Base + slot : slot];
            if (double.IsNaN(variables[i]) && at.System!.Variables.Uses(name))
                throw Error(at, "turtle.no_value", $"The variable '{name}' has no value yet.");
        }
        var result = at.System!.Grow(variables, generations, seed, MaxLetters(), null, _cancel);
        if (result.Value is null) throw Error(at, result.Diagnostics[0].Code, result.Diagnostics[0].Message);
        foreach (var remark in result.Diagnostics) Remarks.Add(remark with { Source = new SourceLocation(at.File, at.Line, at.Column) });
        return result.Value;
    }

    // One letter of the word on top; a procedure of its name returns here.
    private int NextLetter(Instruction at, int pc)
    {
        var letters = _words[_words.Count - 1];
        if (letters.At >= letters.Word.Count)
        {
            _words.RemoveAt(_words.Count - 1);
            return pc;
        }
        var index = letters.At++;
        var word = letters.Word;
        if (_code.Letters.TryGetValue(word[index], out var procedure))
        {
            if (word.ValueCount(index) != procedure.Parameters.Count)
                throw Error(at, "lsystem.value",
                    $"The letter '{word[index]}' has {Text(word.ValueCount(index))} values, its procedure {Text(procedure.Parameters.Count)}.");
            var given = new double[procedure.Parameters.Count];
            for (var v = 0; v < given.Length; v++) given[v] = word.Value(index, v);
            Enter(procedure, at.Line, at.Column, pc - 1, given);
            return procedure.Start;
        }
        if (Turtle.MoveCount >= _limits.MaxMoves) throw TooManyMoves(at);
        try
        {
            Standard().Apply(Turtle, word, index);
        }
        catch (Exception e) when (e is ArgumentException or InvalidOperationException)
        {
            throw Error(at, e is InvalidOperationException ? "lsystem.bracket"
                : "lsystem.value", $"Letter {Text(index + 1)} ('{word[index]}') of the word: {Messages.Clean(e)}");
        }
        return pc - 1;
    }

    private LSystemInterpretation Standard()
    {
        var step = _code.StepSlot < 0 || double.IsNaN(_context.Values[_code.StepSlot]) ? 1 : _context.Values[_code.StepSlot];
        var angle = _code.AngleSlot < 0 || double.IsNaN(_context.Values[_code.AngleSlot]) ? 90 : _context.Values[_code.AngleSlot];
        if (_standard is null || step != _standardStep || angle != _standardAngle) _standard = LSystemInterpretation.Standard(step, angle);
        (_standardStep, _standardAngle) = (step, angle);
        return _standard;
    }

    private int MaxLetters() => (int)Math.Max(1, Math.Min(_limits.MaxSymbols, (_limits.Memory.Bytes - Bytes) / LetterBytes));

    private sealed class Letters(LSystemWord word)
    {
        public LSystemWord Word { get; } = word;

        public int At { get; set; }
    }
}
