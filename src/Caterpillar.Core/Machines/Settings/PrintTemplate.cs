namespace Caterpillar.Machines;

/// <summary>Templates of printers: they may contain keys of the three profiles and names of values of the print.</summary>
internal static class PrintTemplate
{
    /// <summary>Names in addition to the keys of profiles, and their meanings.</summary>
    public static IReadOnlyList<KeyValuePair<string, string>> Names { get; }
        = [.. EmbeddedText.Rows("names/TemplateNames.tsv").Skip(1).Select(r => new KeyValuePair<string, string>(r[0], r[1]))];

    private static readonly TemplateNames All = OfAll();

    /// <inheritdoc cref="Template.Parse"/>
    public static Result<Template> Parse(IReadOnlyList<string> lines, SourceLocation? source = null)
        => Template.Parse(lines, All, source ?? new SourceLocation());

    /// <summary>The first error in the lines of a template, or null.</summary>
    public static Diagnostic? Error(IReadOnlyList<string> lines) => Parse(lines).Diagnostics.FirstOrDefault();

    private static TemplateNames OfAll()
    {
        var keys = ProfileKeys.All.ToArray();
        var texts = Names.ToLookup(p => p.Key.EndsWith("_name", StringComparison.Ordinal), p => p.Key);
        return new TemplateNames(
            [.. keys.Where(k => k.Kind is KeyKind.Number or KeyKind.Integer or KeyKind.Boolean).Select(k => k.Name), .. texts[false]],
            [.. keys.Where(k => k.Kind is KeyKind.Choice).Select(k => k.Name), .. texts[true]]);
    }
}
