using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Mono.Cecil;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Api;

/// <summary>
/// Every member of RhinoCommon and GH_IO that the plug-in and the stand-in of Grasshopper refer to, looked up in McNeel's own assemblies as the runtime does.
/// </summary>
[Category("Host")]
public sealed class RealMetadataTests
{
    private static string Real => Path.GetFullPath(Path.Combine(Caterpillar.Tests.TestData.Repository, "..", "shared", "reference", "real"));

    [TestCase("Caterpillar.GH")]
    [TestCase("Grasshopper")]
    public void What_is_referred_to_is_in_the_real_assemblies(string name)
    {
        if (!File.Exists(Path.Combine(Real, "RhinoCommon.dll"))) Assert.Ignore("The real RhinoCommon and GH_IO are not here: shared/reference/real");
        using var resolver = new RealFirst();
        using var module = ModuleDefinition.ReadModule(Path.Combine(TestContext.CurrentContext.TestDirectory, name + ".dll"),
            new ReaderParameters { AssemblyResolver = resolver });
        var counts = new SortedDictionary<string, int>(StringComparer.Ordinal);
        var missing = new List<string>();
        void Look(string scope, string what, bool found)
        {
            counts[scope] = counts.TryGetValue(scope, out var n) ? n + 1 : 1;
            if (!found) missing.Add($"{scope}: {what}");
        }
        foreach (var type in module.GetTypeReferences().Where(t => IsReal(t.Scope.Name))) Look(type.Scope.Name, type.FullName, type.Resolve() is not null);
        foreach (var member in module.GetMemberReferences().Where(m => IsReal(m.DeclaringType.GetElementType().Scope.Name)))
            Look(member.DeclaringType.GetElementType().Scope.Name, member.FullName, member.Resolve() is { } found && IsOpen(found));
        foreach (var count in counts) TestContext.Out.WriteLine($"{name}: {count.Value} types and members of {count.Key}");
        Assert.That(counts, Is.Not.Empty);
        Assert.That(missing, Is.Empty, string.Join("\n", missing));
    }

    private static bool IsReal(string scope) => scope is "RhinoCommon" or "GH_IO";

    private static bool IsOpen(IMemberDefinition member) => member switch
    {
        MethodDefinition method => method.IsPublic || method.IsFamily || method.IsFamilyOrAssembly,
        FieldDefinition field => field.IsPublic || field.IsFamily || field.IsFamilyOrAssembly,
        _ => true,
    };

    private sealed class RealFirst : DefaultAssemblyResolver
    {
        public RealFirst()
        {
            foreach (var folder in GetSearchDirectories()) RemoveSearchDirectory(folder);
            AddSearchDirectory(Real);
            AddSearchDirectory(TestContext.CurrentContext.TestDirectory);
        }
    }
}
