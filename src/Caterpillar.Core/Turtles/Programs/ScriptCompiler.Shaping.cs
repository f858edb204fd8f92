using System.Collections.Generic;
using System.Linq;
using Caterpillar.Expressions;
using Caterpillar.Shaping;

namespace Caterpillar.Turtles;

// Blocks that shape the paths drawn in them: deform, modulate, gap_bead, cool_layers.
internal sealed partial class ScriptCompiler
{
    private static readonly Dictionary<string, ModulationMode> Modes = new(System.StringComparer.Ordinal)
    {
        ["speed"] = ModulationMode.Speed,
        ["flow"] = ModulationMode.Flow,
        ["left"] = ModulationMode.DisplaceLeft,
        ["up"] = ModulationMode.DisplaceUp,
    };

    // The blocks that are open, the innermost last.
    private readonly List<ShapingRules> _shapings = [];

    // deform name = formula, … [ … ]
    private void Shape(Token token)
    {
        var kind = token.Text switch
        {
            "deform" => ShapingKind.Deform,
            "modulate" => ShapingKind.Modulate,
            "gap_bead" => ShapingKind.GapBead,
            _ => ShapingKind.CoolLayers,
        };
        var mode = kind == ShapingKind.Modulate ? Mode() : default;
        var (slot, local) = _scope.Hidden(ShapingRules.Coordinates.Count);
        var rules = new ShapingRules(kind, mode, slot, local, token);
        Header(rules);
        Emit(new Instruction(ScriptOp.BeginShaping, token) { Shaping = rules });
        _shapings.Add(rules);
        Block();
        CloseShapings(_shapings.Count - 1, token);
        _shapings.RemoveAt(_shapings.Count - 1);
    }

    private ModulationMode Mode()
    {
        var word = Next;
        if (word.Kind != TokenKind.Name || !Modes.TryGetValue(word.Text, out var mode))
            throw Error("turtle.values", $"Found {word}, expected what to modulate: speed, flow, left or up.", word);
        _at++;
        return mode;
    }

    private void Header(ShapingRules rules)
    {
        var names = ShapingRules.Names(rules.Kind);
        var used = _scope.UsedCoordinates;
        used.Clear();
        foreach (var name in ShapingRules.Visible(rules.Kind))
            _scope.Coordinates[name] = (rules.Slot + ShapingRules.Coordinates.ToList().IndexOf(name), rules.Local);
        if (_scope.Coordinates.TryGetValue("theta", out var theta)) _scope.Coordinates["θ"] = theta;
        while (true)
        {
            while (Next.Kind == TokenKind.NewLine || Next.Is(",") || Next.Is(";")) _at++;
            if (Next.Is("[")) break;
            var name = Next;
            var known = name.Text == "θ" ? "theta" : name.Text;
            if (name.Kind != TokenKind.Name || !names.Contains(known))
            {
                throw Error("turtle.values", $"Found {name}, expected '[' or one of {string.Join(", ", names)}.{SpellingSuggestion.Hint(name.Text, names)}",
                    name);
            }
            _at++;
            if (!Next.Is("=")) throw Error("turtle.syntax", $"Found {Next}, expected '=': {name.Text} = ….", Next);
            _at++;
            if (rules[known] is not null) throw Error("turtle.values", $"'{known}' has two formulas.", name);
            rules.Add(known, Formula("="));
        }
        _scope.Coordinates.Clear();
        Complete(rules, used);
    }

    private static void Complete(ShapingRules rules, HashSet<string> used)
    {
        var at = rules.At;
        bool flat = rules.Has("x", "y"), round = rules.Has("r", "theta");
        if (flat && round) throw Error("turtle.values", "x and y do not go together with r and theta: use two blocks, one inside the other.", at);
        bool readsFlat = used.Contains("x") || used.Contains("y"), readsRound = used.Contains("r") || used.Contains("theta") || used.Contains("θ");
        rules.IsCylindrical = round || (!flat && !readsFlat);
        rules.NeedsBoth = rules.Kind == ShapingKind.Modulate ? readsRound : rules.IsCylindrical ? readsFlat : readsRound;
        if (rules.Kind == ShapingKind.Deform && !flat && !round && !rules.Has("z", "c", "v"))
            throw Error("turtle.values", "'deform' needs a formula: deform r = r + 1.05 * z [ … ].", at);
        if (rules.Kind != ShapingKind.Modulate) return;
        if (!rules.Has("field")) throw Error("turtle.values", "'modulate' needs a field: modulate speed field = noise(x, y, z) [ … ].", at);
        if (rules.Mode is ModulationMode.DisplaceLeft or ModulationMode.DisplaceUp && !rules.Has("high"))
            throw Error("turtle.values", "'modulate' needs high, the displacement in mm where the field is 1.", at);
    }

    // Ends the blocks beyond a number of them, the innermost first; they stay open for what follows.
    private void CloseShapings(int beyond, Token token)
    {
        for (var i = _shapings.Count - 1; i >= beyond; i--) Emit(new Instruction(ScriptOp.EndShaping, token) { Shaping = _shapings[i] });
    }
}
