namespace Caterpillar.Machines;

internal enum TemplatePartKind : byte
{
    Text,

    /// <summary>A named text.</summary>
    Name,

    /// <summary>A formula. Its value is written.</summary>
    Value,
    If,
    Elsif,
    Else,
    Endif,
    LineEnd,
}

/// <summary>A piece of a template.</summary>
internal sealed record TemplatePart(TemplatePartKind Kind, string Text, SourceLocation Place, Formula? Formula = null)
{
    public bool IsDirective => Kind is TemplatePartKind.If or TemplatePartKind.Elsif or TemplatePartKind.Else or TemplatePartKind.Endif;
}
