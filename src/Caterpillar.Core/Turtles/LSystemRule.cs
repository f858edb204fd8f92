using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Expressions;

namespace Caterpillar.Turtles;

/// <summary>A letter of a successor with the formulas of its values.</summary>
internal readonly struct Module(char symbol, Formula[] values)
{
    public char Symbol { get; } = symbol;

    public Formula[] Values { get; } = values;
}

/// <summary>One rule: <c>[weight] letter[(names)] [: condition] -&gt; successor</c>.</summary>
internal sealed class LSystemRule
{
    public char Symbol { get; private set; }

    public string[] Names { get; private set; } = [];

    public double? Weight { get; private set; }

    public Formula? Condition { get; private set; }

    public Module[] Successor { get; private set; } = [];

    /// <summary>Reads a rule; key and line name it in diagnostics.</summary>
    /// <exception cref="FormulaException">The text is not a rule.</exception>
    public static LSystemRule Parse(string text, int line)
    {
        var arrow = text.IndexOf("->", System.StringComparison.Ordinal);
        var width = 2;
        if (arrow < 0)
        {
            arrow = text.IndexOf("\u2192", System.StringComparison.Ordinal);
            if (arrow < 0) arrow = text.IndexOf("=", System.StringComparison.Ordinal);
            width = 1;
        }
        if (arrow < 0) throw new FormulaException("lsystem.rule", "A rule must have the form 'F -> successor'.", line, 1);
        var rule = new LSystemRule();
        var i = Skip(text, 0);
        i = rule.ReadWeight(text, i, arrow, line);
        if (i >= arrow) throw new FormulaException("lsystem.rule", "The rule has no letter to replace.", line, 1);
        rule.Symbol = text[i++];
        if (i < arrow && text[i] == '(')
        {
            var close = Closing(text, i, arrow, line);
            rule.Names = text.Substring(i + 1, close - i - 1).Split(',').Select(n => n.Trim()).ToArray();
            if (rule.Names.Any(n => n.Length == 0)) throw new FormulaException("lsystem.rule", "A value of the letter has no name.", line, i + 1);
            i = close + 1;
        }
        i = Skip(text, i);
        if (i < arrow && text[i] == ':')
        {
            rule.Condition = Compile(text, i + 1, arrow, rule.Names, line);
            i = arrow;
        }
        if (i < arrow) throw new FormulaException("lsystem.rule", $"Found '{text[i]}', expected '->' or ':'.", line, i + 1);
        rule.Successor = Word(text, arrow + width, rule.Names, line);
        return rule;
    }

    /// <summary>Reads a word: letters, some with values in parentheses; spaces are ignored.</summary>
    public static Module[] Word(string text, int from, string[] names, int line)
    {
        var modules = new List<Module>();
        for (var i = from; i < text.Length; i++)
        {
            if (char.IsWhiteSpace(text[i])) continue;
            if (text[i] is '(' or ')') throw new FormulaException("lsystem.bracket", $"The '{text[i]}' has no letter or partner.", line, i + 1);
            var symbol = text[i];
            var values = new List<Formula>();
            if (i + 1 < text.Length && text[i + 1] == '(')
            {
                var close = Closing(text, i + 1, text.Length, line);
                var depth = 0;
                var start = i + 2;
                for (var p = start; p <= close; p++)
                {
                    if (text[p] == '(') depth++;
                    else if (text[p] == ')' && p < close) depth--;
                    if (p < close && !(text[p] == ',' && depth == 0)) continue;
                    values.Add(Compile(text, start, p, names, line));
                    start = p + 1;
                }
                i = close;
            }
            modules.Add(new Module(symbol, values.ToArray()));
        }
        return modules.ToArray();
    }

    private static Formula Compile(string text, int from, int to, string[] names, int line)
    {
        // Leading spaces keep the columns.
        var result = Formula.Compile(new string(' ', from) + text.Substring(from, to - from), names);
        if (result.Value is { } formula) return formula;
        var problem = result.Diagnostics[0];
        throw new FormulaException(problem.Code, problem.Message, line, problem.Source?.Column ?? 1);
    }

    private int ReadWeight(string text, int i, int arrow, int line)
    {
        var end = i;
        while (end < arrow && (char.IsDigit(text[end]) || text[end] == '.')) end++;
        var next = Skip(text, end);
        // A digit directly before the arrow, a parenthesis or a condition is the letter itself.
        if (end == i || next == end || next >= arrow || text[next] == ':') return i;
        if (!NumberReader.TryParse(text.Substring(i, end - i), out var weight) || !(weight >= 0))
            throw new FormulaException("lsystem.rule", "The weight before the letter must be a number of 0 or more.", line, i + 1);
        Weight = weight;
        return next;
    }

    private static int Closing(string text, int open, int end, int line)
    {
        var depth = 0;
        for (var i = open; i < end; i++)
        {
            if (text[i] == '(') depth++;
            else if (text[i] == ')' && --depth == 0) return i;
        }
        throw new FormulaException("lsystem.bracket", "'(' is never closed by ')'.", line, open + 1);
    }

    private static int Skip(string text, int i)
    {
        while (i < text.Length && char.IsWhiteSpace(text[i])) i++;
        return i;
    }
}
