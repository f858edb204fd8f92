namespace Caterpillar.Cli;

/// <summary>Messages for a wrong command line, with suggestions.</summary>
internal static partial class UsageMessages
{
    /// <summary>The messages; none if the command line is right.</summary>
    public static IEnumerable<string> Of(ParseResult parsed, Command root)
    {
        if (UnknownVerb(parsed, root) is { } verb) return [verb];
        if (UnknownOption(parsed) is { } option) return [option];
        return parsed.Errors.Select(e => Plain(e, parsed.CommandResult.Command)).Distinct();
    }

    /// <summary>The message for an unknown option, which the parser takes for the value of an argument, or null.</summary>
    public static string? UnknownOption(ParseResult parsed)
    {
        if (parsed.Tokens.Any(t => t.Type == TokenType.DoubleDash)) return null;
        var many = parsed.CommandResult.Command is Verb { Batch: { } batch } ? parsed.GetResult(batch.Each)?.Tokens ?? [] : [];
        var arguments = parsed.CommandResult.Children.OfType<ArgumentResult>().SelectMany(a => a.Tokens).Concat(many).Select(t => t.Value);
        if (arguments.Concat(parsed.UnmatchedTokens).FirstOrDefault(v => v.Length > 1 && v[0] == '-' && !IsNumber(v)) is not { } word) return null;
        var (verb, root) = (parsed.CommandResult.Command, parsed.RootCommandResult.Command);
        var parts = word.Split(['=', ':'], 2);
        var name = parts[0];
        var next = parsed.Tokens.SkipWhile(t => t.Value != word).Skip(1).FirstOrDefault()?.Value;
        var value = new[] { parts.ElementAtOrDefault(1), next }.FirstOrDefault(v => v is not null && IsNumber(v));
        var known = verb.Options.Concat(root.Options).Select(o => o.Name.TrimStart('-'));
        return $"Unknown option {name}. " + (SlicerWords.Advice(name, value, verb, root.Subcommands)
            ?? (SpellingSuggestion.Nearest(name.TrimStart('-'), known) is { } near ? $"Did you mean --{near}?" : $"If it is a file, write ./{name}"));
    }

    private static string? UnknownVerb(ParseResult parsed, Command root)
    {
        if (parsed.CommandResult.Command is Verb || parsed.UnmatchedTokens.Count == 0) return null;
        var word = parsed.UnmatchedTokens[0];
        return word.StartsWith('-') ? null : $"Unknown command {word}." + SpellingSuggestion.Hint(word, root.Subcommands.Select(v => v.Name));
    }

    private static bool IsNumber(string word) => Basics.NumberReader.TryParse(word.Split(',', '%')[0], out _);

    // The parser names types of the runtime, and lists choices on many lines.
    private static string Plain(ParseError error, Command command)
    {
        var message = error.Message;
        if (WrongChoice().Match(message) is { Success: true } choice) return NoneOf(error, choice);
        if (WrongType().Match(message) is { Success: true } wrong)
        {
            var type = wrong.Groups["type"].Value;
            var what = type.Contains("Int", StringComparison.Ordinal) ? "a whole number" : type.Contains("Double", StringComparison.Ordinal) ? "a number"
                : type.Contains("Boolean", StringComparison.Ordinal) ? "no value, true or false" : "another value";
            return $"{wrong.Groups["option"].Value} needs {what}, not \"{wrong.Groups["value"].Value}\".";
        }
        if (WrongWord().Match(message) is { Success: true } word) return NoneOf(error, word);
        if (MissingValue().Match(message) is { Success: true } missing)
        {
            return missing.Groups["kind"].Value == "command" ? $"The {command.Arguments[0].Name} is missing."
                : $"{missing.Groups["name"].Value} needs a value.";
        }
        return message == "Required command was not provided." ? "The command is missing." : message;
    }

    private static string NoneOf(ParseError error, Match match)
    {
        var value = match.Groups["value"].Value;
        var choices = match.Groups["choices"].Value.Split('\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries)
            .Select(c => c.Trim('\'').ToLowerInvariant()).ToArray();
        var name = error.SymbolResult switch
        {
            OptionResult o => o.Option.Name,
            ArgumentResult { Parent: OptionResult o } => o.Option.Name,
            ArgumentResult a => a.Argument.Name,
            _ => "The value",
        };
        return $"{name} needs {Words.Either(choices)}, not \"{value}\"." + SpellingSuggestion.Hint(value, choices);
    }

    [GeneratedRegex("argument '(?<value>.*)' for option .*Did you mean one of the following\\?(?<choices>.*)$", RegexOptions.Singleline)]
    private static partial Regex WrongChoice();

    [GeneratedRegex("argument '(?<value>.*)' for option '(?<option>[^']*)' as expected type '(?<type>[^']*)'", RegexOptions.Singleline)]
    private static partial Regex WrongType();

    [GeneratedRegex("^Required argument missing for (?<kind>command|option): '(?<name>[^']*)'")]
    private static partial Regex MissingValue();

    [GeneratedRegex("^Argument '(?<value>.*)' not recognized. Must be one of:(?<choices>.*)$", RegexOptions.Singleline)]
    private static partial Regex WrongWord();
}
