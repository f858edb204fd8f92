namespace Caterpillar.Turtles;

/// <summary>
/// A rewriting system (Prusinkiewicz and Lindenmayer, "The Algorithmic Beauty of Plants", 1990, chapter 1). It can be deterministic, stochastic, parametric,
/// bracketed and context-sensitive. Rules are text: <c>F -&gt; F+F--F+F</c>. A weight makes the choice random: <c>0.3 F -&gt; F[+F]F</c>. Letters can have
/// values, and rules a condition: <c>A(l, w) : l &gt; 1 -&gt; F(l)[+A(l*0.7, w)]</c>. If any matching rule has a weight, the rule is chosen at random by
/// weight. Otherwise the first matching rule applies. Letters without a rule stay unchanged.
/// </summary>
public sealed class LSystem
{
    /// <summary>Default maximum number of letters of a word.</summary>
    public const int DefaultMaxSymbols = 10_000_000;

    private readonly Module[] _axiom;
    private readonly Dictionary<char, LSystemRule[]> _rules;

    private LSystem(Module[] axiom, LSystemRule[] rules, LSystemNames variables)
    {
        Variables = variables;
        _axiom = axiom;
        _rules = rules.GroupBy(r => r.Symbol).ToDictionary(g => g.Key, g => g.ToArray());
    }

    /// <summary>Outside variables that the formulas can use.</summary>
    internal LSystemNames Variables { get; }

    /// <summary>Reads an axiom and its rules. The line of a diagnostic is the number of the rule (0 = axiom), and the column is the position in it.</summary>
    public static Result<LSystem> Parse(string axiom, IEnumerable<string> rules) => Parse(axiom, rules, []);

    /// <summary>Reads an axiom and rules whose formulas can use variables with these names.</summary>
    internal static Result<LSystem> Parse(string axiom, IEnumerable<string> rules, IReadOnlyList<string> variables)
    {
        if (axiom is null) throw new ArgumentNullException(nameof(axiom));
        if (rules is null) throw new ArgumentNullException(nameof(rules));
        var names = new LSystemNames(variables);
        try
        {
            var read = rules.Where(r => !string.IsNullOrWhiteSpace(r)).Select((r, i) => LSystemRule.Parse(r, i + 1, names)).ToArray();
            CheckWeights(read);
            return new Result<LSystem>(new LSystem(LSystemRule.Word(axiom, 0, [], 0, names), read, names), []);
        }
        catch (FormulaException e)
        {
            var place = new SourceLocation(Line: e.Line, Column: e.Column, Key: e.Line == 0 ? "axiom" : "rule " + NumberFormatter.Format(e.Line));
            return new Result<LSystem>(e.Code, e.Message, place);
        }
    }

    /// <summary>Rewrites the axiom a number of times.</summary>
    /// <param name="generations">0 or more.</param>
    /// <param name="seed">Seed of the random choices.</param>
    /// <param name="maxSymbols">Maximum number of letters, and of values. More are an error.</param>
    /// <param name="progress">Reports after every generation.</param>
    /// <param name="cancel">Stops with <see cref="OperationCanceledException"/>.</param>
    public Result<LSystemWord> Grow(
        int generations, int seed = 0, int maxSymbols = DefaultMaxSymbols, IProgress<double>? progress = null, CancellationToken cancel = default)
        => Grow([], generations, seed, maxSymbols, progress, cancel);

    /// <summary>Rewrites the axiom with these values of the variables.</summary>
    internal Result<LSystemWord> Grow(double[] variables, int generations, int seed, int maxSymbols, IProgress<double>? progress, CancellationToken cancel)
    {
        if (generations < 0) throw new ArgumentOutOfRangeException(nameof(generations), "The number of generations must be 0 or more.");
        var growth = new LSystemGrowth(_rules, variables, seed);
        var context = growth.Context;
        var word = new WordBuilder(maxSymbols);
        try
        {
            foreach (var module in _axiom) word.Add(module, context);
            for (var g = 1; g <= generations; g++)
            {
                var last = word.Build();
                var next = new WordBuilder(maxSymbols);
                var rewritten = false;
                for (var i = 0; i < last.Count; i++)
                {
                    if ((i & 0xFFF) == 0) cancel.ThrowIfCancellationRequested();
                    if (growth.Choose(last, i) is { } rule)
                    {
                        foreach (var module in rule.Successor) next.Add(module, context);
                        rewritten = true;
                    }
                    else
                    {
                        next.Copy(last, i);
                    }
                    if (next.IsFull) return TooLarge(g, maxSymbols);
                }
                word = next;
                progress?.Report((double)g / generations);
                // Nothing can change anymore.
                if (!rewritten && !growth.HasDrawn) break;
            }
        }
        catch (FormulaException e)
        {
            return new Result<LSystemWord>(e.Code, e.Message);
        }
        return new Result<LSystemWord>(word.Build(), growth.Notes);
    }

    // Checks rules that always apply together. The others are checked while a word grows.
    private static void CheckWeights(LSystemRule[] rules)
    {
        var sums = new Dictionary<(char, int), double>();
        for (var i = 0; i < rules.Length; i++)
        {
            var rule = rules[i];
            if (rule.Condition is not null || rule.Left.Length + rule.Right.Length > 0) continue;
            sums.TryGetValue((rule.Symbol, rule.Names.Length), out var sum);
            sums[(rule.Symbol, rule.Names.Length)] = sum += rule.Weight ?? 0;
            if (sum > 1 + 1e-9) throw LSystemGrowth.TooHeavy(rule.Symbol, sum, i + 1);
        }
    }

    private static Result<LSystemWord> TooLarge(int generation, int maxSymbols) => new("lsystem.too_large",
        $"Generation {NumberFormatter.Format(generation)} exceeds {NumberFormatter.Format(maxSymbols)} letters or values. Use fewer generations.");

    private sealed class WordBuilder(int limit)
    {
        private readonly List<char> _symbols = [];
        private readonly List<int> _first = [];
        private readonly List<double> _values = [];

        public bool IsFull => _symbols.Count > limit || _values.Count > limit;

        public void Add(Module module, FormulaContext context)
        {
            Letter(module.Symbol);
            foreach (var formula in module.Values)
            {
                var value = formula.Evaluate(context);
                if (double.IsNaN(value) || double.IsInfinity(value))
                    throw new FormulaException("lsystem.value", $"The value '{formula.Text.Trim()}' of '{module.Symbol}' is not finite.", 0, 0);
                _values.Add(value);
            }
        }

        public void Copy(LSystemWord word, int index)
        {
            Letter(word[index]);
            for (var v = 0; v < word.ValueCount(index); v++) _values.Add(word.Value(index, v));
        }

        public LSystemWord Build()
        {
            if (_values.Count == 0) return new LSystemWord(_symbols.ToArray(), null, []);
            var first = new int[_first.Count + 1];
            _first.CopyTo(first);
            first[_first.Count] = _values.Count;
            return new LSystemWord(_symbols.ToArray(), first, _values.ToArray());
        }

        private void Letter(char symbol)
        {
            _symbols.Add(symbol);
            _first.Add(_values.Count);
        }
    }
}
