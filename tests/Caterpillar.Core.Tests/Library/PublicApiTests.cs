#if NET
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
using Caterpillar.Basics;
using NUnit.Framework;

namespace Caterpillar.Tests.Library;

/// <summary>
/// Compares the public members of the library with <c>src/Caterpillar.Core/PublicApi.txt</c>, so that no change of them goes unnoticed.
/// <c>CATERPILLAR_RENEW=1</c> writes the file.
/// </summary>
public class PublicApiTests
{
    private const BindingFlags Declared =
        BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

    private static string Listing => Path.Combine(TestData.Repository, "src", "Caterpillar.Core", "PublicApi.txt");

    [Test]
    public void The_public_members_are_those_of_the_listing()
    {
        var actual = typeof(Diagnostic).Assembly.GetExportedTypes().SelectMany(Lines).Distinct().OrderBy(l => l, StringComparer.Ordinal).ToArray();
        if (Environment.GetEnvironmentVariable("CATERPILLAR_RENEW") == "1") File.WriteAllText(Listing, string.Join("\n", actual) + "\n");
        var listed = File.ReadAllLines(Listing);
        Assert.That(actual.Except(listed), Is.Empty, "new members; CATERPILLAR_RENEW=1 adds them to PublicApi.txt");
        Assert.That(listed.Except(actual), Is.Empty, "members that are gone; programs that use them no longer compile");
        Assert.That(listed, Is.EqualTo(actual), "PublicApi.txt is sorted, one line for each member");
    }

    private static IEnumerable<string> Lines(Type type)
    {
        var name = Name(type);
        var kind = type.IsEnum ? "enum" : type.IsInterface ? "interface" : type.IsValueType ? "struct" : typeof(Delegate).IsAssignableFrom(type) ? "delegate"
            : type.IsAbstract && type.IsSealed ? "static class" : type.IsAbstract ? "abstract class" : type.IsSealed ? "sealed class" : "class";
        var bases = new[] { type.BaseType }.Where(b => b is not null && b != typeof(object) && b != typeof(ValueType) && b != typeof(Enum)).Select(b => b!)
            .Concat(type.IsEnum ? [] : type.GetInterfaces().Where(i => i.IsVisible && !IsEquatable(i))).Select(Name).OrderBy(b => b, StringComparer.Ordinal)
                .ToArray();
        yield return $"{name} {kind}" + (bases.Length > 0 ? ": " + string.Join(", ", bases) : "");
        if (typeof(Delegate).IsAssignableFrom(type))
        {
            yield return $"{name} {Signature(type.GetMethod("Invoke")!)}";
            yield break;
        }
        foreach (var member in type.GetMembers(Declared))
        {
            if (Line(member) is { } line) yield return $"{name} {line}";
        }
    }

    private static string? Line(MemberInfo member)
    {
        // What records generate follows from their properties.
        if (member.IsDefined(typeof(CompilerGeneratedAttribute)) || member.Name.Contains('<', StringComparison.Ordinal)) return null;
        switch (member)
        {
            case FieldInfo field when IsSeen(field.Attributes):
                if (field.DeclaringType!.IsEnum) return field.IsLiteral ? $"{field.Name} = {field.GetRawConstantValue()}" : null;
                return $"{(field.IsLiteral ? "const " : field.IsStatic ? "static " : "")}{Name(field.FieldType)} {field.Name}";
            case ConstructorInfo constructor when IsSeen(constructor.Attributes):
                return $"new({Parameters(constructor)})";
            case PropertyInfo property:
                var accessors = property.GetAccessors(true).Where(a => IsSeen(a.Attributes)).ToArray();
                if (accessors.Length == 0) return null;
                var words = accessors.Select(a => a.ReturnType != typeof(void) ? "get;" : IsInit(a) ? "init;" : "set;");
                var index = property.GetIndexParameters();
                return $"{(accessors[0].IsStatic ? "static " : "")}{Name(property.PropertyType)} "
                    + (index.Length > 0 ? $"this[{string.Join(", ", index.Select(Parameter))}]" : property.Name) + $" {{ {string.Join(" ", words)} }}";
            case EventInfo happening when IsSeen(happening.AddMethod!.Attributes):
                return $"event {Name(happening.EventHandlerType!)} {happening.Name}";
            case MethodInfo method when IsSeen(method.Attributes) && (!method.IsSpecialName || method.Name.StartsWith("op_", StringComparison.Ordinal)):
                return Signature(method);
            default:
                return null;
        }
    }

    private static string Signature(MethodInfo method)
    {
        var generic = method.IsGenericMethod ? $"<{string.Join(", ", method.GetGenericArguments().Select(Name))}>" : "";
        return $"{(method.IsStatic ? "static " : "")}{Name(method.ReturnType)} {method.Name}{generic}({Parameters(method)})";
    }

    private static bool IsEquatable(Type type) => type.IsGenericType && type.GetGenericTypeDefinition() == typeof(IEquatable<>);

    private static bool IsInit(MethodInfo setter)
        => setter.ReturnParameter.GetRequiredCustomModifiers().Any(m => m.Name == "IsExternalInit");

    private static bool IsSeen(FieldAttributes attributes)
        => (attributes & FieldAttributes.FieldAccessMask) is FieldAttributes.Public or FieldAttributes.Family or FieldAttributes.FamORAssem;

    private static bool IsSeen(MethodAttributes attributes)
        => (attributes & MethodAttributes.MemberAccessMask) is MethodAttributes.Public or MethodAttributes.Family or MethodAttributes.FamORAssem;

    private static string Parameters(MethodBase method) => string.Join(", ", method.GetParameters().Select(Parameter));

    // Names and defaults count: callers use them.
    private static string Parameter(ParameterInfo parameter)
    {
        var prefix = parameter.IsOut ? "out " : parameter.ParameterType.IsByRef ? (parameter.IsIn ? "in " : "ref ")
            : parameter.IsDefined(typeof(ParamArrayAttribute)) ? "params " : "";
        return $"{prefix}{Name(parameter.ParameterType)} {parameter.Name}{(parameter.HasDefaultValue ? " = " + Default(parameter) : "")}";
    }

    private static string Default(ParameterInfo parameter) => parameter.DefaultValue switch
    {
        null => parameter.ParameterType.IsValueType && Nullable.GetUnderlyingType(parameter.ParameterType) is null ? "default" : "null",
        double number => number.ToString("R", System.Globalization.CultureInfo.InvariantCulture),
        string text => "\"" + text.Replace("\n", "\\n") + "\"",
        bool flag => flag ? "true" : "false",
        var other => Convert.ToString(other, System.Globalization.CultureInfo.InvariantCulture)!,
    };

    private static string Name(Type type)
    {
        if (type.IsByRef) return Name(type.GetElementType()!);
        if (type.IsArray) return Name(type.GetElementType()!) + "[]";
        if (Nullable.GetUnderlyingType(type) is { } inner) return Name(inner) + "?";
        if (type.IsGenericParameter) return type.Name;
        var plain = type.Namespace == "System" ? Keyword(type.Name) : type.Namespace!.StartsWith("Caterpillar", StringComparison.Ordinal) ? type.FullName
            ?? type.Name
            : type.Name;
        if (type.Namespace!.StartsWith("Caterpillar", StringComparison.Ordinal) && type.IsGenericType) plain = type.GetGenericTypeDefinition().FullName!;
        if (plain.StartsWith("Caterpillar.", StringComparison.Ordinal)) plain = plain["Caterpillar.".Length..].Replace('+', '.');
        var tick = plain.IndexOf('`', StringComparison.Ordinal);
        return tick < 0 ? plain : $"{plain[..tick]}<{string.Join(", ", type.GetGenericArguments().Select(Name))}>";
    }

    private static string Keyword(string name) => name switch
    {
        "Void" => "void", "Double" => "double", "Int32" => "int", "Int64" => "long", "Boolean" => "bool", "String" => "string", "Object" => "object",
        "Byte" => "byte", "Char" => "char", "Single" => "float", "UInt32" => "uint", "UInt64" => "ulong", _ => name,
    };
}
#endif
