using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using Mono.Cecil;

namespace Caterpillar.GH.Tests.Api;

/// <summary>
/// One spelling for types, whatever list or assembly they come from: <c>Name{Arguments}</c>, nested types after a dot, <c>@</c> for by reference, <c>*</c> for
/// any generic parameter.
/// </summary>
internal static class Canonical
{
    private static readonly Regex Arity = new("`+[0-9]+", RegexOptions.Compiled);
    private static readonly Regex Positional = new("(?<![A-Za-z0-9_])``?[0-9]+", RegexOptions.Compiled);

    /// <summary>A type of the exact lists: <c>System.Collections.Generic.List`1&lt;T&gt;</c>.</summary>
    public static string OfList(string type)
    {
        var text = new StringBuilder();
        var word = new StringBuilder();
        void Flush()
        {
            var name = word.ToString();
            word.Clear();
            // A lone short name is a generic parameter: every real type has a namespace.
            text.Append(name.Length > 0 && name.IndexOf('.') < 0 ? "*" : name);
        }
        foreach (var c in type)
        {
            if (c is '<' or '>' or ',' or '[' or ']' or '@')
            {
                Flush();
                text.Append(c switch { '<' => '{', '>' => '}', _ => c });
            }
            else if (c != ' ')
            {
                word.Append(c);
            }
        }
        Flush();
        return KeepTop(text.ToString());
    }

    /// <summary>A parameter of the exact lists: <c>out System.Double t</c>, <c>System.Int32 n = 3</c>.</summary>
    public static string OfParameter(string parameter)
    {
        var equals = parameter.IndexOf(" = ", System.StringComparison.Ordinal);
        if (equals >= 0) parameter = parameter.Substring(0, equals);
        var byReference = parameter.StartsWith("ref ", System.StringComparison.Ordinal) || parameter.StartsWith("out ", System.StringComparison.Ordinal);
        var words = parameter.Split(' ').Where(w => w is not ("ref" or "out" or "in" or "params")).ToArray();
        return OfList(words[0]) + (byReference ? "@" : "");
    }

    /// <summary>A type of a documentation id: <c>System.Collections.Generic.List{`0}@</c>.</summary>
    public static string OfDocumentation(string type) => KeepTop(Positional.Replace(type.Replace("{{", "{"), "*"));

    public static string Of(TypeReference type) => type switch
    {
        ByReferenceType reference => Of(reference.ElementType) + "@",
        ArrayType array => Of(array.ElementType) + "[" + new string(',', array.Rank - 1) + "]",
        GenericParameter => "*",
        GenericInstanceType generic => Arity.Replace(Name(generic.ElementType), "") + "{" + string.Join(",", generic.GenericArguments.Select(Of)) + "}",
        RequiredModifierType modified => Of(modified.ElementType),
        _ => Name(type),
    };

    /// <summary>Name of a type definition, with its number of generic parameters.</summary>
    public static string Name(TypeReference type) => type.GetElementType().FullName.Replace('/', '.');

    // The number after a name is kept only if no arguments follow it.
    private static string KeepTop(string type) => Regex.Replace(type, "`[0-9]+(?=\\{)", "");
}
