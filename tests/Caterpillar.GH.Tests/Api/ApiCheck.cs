using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Mono.Cecil;

namespace Caterpillar.GH.Tests.Api;

/// <summary>
/// Compares assemblies with the lists of the public API. Of the stand-ins: every type, base, member, constant and enum value. Of the plug-in: every reference,
/// every override, and that everything abstract is implemented.
/// </summary>
internal sealed class ApiCheck(ApiList exact, ApiList documented, ApiList stubs, AllowList allow)
{
    // Generic classes are absent from the stubs; these derive from them and repeat their members.
    private static readonly Dictionary<string, string> Evidence = new(StringComparer.Ordinal)
    {
        ["Grasshopper.Kernel.GH_Param`1"] = "Grasshopper.Kernel.Parameters.Param_Number",
        ["Grasshopper.Kernel.GH_PersistentParam`1"] = "Grasshopper.Kernel.Parameters.Param_Number",
        ["Grasshopper.Kernel.GH_PersistentGeometryParam`1"] = "Grasshopper.Kernel.Parameters.Param_Curve",
    };

    private readonly SortedSet<string> _problems = new(StringComparer.Ordinal);

    public IReadOnlyCollection<string> Problems => _problems;

    /// <summary>The members that were found, by what shows that they exist.</summary>
    public SortedDictionary<string, HashSet<string>> Found { get; } = new(StringComparer.Ordinal);

    public static bool IsHost(IMetadataScope? scope) => scope is not null && IsHostName(scope.Name);

    /// <summary>Everything that an assembly of the host shows.</summary>
    public void CheckHost(ModuleDefinition host)
    {
        foreach (var type in host.GetTypes().Where(Visible))
        {
            var name = Canonical.Name(type);
            if (!Known(name))
            {
                _problems.Add($"The type {name} does not exist.");
                continue;
            }
            CheckBases(type, name);
            if (type.BaseType?.FullName == "System.MulticastDelegate") continue;
            foreach (var field in type.Fields.Where(f => f.IsPublic || f.IsFamily || f.IsFamilyOrAssembly)) CheckField(type, field);
            // What overrides is checked where it is declared.
            foreach (var method in type.Methods.Where(m => (m.IsPublic || m.IsFamily || m.IsFamilyOrAssembly)
                && (!m.IsVirtual || m.IsNewSlot))) CheckMethod(name, method, host);
            CheckAbstract(type, name);
        }
    }

    /// <summary>Everything that the plug-in takes from the host.</summary>
    public void CheckPlugin(ModuleDefinition plugin)
    {
        foreach (var reference in plugin.GetTypeReferences().Where(t => IsHost(t.Scope)))
        {
            var name = Canonical.Name(reference);
            if (!Known(name)) _problems.Add($"The type {name} does not exist.");
        }
        foreach (var reference in plugin.GetMemberReferences().Where(m => IsHost(Definition(m.DeclaringType).Scope)))
        {
            if (reference is MethodReference method) CheckMethod(Canonical.Name(method.DeclaringType), Resolved(method) ?? method, plugin);
            else if (reference is FieldReference field && field.Resolve() is null
                && !Known(Canonical.Name(field.DeclaringType), field.Name)) _problems.Add($"{field.FullName} does not exist.");
        }
        foreach (var type in plugin.GetTypes().Where(t => t.IsClass)) CheckType(type);
    }

    private void CheckType(TypeDefinition type)
    {
        var bases = Ancestors(type).ToList();
        if (!bases.Any(b => IsHost(b.Scope)) && !type.Interfaces.Any(i => IsHost(i.InterfaceType.Scope))) return;
        foreach (var method in type.Methods.Where(m => m.IsVirtual && !m.IsNewSlot)) CheckOverride(type, method, bases);
        if (type.IsAbstract) return;
        foreach (var fact in allow.Abstract)
        {
            var dot = fact.LastIndexOf('.');
            if (!bases.Any(b => Canonical.Name(b) == fact.Substring(0, dot))) continue;
            allow.Used.Add(fact);
            if (!Implements(Below(type, fact.Substring(0, dot)), fact.Substring(dot + 1))) _problems.Add($"{type.FullName} does not implement {fact}.");
        }
        foreach (var contract in Chain(type).SelectMany(t => t.Interfaces).Select(i => i.InterfaceType).Where(i => IsHost(i.Scope)))
        {
            var name = Canonical.Name(contract);
            if (!stubs.Types.TryGetValue(name, out var list) && !exact.Types.TryGetValue(name, out list)) continue;
            foreach (var member in list.Members.Where(m => !Implements(Chain(type), m.Name)))
                _problems.Add($"{type.FullName} does not implement {name}.{member.Name}.");
        }
    }

    private void CheckOverride(TypeDefinition type, MethodDefinition method, List<TypeReference> bases)
    {
        foreach (var ancestor in bases.Where(b => IsHost(Definition(b).Scope)))
        {
            var definition = ancestor.Resolve();
            var overridden = definition?.Methods.FirstOrDefault(m => m.IsVirtual && m.Name == method.Name && m.Parameters.Count == method.Parameters.Count);
            if (overridden is null) continue;
            if (overridden.IsPublic != method.IsPublic) _problems.Add($"{type.FullName}.{method.Name} changes the accessibility of what it overrides.");
            CheckMethod(Canonical.Name(definition!), overridden, definition!.Module);
            return;
        }
        if (bases.Any(b => !IsHost(Definition(b).Scope) && b.Resolve() is { } own && own.Methods.Any(m => m.Name == method.Name))) return;
        if (method.Name is "ToString" or "Equals" or "GetHashCode" or "Finalize") return;
        _problems.Add($"{type.FullName}.{method.Name} overrides nothing.");
    }

    private void CheckMethod(string owner, MethodReference method, ModuleDefinition module)
    {
        var definition = method as MethodDefinition;
        // Constructor and Invoke of a delegate follow from its type.
        if (definition?.DeclaringType.BaseType?.FullName == "System.MulticastDelegate" && Known(owner)) return;
        if (definition is { IsGetter: false, IsSetter: false, IsSpecialName: true } && definition.Name.StartsWith("add_", StringComparison.Ordinal)) return;
        var (name, access) = Split(method);
        var parameters = method.Parameters.Select(p => Canonical.Of(p.ParameterType)).ToArray();
        if (access == 's') parameters = parameters.Take(parameters.Length - 1).ToArray();
        var text = $"{owner}.{name}({string.Join(",", parameters)})";
        var isStatic = definition?.IsStatic ?? !method.HasThis;
        var isPublic = definition?.IsPublic ?? true;
        if (owner.StartsWith("Grasshopper.", StringComparison.Ordinal)) CheckGrasshopper(owner, name, parameters, access, isStatic, isPublic, definition, text);
        else CheckExact(owner, name, parameters, access, isStatic, isPublic, definition, method, text);
    }

    private void CheckExact(
        string owner, string name, string[] parameters, char access, bool isStatic, bool isPublic, MethodDefinition? definition, MethodReference method,
            string text)
    {
        var member = Line(exact, owner).SelectMany(t => t.Members).FirstOrDefault(m => m.Name == name && m.Parameters!.SequenceEqual(parameters));
        if (member is null)
        {
            if (IsObject(name, parameters)) return;
            // A struct's parameterless constructor is not in metadata; of an interface, the members of its bases are.
            if (!allow.Allows(isPublic ? allow.Public : allow.Protected, text)) _problems.Add($"{text} does not exist.");
            else Shows("a fact with its source", text);
            return;
        }
        Shows("metadata", text);
        if (member.IsStatic != isStatic) _problems.Add($"{text} is {(member.IsStatic ? "" : "not ")}static.");
        if (isPublic && member.IsProtected) _problems.Add($"{text} is protected.");
        if (access == 's' && !member.CanWrite) _problems.Add($"{text} can't be set.");
        if (access == 'g' && !member.CanRead) _problems.Add($"{text} can't be read.");
        var returns = access == 's' ? null : Canonical.Of(method.ReturnType);
        if (name != "#ctor" && returns is not null && member.Returns is not null
            && member.Returns != returns) _problems.Add($"{text} returns {member.Returns}, not {returns}.");
        if (definition is { IsVirtual: true, IsFinal: false, IsNewSlot: true } && !definition.DeclaringType.IsInterface
            && !member.IsVirtual) _problems.Add($"{text} is not virtual.");
    }

    private void CheckGrasshopper(
        string owner, string name, string[] parameters, char access, bool isStatic, bool isPublic, MethodDefinition? definition, string text)
    {
        if (allow.Allows(isPublic ? allow.Public : allow.Protected, text))
        {
            Shows("a fact with its source", text);
            return;
        }
        if (IsObject(name, parameters)) return;
        var inDocumentation = documented.Types.TryGetValue(owner, out var documentedType)
            && documentedType.Members.Any(m => m.Name == name && m.Parameters!.SequenceEqual(parameters));
        var shown = stubs.Types.TryGetValue(Evidence.TryGetValue(owner, out var evidence) ? evidence : owner, out var stub);
        var byReference = parameters.Count(p => p.EndsWith("@", StringComparison.Ordinal));
        var same = stub?.Members.Where(m => m.Name == name && m.Count <= parameters.Length && m.Count >= parameters.Length - byReference).ToList() ?? [];
        // A member of the documentation may have other parameters in another overload: then its types are known and must agree.
        var typed = documentedType?.Members.Where(m => m.Name == name && m.Count == parameters.Length).ToList() ?? [];
        // Implements an interface that has it.
        if (definition is { IsFinal: true, IsVirtual: true }
            && definition.DeclaringType.Interfaces.Any(i => Known(Canonical.Name(i.InterfaceType), name))) return;
        if (!inDocumentation && (same.Count == 0 || typed.Count >= same.Select(m => m.Count).Count() && typed.Count > 0))
        {
            _problems.Add($"{text} does not exist.");
            return;
        }
        Shows(!inDocumentation ? "stubs" : same.Count > 0 ? "documentation and stubs" : "documentation", text);
        if (isPublic && shown && evidence is null && same.Count == 0
            && !(definition?.DeclaringType.IsInterface ?? false)) _problems.Add($"{text} is not public.");
        if (!isPublic && same.Count > 0 && name != "#ctor") _problems.Add($"{text} is public.");
        if (same.Count > 0 && name != "#ctor" && same.All(m => m.IsStatic != isStatic)) _problems.Add($"{text} is {(isStatic ? "not " : "")}static.");
        if (access == 's' && same.Count > 0 && same.All(m => !m.CanWrite)) _problems.Add($"{text} can't be set.");
        if (access == 'g' && same.Count > 0 && same.All(m => !m.CanRead)) _problems.Add($"{text} can't be read.");
    }

    private void Shows(string source, string text)
    {
        if (!Found.TryGetValue(source, out var members)) Found.Add(source, members = new HashSet<string>(StringComparer.Ordinal));
        members.Add(text);
    }

    private void CheckField(TypeDefinition type, FieldDefinition field)
    {
        if (field.Name == "value__") return;
        var owner = Canonical.Name(type);
        var lists = owner.StartsWith("Grasshopper.", StringComparison.Ordinal) ? new[] { stubs, documented } : [exact];
        var members = lists.SelectMany(l => Line(l, owner)).SelectMany(t => t.Members).Where(m => m.Name == field.Name).ToList();
        var text = $"{owner}.{field.Name}";
        if (members.Count == 0 && !allow.Allows(field.IsPublic ? allow.Public : allow.Protected, text)) _problems.Add($"{text} does not exist.");
        if (members.FirstOrDefault(m => m.Value is not null) is { Value: { } value } && field.HasConstant && !SameValue(value, field.Constant))
            _problems.Add($"{text} is {value}, not {Convert.ToString(field.Constant, CultureInfo.InvariantCulture)}.");
    }

    private void CheckBases(TypeDefinition type, string name)
    {
        var list = name.StartsWith("Grasshopper.", StringComparison.Ordinal) ? stubs : exact;
        var claimed = type.Interfaces.Select(i => i.InterfaceType).Where(i => !IsHost(i.Scope) && i is not TypeDefinition || i.Resolve() is { IsPublic: true })
            .ToList();
        if (type.BaseType is not null) claimed.Add(type.BaseType);
        var above = Above(list, name);
        foreach (var parent in claimed)
        {
            var parentName = Canonical.Of(parent);
            if (parentName is "System.Object" or "System.ValueType" or "System.Enum" or "System.MulticastDelegate"
                or "System.Collections.IEnumerable") continue;
            if (!above.Contains(parentName)) _problems.Add($"{name} is not known to be a {parentName}.");
        }
        if (exact.Types.TryGetValue(name, out var known))
        {
            if (type.IsInterface != known.IsInterface) _problems.Add($"{name} is {(known.IsInterface ? "an" : "no")} interface.");
            if (known.IsAbstract && !type.IsAbstract) _problems.Add($"{name} is abstract.");
            if (known.IsSealed && !type.IsSealed) _problems.Add($"{name} is sealed.");
        }
    }

    private void CheckAbstract(TypeDefinition type, string name)
    {
        if (type.IsInterface || !name.StartsWith("Grasshopper.", StringComparison.Ordinal)) return;
        foreach (var method in type.Methods.Where(m => m.IsAbstract))
        {
            var fact = $"{name}.{Split(method).Name}";
            if (!allow.Allows(allow.Abstract, fact)) _problems.Add($"{fact} is not known to be abstract.");
        }
    }

    private bool Known(string type) => exact.Types.ContainsKey(type) || documented.Types.ContainsKey(type) || stubs.Types.ContainsKey(type)
        || allow.Allows(allow.Public, type);

    private bool Known(string type, string member) => type.StartsWith("System.", StringComparison.Ordinal)
        || new[] { exact, documented, stubs }.SelectMany(l => Line(l, type)).SelectMany(t => t.Members).Any(m => m.Name == member);

    // Everything a type is known to be, from a list and from the facts.
    private HashSet<string> Above(ApiList list, string name)
    {
        var above = new HashSet<string>(StringComparer.Ordinal);
        var open = new Queue<string>([name]);
        while (open.Count > 0)
        {
            var current = open.Dequeue();
            var bases = list.Types.TryGetValue(current, out var type) ? type.Bases.Select(b => list == stubs ? FullName(b) : b).ToList() : [];
            foreach (var fact in allow.Bases.Where(f => f.StartsWith(current + " : ", StringComparison.Ordinal)))
            {
                allow.Used.Add(fact);
                bases.Add(fact.Substring(current.Length + 3));
            }
            foreach (var parent in bases.Where(above.Add)) open.Enqueue(Open(parent));
        }
        return above;
    }

    // Stubs give bases without their namespace.
    private string FullName(string name) => stubs.Types.Keys.FirstOrDefault(k => k.EndsWith("." + name, StringComparison.Ordinal)) ?? name;

    // A type of a list and, as far as the list names them, its bases.
    private static IEnumerable<ApiType> Line(ApiList list, string name)
    {
        if (!list.Types.TryGetValue(name, out var type)) yield break;
        yield return type;
        foreach (var parent in type.Bases.Select(b => list.Types.ContainsKey(b) ? b : Open(b)))
        {
            foreach (var above in Line(list, parent)) yield return above;
        }
    }

    // List{*} is found under List`1.
    private static string Open(string type)
    {
        var brace = type.IndexOf('{');
        return brace < 0 ? type : type.Substring(0, brace) + "`" + ListReader.Split(type.Substring(brace + 1, type.Length - brace - 2)).Count();
    }

    private static (string Name, char Access) Split(MethodReference method) => method.Name switch
    {
        ".ctor" => ("#ctor", ' '),
        var n when n.StartsWith("get_", StringComparison.Ordinal) => (n.Substring(4), 'g'),
        var n when n.StartsWith("set_", StringComparison.Ordinal) => (n.Substring(4), 's'),
        var n => (n, ' '),
    };

    private static bool IsObject(string name, string[] parameters)
        => (name is "ToString" or "GetHashCode" or "#ctor" && parameters.Length == 0) || (name == "Equals" && parameters.Length == 1);

    private static bool SameValue(string listed, object constant)
    {
        if (constant is double or float)
            return double.TryParse(listed, NumberStyles.Float, CultureInfo.InvariantCulture, out var number)
                && number == Convert.ToDouble(constant, CultureInfo.InvariantCulture);
        return listed == Convert.ToString(constant, CultureInfo.InvariantCulture);
    }

    private static bool Implements(IEnumerable<TypeDefinition> types, string member) => types.SelectMany(t => t.Methods).Any(m => !m.IsAbstract
        && (m.Name == member || m.Name == "get_" + member || m.Name == "set_" + member || m.Name.EndsWith("." + member, StringComparison.Ordinal)));

    // The type and those of its bases that are ours: the host's own do not count as an implementation.
    private static IEnumerable<TypeDefinition> Chain(TypeDefinition type)
    {
        for (TypeDefinition? t = type; t is not null && !IsHostName(t.Module.Assembly.Name.Name); t = t.BaseType is null
            || IsHost(Definition(t.BaseType).Scope) ? null : t.BaseType.Resolve())
            yield return t;
    }

    // The type and its bases up to the one that declares something abstract.
    private static IEnumerable<TypeDefinition> Below(TypeDefinition type, string declaring)
    {
        for (TypeDefinition? t = type; t is not null && Canonical.Name(t) != declaring; t = t.BaseType?.Resolve()) yield return t;
    }

    private static IEnumerable<TypeReference> Ancestors(TypeDefinition type)
    {
        for (var parent = type.BaseType; parent is not null; parent = parent.Resolve()?.BaseType)
            yield return parent.GetElementType();
    }

    private static TypeReference Definition(TypeReference type) => type.GetElementType();

    private static MethodDefinition? Resolved(MethodReference method)
    {
        try
        {
            return method.Resolve();
        }
        catch (AssemblyResolutionException)
        {
            return null;
        }
    }

    private static bool Visible(TypeDefinition type)
        => type.DeclaringType is null ? type.IsPublic : (type.IsNestedPublic || type.IsNestedFamily) && Visible(type.DeclaringType);

    private static bool IsHostName(string name) => name is "RhinoCommon" or "Grasshopper" or "GH_IO" or "RhinoCommon.dll" or "Grasshopper.dll" or "GH_IO.dll";
}
