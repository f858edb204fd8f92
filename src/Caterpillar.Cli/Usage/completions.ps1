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
