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
        text.WriteLine("""
              }
              $given = @($ast.CommandElements | Select-Object -Skip 1 | Where-Object { $_.Extent.EndOffset -lt $cursor } | ForEach-Object { "$_" })
              $verb = $given | Where-Object { $_ -notlike '-*' } | Select-Object -First 1
              function Offer($value, $help) { [System.Management.Automation.CompletionResult]::new($value, $value, 'ParameterValue', $help) }
              if (-not $verb -or -not $verbs.Contains($verb)) {
                $verbs.Keys | Where-Object { $_ -like "$word*" } | ForEach-Object { Offer $_ $verbs[$_].help }
                return
              }
              $options = $verbs[$verb].options
              $last = $given | Select-Object -Last 1
              if ($options.Contains($last) -and $options[$last][1].Count -gt 0) {
                $options[$last][1] | Where-Object { $_ -like "$word*" } | ForEach-Object { Offer $_ $_ }
              } elseif ($word -like '-*') {
                $options.Keys | Where-Object { $_ -like "$word*" } | ForEach-Object { Offer $_ $options[$_][0] }
              } else {
                $verbs[$verb].words | Where-Object { $_ -like "$word*" } | ForEach-Object { Offer $_ $_ }
              }
            }
            """);
    }

    private static string List(System.Collections.Generic.IReadOnlyList<string> words) => string.Join(", ", words.Select(Quoted));

    private static string Quoted(string word) => "'" + word.Replace("'", "''") + "'";
}
