namespace Caterpillar.Turtles;

/// <summary>Chooses the rules while a word grows.</summary>
internal sealed class LSystemGrowth
{
    // Turns are not neighbors: contexts skip them unless they name them (Prusinkiewicz and Lindenmayer 1990, section 1.8: #ignore).
    private const string Turns = "+-^&\\/|";
    private const double Rounding = 1e-9;

    private readonly IReadOnlyDictionary<char, LSystemRule[]> _rules;
    private readonly double[] _variables;
    private readonly DiagnosticList _notes = new();
    private readonly List<LSystemRule> _fitting = [];
    private readonly List<int> _neighbors = [];

    public LSystemGrowth(IReadOnlyDictionary<char, LSystemRule[]> rules, double[] variables, int seed)
    {
        _rules = rules;
        _variables = variables;
        var most = rules.Values.SelectMany(r => r).Select(r => r.ValueCount).DefaultIfEmpty(0).Max();
        Context = new FormulaContext(new double[most + variables.Length], new SeededRandom(seed));
        _variables.CopyTo(Context.Values, 0);
    }

    /// <summary>The values that the formulas of the rule chosen last see.</summary>
    public FormulaContext Context { get; }

    /// <summary>True when chance has decided about a letter.</summary>
    public bool HasDrawn { get; private set; }

    public IReadOnlyList<Diagnostic> Notes => _notes.ToList();

    /// <summary>The rule that replaces a letter, or null if the letter stays.</summary>
    /// <exception cref="FormulaException">The weights of the rules that fit add up to more than 1.</exception>
    public LSystemRule? Choose(LSystemWord word, int index)
    {
        if (!_rules.TryGetValue(word[index], out var rules)) return null;
        _fitting.Clear();
        double weights = 0;
        var sameCount = false;
        foreach (var rule in rules)
        {
            if (rule.Names.Length != word.ValueCount(index)) continue;
            sameCount = true;
            if (!Bind(rule, word, index) || (rule.Condition is { } condition && condition.Evaluate(Context) == 0)) continue;
            _fitting.Add(rule);
            weights += rule.Weight ?? 0;
        }
        if (!sameCount) Note(word, index, rules);
        var chosen = _fitting.Count == 0 ? null : _fitting.TrueForAll(r => r.Weight is null) ? _fitting[0] : Draw(weights, word[index]);
        if (chosen is not null && _fitting.Count > 1) Bind(chosen, word, index);
        return chosen;
    }

    // Weights are probabilities. The first rule without a weight gets the rest. Without such a rule, the letter stays.
    private LSystemRule? Draw(double weights, char letter)
    {
        if (weights > 1 + Rounding) throw TooHeavy(letter, weights, 0);
        HasDrawn = true;
        var draw = Context.Random.NextDouble();
        var rest = Math.Max(0, 1 - weights);
        foreach (var rule in _fitting)
        {
            draw -= rule.Weight ?? rest;
            if (draw < 0) return rule;
            if (rule.Weight is null) rest = 0;
        }
        return weights > 1 - Rounding ? _fitting[_fitting.Count - 1] : null;
    }

    public static FormulaException TooHeavy(char letter, double weights, int line)
        => new("lsystem.weights", $"The weights of the rules for '{letter}' add up to {NumberFormatter.Format(weights, 6)}. The maximum is 1.",
            line, 1);

    // Stores the values of the letter and its contexts for the formulas of the rule. False if a context does not match.
    private bool Bind(LSystemRule rule, LSystemWord word, int index)
    {
        _neighbors.Clear();
        for (int p = rule.Left.Length - 1, at = index; p >= 0; p--)
        {
            at = Before(word, at, rule.Left[p].Symbol);
            if (!IsOf(rule.Left[p], word, at)) return false;
            _neighbors.Insert(0, at);
        }
        _neighbors.Add(index);
        for (int p = 0, at = index; p < rule.Right.Length; p++)
        {
            at = After(word, at, rule.Right[p].Symbol);
            if (!IsOf(rule.Right[p], word, at)) return false;
            _neighbors.Add(at);
        }
        var values = Context.Values;
        var count = 0;
        foreach (var letter in _neighbors)
        {
            for (var v = 0; v < word.ValueCount(letter); v++) values[count++] = word.Value(letter, v);
        }
        _variables.CopyTo(values, count);
        return true;
    }

    private static bool IsOf(Pattern pattern, LSystemWord word, int at)
        => at >= 0 && word[at] == pattern.Symbol && word.ValueCount(at) == pattern.Names.Length;

    // The letter before one on its branch. Ended branches are skipped. Before the beginning of its own branch comes the trunk.
    private static int Before(LSystemWord word, int at, char wanted)
    {
        var depth = 0;
        for (at--; at >= 0; at--)
        {
            var letter = word[at];
            if (letter == ']') depth++;
            else if (letter == '[') depth = Math.Max(0, depth - 1);
            else if (depth == 0 && (letter == wanted || !IsTurn(letter))) return at;
        }
        return -1;
    }

    // The letter after one on its branch. Side branches are skipped. The end of its own branch is the end.
    private static int After(LSystemWord word, int at, char wanted)
    {
        var depth = 0;
        for (at++; at < word.Count; at++)
        {
            var letter = word[at];
            if (letter == '[') depth++;
            else if (letter == ']' && --depth < 0) return -1;
            else if (letter != ']' && depth == 0 && (letter == wanted || !IsTurn(letter))) return at;
        }
        return -1;
    }

    private void Note(LSystemWord word, int index, LSystemRule[] rules)
    {
        const string Code = "lsystem.value_count";
        if (_notes.Contains(Code, Severity.Note))
        {
            _notes.Add(Severity.Note, Code, "");
            return;
        }
        var counts = string.Join(" or ", rules.Select(r => r.Names.Length).Distinct().OrderBy(n => n).Select(n => NumberFormatter.Format(n)));
        _notes.Add(Severity.Note, Code,
            $"'{word[index]}' with {Figures.Count(word.ValueCount(index), "value")} stays unchanged. Number of values in its rules: {counts}.");
    }

    private static bool IsTurn(char letter) => Turns.IndexOf(letter, 0) >= 0;
}
