namespace Caterpillar.Cli;

/// <summary>Completions of PowerShell 5 and later.</summary>
internal static class PowerShellCompletions
{
    public static void Write(TextWriter text, CompletionTable table)
    {
        text.WriteLine("# PowerShell completions of caterpillar: caterpillar completions powershell | Out-String | Invoke-Expression, in $PROFILE");
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
        text.WriteLine("  }");
        text.WriteLine("  $given = @($ast.CommandElements | Select-Object -Skip 1 | Where-Object { $_.Extent.EndOffset -lt $cursor } | ForEach-Object { "
            + "\"$_\" })");
        text.WriteLine("  $verb = $given | Where-Object { $_ -notlike '-*' } | Select-Object -First 1");
        text.WriteLine("  function Offer($value, $help) { [System.Management.Automation.CompletionResult]::new($value, $value, 'ParameterValue', $help) }");
        text.WriteLine("  if (-not $verb -or -not $verbs.Contains($verb)) {");
        text.WriteLine("    $verbs.Keys | Where-Object { $_ -like \"$word*\" } | ForEach-Object { Offer $_ $verbs[$_].help }");
        text.WriteLine("    return");
        text.WriteLine("  }");
        text.WriteLine("  $options = $verbs[$verb].options");
        text.WriteLine("  $last = $given | Select-Object -Last 1");
        text.WriteLine("  if ($options.Contains($last) -and $options[$last][1].Count -gt 0) {");
        text.WriteLine("    $options[$last][1] | Where-Object { $_ -like \"$word*\" } | ForEach-Object { Offer $_ $_ }");
        text.WriteLine("  } elseif ($word -like '-*') {");
        text.WriteLine("    $options.Keys | Where-Object { $_ -like \"$word*\" } | ForEach-Object { Offer $_ $options[$_][0] }");
        text.WriteLine("  } else {");
        text.WriteLine("    $verbs[$verb].words | Where-Object { $_ -like \"$word*\" } | ForEach-Object { Offer $_ $_ }");
        text.WriteLine("  }");
        text.WriteLine("}");
    }

    private static string List(System.Collections.Generic.IReadOnlyList<string> words) => string.Join(", ", words.Select(Quoted));

    private static string Quoted(string word) => "'" + word.Replace("'", "''") + "'";
}
