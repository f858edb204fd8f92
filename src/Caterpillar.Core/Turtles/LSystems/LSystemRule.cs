namespace Caterpillar.Turtles;

/// <summary>A letter of a successor with the formulas of its values.</summary>
internal readonly record struct Module(char Symbol, Formula[] Values);

/// <summary>A letter of a predecessor with the names of its values.</summary>
internal readonly record struct Pattern(char Symbol, string[] Names);

/// <summary>One rule: <c>[weight] [left &lt;] letter[(names)] [&gt; right] [: condition] -&gt; successor</c>.</summary>
internal sealed class LSystemRule
{
    public char Symbol { get; private set; }

    /// <summary>Names of the values of the letter.</summary>
    public string[] Names { get; private set; } = [];

    /// <summary>Letters that must precede it, in the order of the word. Empty = any.</summary>
    public Pattern[] Left { get; private set; } = [];

    /// <summary>Letters that must follow it.</summary>
    public Pattern[] Right { get; private set; } = [];

    /// <summary>Number of values before the variables of its formulas: from the left context, the letter and the right context.</summary>
    public int ValueCount { get; private set; }

    public double? Weight { get; private set; }

    public Formula? Condition { get; private set; }

    public Module[] Successor { get; private set; } = [];

    /// <summary>Reads a rule. Diagnostics state its line.</summary>
    /// <exception cref="FormulaException">The text is not a rule.</exception>
    public static LSystemRule Parse(string text, int line, LSystemNames variables)
    {
        var (arrow, width) = new[] { "->", "\u2192", "=" }.Select(sign => (text.IndexOf(sign, StringComparison.Ordinal), sign.Length))
            .FirstOrDefault(found => found.Item1 >= 0);
        if (width == 0) throw new FormulaException("lsystem.rule", "A rule must have the form 'F -> successor'.", line, 1);
        var rule = new LSystemRule();
        var i = rule.ReadWeight(text, arrow, line);
        i = rule.ReadPredecessor(text, i, arrow, line);
        var names = rule.Left.SelectMany(p => p.Names).Concat(rule.Names).Concat(rule.Right.SelectMany(p => p.Names)).ToArray();
        rule.ValueCount = names.Length;
        if (i < arrow && text[i] == ':')
        {
            rule.Condition = Compile(text, i + 1, arrow, names, line, variables);
            i = arrow;
        }
        if (i < arrow) throw new FormulaException("lsystem.rule", $"Found '{text[i]}', expected '->' or ':'.", line, i + 1);
        rule.Successor = Word(text, arrow + width, names, line, variables);
        return rule;
    }

    // left < letter > right
    private int ReadPredecessor(string text, int i, int arrow, int line)
    {
        var (letters, at) = (new List<Pattern>(), i);
        i = Letters(text, i, arrow, line, letters);
        if (letters.Count > 0 && i < arrow && text[i] == '<')
        {
            Left = letters.ToArray();
            letters.Clear();
            at = Skip(text, i + 1);
            i = Letters(text, at, arrow, line, letters);
        }
        if (letters.Count == 0) throw new FormulaException("lsystem.rule", "The rule has no letter to replace.", line, 1);
        (Symbol, Names) = (letters[0].Symbol, letters[0].Names);
        if (letters.Count > 1)
        {
            var second = Skip(text, Names.Length > 0 ? Closing(text, at + 1, arrow, line) + 1 : at + 1);
            throw new FormulaException("lsystem.rule", $"Found '{text[second]}', expected '->' or ':'.", line, second + 1);
        }
        if (i >= arrow || text[i] != '>') return i;
        letters.Clear();
        i = Letters(text, i + 1, arrow, line, letters);
        if (letters.Count == 0) throw new FormulaException("lsystem.rule", "Expected a letter after '>'.", line, i);
        Right = letters.ToArray();
        return i;
    }

    // Letters with the names of their values, up to a '<', '>' or ':' that is not the first of them.
    private static int Letters(string text, int i, int end, int line, List<Pattern> letters)
    {
        for (i = Skip(text, i); i < end; i = Skip(text, i))
        {
            var symbol = text[i];
            if (letters.Count > 0 && symbol is '<' or '>' or ':') return i;
            if (letters.Count > 0 && symbol is '[' or ']')
                throw new FormulaException("lsystem.rule", "A context must not contain brackets. It follows the branch.", line, i + 1);
            var names = System.Array.Empty<string>();
            if (++i < end && text[i] == '(')
            {
                var close = Closing(text, i, end, line);
                names = text.Substring(i + 1, close - i - 1).Split(',').Select(n => n.Trim()).ToArray();
                if (names.Any(n => n.Length == 0)) throw new FormulaException("lsystem.rule", "A value of the letter has no name.", line, i + 1);
                i = close + 1;
            }
            letters.Add(new Pattern(symbol, names));
        }
        return i;
    }

    /// <summary>Reads a word: letters, some with values in parentheses. Spaces are ignored.</summary>
    public static Module[] Word(string text, int from, string[] names, int line, LSystemNames variables)
    {
        var modules = new List<Module>();
        for (var i = from; i < text.Length; i++)
        {
            if (char.IsWhiteSpace(text[i])) continue;
            if (text[i] is '(' or ')') throw new FormulaException("lsystem.bracket", $"'{text[i]}' has no letter or no matching bracket.", line, i + 1);
            var symbol = text[i];
            var values = new List<Formula>();
            if (i + 1 < text.Length && text[i + 1] == '(')
            {
                var close = Closing(text, i + 1, text.Length, line);
                var list = DeformationText.Split(text.Substring(0, close), i + 2);
                values.AddRange(list.Select(value => Compile(value, 0, value.Length, names, line, variables)));
                i = close;
            }
            modules.Add(new Module(symbol, values.ToArray()));
        }
        return modules.ToArray();
    }

    private static Formula Compile(string text, int from, int to, string[] names, int line, LSystemNames variables)
    {
        // Leading spaces keep the columns.
        var result = Formula.Compile(new string(' ', from) + text.Substring(from, to - from), variables.After(names));
        if (result.Value is { } formula)
        {
            variables.Note(text.Substring(from, to - from), names);
            return formula;
        }
        var problem = result.Diagnostics[0];
        throw new FormulaException(problem.Code, problem.Message, line, problem.Source?.Column ?? 1);
    }

    private int ReadWeight(string text, int arrow, int line)
    {
        // A digit directly before the arrow, a parenthesis or a condition is the letter itself.
        var given = Regex.Match(text.Substring(0, arrow), @"^\s*([\d.]+)\s+(?=[^\s:])");
        if (!given.Success) return Skip(text, 0);
        if (!NumberReader.TryParse(given.Groups[1].Value, out var weight) || !(weight >= 0))
            throw new FormulaException("lsystem.rule", "The weight before the letter must be a number of 0 or more.", line, given.Groups[1].Index + 1);
        Weight = weight;
        return given.Length;
    }

    private static int Closing(string text, int open, int end, int line)
    {
        var depth = 0;
        for (var i = open; i < end; i++)
        {
            if (text[i] == '(') depth++;
            else if (text[i] == ')' && --depth == 0) return i;
        }
        throw new FormulaException("lsystem.bracket", "'(' has no closing ')'.", line, open + 1);
    }

    private static int Skip(string text, int i)
    {
        while (i < text.Length && char.IsWhiteSpace(text[i])) i++;
        return i;
    }
}
