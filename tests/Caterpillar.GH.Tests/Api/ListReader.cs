using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;

namespace Caterpillar.GH.Tests.Api;

/// <summary>Reads the three forms of lists in shared/reference/api.</summary>
internal static class ListReader
{
    public static IEnumerable<string> Lines(string file)
    {
        using var reader = new StreamReader(new GZipStream(File.OpenRead(file), CompressionMode.Decompress));
        while (reader.ReadLine() is { } line)
        {
            if (line.Length > 2) yield return line;
        }
    }

    /// <summary>Exact lists read from metadata: <c>T type : kind bases</c>, <c>M type.name(types names) : return flags</c> and so on.</summary>
    public static void ReadExact(IEnumerable<string> lines, ApiList list)
    {
        foreach (var line in lines)
        {
            var colon = line.IndexOf(" : ", StringComparison.Ordinal);
            var head = line.Substring(2, colon - 2);
            var tail = line.Substring(colon + 3);
            if (line[0] == 'T')
            {
                var words = tail.Split([' '], 8).ToList();
                var kind = words.FindIndex(w => w is "class" or "struct" or "interface" or "enum" or "delegate");
                var type = new ApiType
                {
                    IsInterface = words[kind] == "interface",
                    IsAbstract = words.Take(kind).Contains("abstract"),
                    IsSealed = words.Take(kind).Contains("sealed") || words[kind] is "struct" or "enum",
                };
                type.Bases.AddRange(Split(string.Join(" ", words.Skip(kind + 1))).Select(Canonical.OfList));
                list.Types[Canonical.OfList(head)] = type;
                continue;
            }
            var open = head.IndexOfAny(['(', '[']);
            var path = open < 0 ? head : head.Substring(0, open);
            var constructor = path.EndsWith("..ctor", StringComparison.Ordinal);
            var dot = constructor ? path.Length - 6 : path.LastIndexOf('.');
            var owner = list.Type(path.Substring(0, dot));
            var parameters = open < 0 ? [] : Split(head.Substring(open + 1, head.Length - open - 2)).Select(Canonical.OfParameter).ToArray();
            owner.Members.Add(Member(line[0], constructor ? "#ctor" : path.Substring(dot + 1), parameters, tail));
        }
    }

    /// <summary>Documentation ids: exact parameters, nothing else.</summary>
    public static void ReadDocumentation(IEnumerable<string> lines, ApiList list)
    {
        foreach (var line in lines)
        {
            var id = line.Substring(2);
            if (line[0] == 'T')
            {
                list.Type(Canonical.OfDocumentation(id));
                continue;
            }
            var open = id.IndexOf('(');
            var path = open < 0 ? id : id.Substring(0, open);
            var dot = path.LastIndexOf('.');
            var name = path.Substring(dot + 1);
            var generic = name.IndexOf('`');
            if (generic >= 0) name = name.Substring(0, generic);
            var parameters = open < 0 ? [] : Split(id.Substring(open + 1, id.Length - open - 2)).Select(Canonical.OfDocumentation).ToArray();
            list.Type(Canonical.OfDocumentation(path.Substring(0, dot))).Members.Add(new ApiMember(name, parameters, parameters.Length));
        }
    }

    /// <summary>Stubs in Python style: names, numbers of parameters, static or not, values of enums.</summary>
    public static void ReadStubs(IEnumerable<string> lines, ApiList list)
    {
        foreach (var line in lines)
        {
            var text = line.Substring(2);
            if (line[0] == 'T')
            {
                var colon = text.IndexOf(" :", StringComparison.Ordinal);
                var type = list.Type(text.Substring(0, colon));
                type.Bases.AddRange(Split(text.Substring(colon + 2)).Where(b => b.Length > 0));
                continue;
            }
            if (line[0] == 'F')
            {
                var end = text.IndexOfAny([' ', ':']);
                var value = text.Contains(" = ") ? text.Substring(text.IndexOf(" = ", StringComparison.Ordinal) + 3) : null;
                Add(text.Substring(0, end), [], m => m with { IsStatic = true, Value = value });
                continue;
            }
            var open = text.IndexOf('(');
            var close = text.LastIndexOf(") ->", StringComparison.Ordinal);
            var parameters = Split(text.Substring(open + 1, close - open - 1)).ToList();
            var instance = parameters.Count > 0 && parameters[0] == "self";
            if (parameters.Count > 0 && parameters[0] is "self" or "cls") parameters.RemoveAt(0);
            var setter = line[0] == 'P' && parameters.Count > 0 && text.EndsWith("-> None", StringComparison.Ordinal);
            if (setter) parameters.RemoveAt(parameters.Count - 1);
            Add(text.Substring(0, open), parameters, m => m with { IsStatic = !instance, CanRead = !setter, CanWrite = setter });
        }

        void Add(string path, IReadOnlyCollection<string> parameters, Func<ApiMember, ApiMember> more)
        {
            var dot = path.LastIndexOf('.');
            var name = path.Substring(dot + 1);
            list.Type(path.Substring(0, dot)).Members.Add(more(new ApiMember(name == "__init__" ? "#ctor" : name, null, parameters.Count)));
        }
    }

    /// <summary>Splits at commas outside of brackets.</summary>
    internal static IEnumerable<string> Split(string text)
    {
        int depth = 0, start = 0;
        for (var i = 0; i < text.Length; i++)
        {
            if (text[i] is '<' or '{' or '[' or '(') depth++;
            if (text[i] is '>' or '}' or ']' or ')') depth--;
            if (text[i] != ',' || depth > 0) continue;
            yield return text.Substring(start, i - start).Trim();
            start = i + 1;
        }
        if (text.Trim().Length > 0) yield return text.Substring(start).Trim();
    }

    private static ApiMember Member(char kind, string name, string[] parameters, string tail)
    {
        var equals = tail.IndexOf(" = ", StringComparison.Ordinal);
        var braces = tail.IndexOf('{');
        var flags = (braces >= 0 ? tail.Substring(tail.IndexOf('}')) : tail).Split(' ');
        return new ApiMember(name, parameters, parameters.Length)
        {
            IsStatic = flags.Contains("static") || (kind == 'F' && equals >= 0),
            IsProtected = flags.Contains("protected"),
            IsAbstract = flags.Contains("abstract"),
            IsVirtual = flags.Contains("virtual") || flags.Contains("override") || flags.Contains("abstract"),
            CanRead = kind != 'P' || tail.Contains("get;"),
            CanWrite = kind != 'P' || tail.Contains("set;"),
            Returns = Canonical.OfList(tail.Split(' ')[0]),
            Value = equals < 0 ? null : tail.Substring(equals + 3),
        };
    }
}
