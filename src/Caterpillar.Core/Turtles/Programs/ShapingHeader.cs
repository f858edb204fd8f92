using static Caterpillar.Turtles.ScriptCursor;

namespace Caterpillar.Turtles;

/// <summary>Reads the header of a block that shapes the paths drawn in it: <c>deform name = formula, … [</c>.</summary>
internal sealed class ShapingHeader(ScriptCursor cursor, ScriptValues values, ScriptScope scope)
{
    private static readonly Dictionary<string, ModulationMode> Modes = new(System.StringComparer.Ordinal)
    {
        ["speed"] = ModulationMode.Speed,
        ["flow"] = ModulationMode.Flow,
        ["left"] = ModulationMode.DisplaceLeft,
        ["up"] = ModulationMode.DisplaceUp,
    };

    /// <summary>The rules after the word that names their kind.</summary>
    public ShapingRules Read(Token token)
    {
        var kind = token.Text switch
        {
            "deform" => ShapingKind.Deform,
            "modulate" => ShapingKind.Modulate,
            "gap_bead" => ShapingKind.GapBead,
            _ => ShapingKind.CoolLayers,
        };
        var mode = kind == ShapingKind.Modulate ? Mode() : default;
        var (slot, local) = scope.Hidden(ShapingRules.Coordinates.Count);
        var rules = new ShapingRules(kind, mode, slot, local, token);
        var used = scope.UsedCoordinates;
        used.Clear();
        foreach (var name in ShapingRules.Visible(kind)) scope.Coordinates[name] = (slot + ShapingRules.Coordinates.ToList().IndexOf(name), local);
        if (scope.Coordinates.TryGetValue("theta", out var theta)) scope.Coordinates["θ"] = theta;
        Formulas(rules);
        scope.Coordinates.Clear();
        Complete(rules, used);
        return rules;
    }

    private ModulationMode Mode()
    {
        var word = cursor.Next;
        if (word.Kind != TokenKind.Name || !Modes.TryGetValue(word.Text, out var mode))
            throw Error("turtle.values", $"Found {word}, expected speed, flow, left or up.", word);
        cursor.At++;
        return mode;
    }

    private void Formulas(ShapingRules rules)
    {
        var names = ShapingRules.Names(rules.Kind);
        while (true)
        {
            while (cursor.Next.Kind == TokenKind.NewLine || cursor.Next.Is(",") || cursor.Next.Is(";")) cursor.At++;
            var name = cursor.Next;
            if (name.Is("[")) return;
            var known = name.Text == "θ" ? "theta" : name.Text;
            if (name.Kind != TokenKind.Name || !names.Contains(known))
            {
                throw Error("turtle.values", $"Found {name}, expected '[' or one of {string.Join(", ", names)}.{SpellingSuggestion.Hint(name.Text, names)}",
                    name);
            }
            cursor.At++;
            cursor.Expect("=", $"{name.Text} = …");
            if (rules[known] is not null) throw Error("turtle.values", $"'{known}' has two formulas.", name);
            rules.Add(known, values.Formula("="));
        }
    }

    private static void Complete(ShapingRules rules, HashSet<string> used)
    {
        var at = rules.At;
        bool flat = rules.Has("x", "y"), round = rules.Has("r", "theta");
        if (flat && round) throw Error("turtle.values", "x and y cannot be combined with r and theta. Use two blocks, one inside the other.", at);
        bool readsFlat = used.Contains("x") || used.Contains("y"), readsRound = used.Contains("r") || used.Contains("theta") || used.Contains("θ");
        rules.IsCylindrical = round || (!flat && !readsFlat);
        rules.NeedsBoth = rules.Kind == ShapingKind.Modulate ? readsRound : rules.IsCylindrical ? readsFlat : readsRound;
        if (rules.Kind == ShapingKind.Deform && !flat && !round && !rules.Has("z", "c", "v"))
            throw Error("turtle.values", "'deform' needs a formula: deform r = r + 1.05 * z [ … ].", at);
        if (rules.Kind != ShapingKind.Modulate) return;
        if (!rules.Has("field")) throw Error("turtle.values", "'modulate' needs a field: modulate speed field = noise(x, y, z) [ … ].", at);
        if (rules.Mode is ModulationMode.DisplaceLeft or ModulationMode.DisplaceUp && !rules.Has("high"))
            throw Error("turtle.values", "'modulate left' and 'modulate up' need 'high': the displacement in mm at a field of 1.", at);
    }
}
