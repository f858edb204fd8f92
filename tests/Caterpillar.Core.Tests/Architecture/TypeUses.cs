using System.Collections.Generic;
using System.Linq;
using Mono.Cecil;
using Mono.Cecil.Cil;

namespace Caterpillar.Tests.Architecture;

/// <summary>The types that a type uses: bases, interfaces, fields, signatures, and whatever its method bodies name.</summary>
internal static class TypeUses
{
    public static IEnumerable<(TypeReference Used, string Where)> Of(TypeDefinition type)
        => References(type).SelectMany(r => Parts(r.Used).Select(part => (part, r.Where)));

    private static IEnumerable<(TypeReference? Used, string Where)> References(TypeDefinition type)
    {
        yield return (type.BaseType, type.FullName);
        foreach (var contract in type.Interfaces) yield return (contract.InterfaceType, type.FullName);
        foreach (var field in type.Fields) yield return (field.FieldType, field.FullName);
        foreach (var method in type.Methods)
        {
            yield return (method.ReturnType, method.FullName);
            foreach (var parameter in method.Parameters) yield return (parameter.ParameterType, method.FullName);
            if (!method.HasBody) continue;
            foreach (var local in method.Body.Variables) yield return (local.VariableType, method.FullName);
            foreach (var used in method.Body.Instructions.SelectMany(Named)) yield return (used, method.FullName);
        }
    }

    private static IEnumerable<TypeReference?> Named(Instruction instruction)
    {
        switch (instruction.Operand)
        {
            case TypeReference used:
                yield return used;
                break;
            case GenericInstanceMethod called:
                foreach (var argument in called.GenericArguments) yield return argument;
                yield return called.DeclaringType;
                yield return called.ReturnType;
                break;
            case MethodReference called:
                yield return called.DeclaringType;
                yield return called.ReturnType;
                break;
            case FieldReference field:
                yield return field.DeclaringType;
                break;
        }
    }

    private static IEnumerable<TypeReference> Parts(TypeReference? type)
    {
        if (type is null) yield break;
        if (type is GenericInstanceType generic)
        {
            foreach (var part in generic.GenericArguments.SelectMany(Parts)) yield return part;
        }
        if (type is TypeSpecification specification)
        {
            foreach (var part in Parts(specification.ElementType)) yield return part;
            yield break;
        }
        yield return type;
    }
}
