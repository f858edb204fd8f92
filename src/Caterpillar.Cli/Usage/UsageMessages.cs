using System.CommandLine.Parsing;
using System.Text.RegularExpressions;
using Caterpillar.Expressions;

namespace Caterpillar.Cli;

/// <summary>What is wrong with a command line, in sentences that name what was probably meant.</summary>
internal static partial class UsageMessages
{
    /// <summary>The sentences; none where nothing is wrong.</summary>
    public static IEnumerable<string> Of(ParseResult parsed, Command root)
    {
        if (UnknownVerb(parsed, root) is { } verb) return [verb];
        if (UnknownOption(parsed) is { } option) return [option];
        return parsed.Errors.Select(e => Plain(e.Message)).Distinct();
    }

    /// <summary>A misspelled option, which the parser takes for the value of an argument where that accepts any text.</summary>
    public static string? UnknownOption(ParseResult parsed)
    {
        if (parsed.Tokens.Any(t => t.Type == TokenType.DoubleDash)) return null;
        var many = parsed.CommandResult.Command is Verb { Batch: { } batch } ? parsed.GetResult(batch.Each)?.Tokens ?? [] : [];
        var arguments = parsed.CommandResult.Children.OfType<ArgumentResult>().SelectMany(a => a.Tokens).Concat(many).Select(t => t.Value);
        if (arguments.Concat(parsed.UnmatchedTokens).FirstOrDefault(v => v.Length > 1 && v[0] == '-' && !IsNumber(v)) is not { } word) return null;
        var known = parsed.CommandResult.Command.Options.Concat(parsed.RootCommandResult.Command.Options).Select(o => o.Name);
        var name = word.Split('=', ':')[0];
        return $"There is no option {name}." + (SpellingSuggestion.Nearest(name, known) is { } near ? $" Did you mean {near}?"
            : $" For a file of this name write ./{name}");
    }

    private static string? UnknownVerb(ParseResult parsed, Command root)
    {
        if (parsed.CommandResult.Command is Verb || parsed.UnmatchedTokens.Count == 0) return null;
        var word = parsed.UnmatchedTokens[0];
        return word.StartsWith('-') ? null : $"There is no verb {word}." + SpellingSuggestion.Hint(word, root.Subcommands.Select(v => v.Name));
    }

    private static bool IsNumber(string word) => Basics.NumberReader.TryParse(word.Split(',', '%')[0], out _);

    // The parser names types of the runtime, and lists choices over many lines.
    private static string Plain(string message)
    {
        if (WrongChoice().Match(message) is { Success: true } choice) return NoneOf(choice.Groups["value"].Value, choice.Groups["choices"].Value);
        if (WrongType().Match(message) is { Success: true } wrong)
        {
            var type = wrong.Groups["type"].Value;
            var what = type.Contains("Int", StringComparison.Ordinal) ? "a whole number" : type.Contains("Double", StringComparison.Ordinal) ? "a number"
                : type.Contains("Boolean", StringComparison.Ordinal) ? "nothing, true or false" : "another value";
            return $"{wrong.Groups["option"].Value} needs {what}, not \"{wrong.Groups["value"].Value}\".";
        }
        if (WrongWord().Match(message) is { Success: true } word) return NoneOf(word.Groups["value"].Value, word.Groups["choices"].Value);
        if (MissingValue().Match(message) is { Success: true } missing)
        {
            return $"{missing.Groups["name"].Value} needs {(missing.Groups["kind"].Value == "command" ? "a file." : "a value.")}";
        }
        return message == "Required command was not provided." ? "Say what to do: a verb is missing." : message;
    }

    private static string NoneOf(string value, string lines)
    {
        var choices = lines.Split('\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries).Select(c => c.Trim('\'')).ToArray();
        return $"\"{value}\" is none of {string.Join(", ", choices)}." + SpellingSuggestion.Hint(value, choices);
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
