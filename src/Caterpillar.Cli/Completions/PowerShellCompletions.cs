namespace Caterpillar.Cli;

/// <summary>Completions for PowerShell 5 and later.</summary>
internal static class PowerShellCompletions
{
    public static void Write(TextWriter text, CompletionTable table)
    {
        text.WriteLine("# PowerShell completions for caterpillar. In $PROFILE: caterpillar completions powershell | Out-String | Invoke-Expression");
        text.WriteLine("Register-ArgumentCompleter -Native -CommandName 'caterpillar', 'Caterpillar.Cli' -ScriptBlock {");
        text.WriteLine("  param($word, $ast, $cursor)");
        text.WriteLine("  $verbs = [ordered]@{");
        foreach (var verb in table.Verbs)
        {
            text.WriteLine($"    {Quoted(verb.Name)} = @{{ help = {Quoted(verb.Description)}; words = @({List(verb.Words)}); options = [ordered]@{{");
            foreach (var option in verb.Options)
            {
                foreach (var name in option.Names) text.WriteLine($"      {Quoted(name)} = @({Quoted(option.Description)}, @({List(option.Words)}))");
            }
            text.WriteLine("    } }");
        }
        text.Write(EmbeddedText.Read("usage/completions.ps1", typeof(CompletionTable)));
    }

    private static string List(System.Collections.Generic.IReadOnlyList<string> words) => string.Join(", ", words.Select(Quoted));

    private static string Quoted(string word) => "'" + word.Replace("'", "''") + "'";
}
