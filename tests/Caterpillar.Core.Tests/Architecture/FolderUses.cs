#if NET
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection.Metadata;
using System.Reflection.Metadata.Ecma335;
using System.Reflection.PortableExecutable;
using Cecil = Mono.Cecil;

namespace Caterpillar.Tests.Architecture;

/// <summary>One use of a type by another, each with the folder of its source file.</summary>
internal readonly record struct FolderUse(string From, string To, string Where, string Used);

/// <summary>Which source folder uses which, read from a compiled assembly and its debug information.</summary>
internal static class FolderUses
{
    // Documents of types that have no method bodies, such as enums (the specification of portable PDBs, "Type Definition Document").
    private static readonly Guid TypeDefinitionDocument = new("932E74BC-DBA9-4478-8D46-0F32A7BAB3D3");

    /// <summary>All uses between types of the assembly, in folders relative to <paramref name="root"/>, with '/' between their parts.</summary>
    public static List<FolderUse> Of(string assemblyFile, string root)
    {
        var folders = Folders(assemblyFile, root);
        using var assembly = Cecil.AssemblyDefinition.ReadAssembly(assemblyFile);
        var uses = new List<FolderUse>();
        foreach (var type in assembly.MainModule.Types.SelectMany(WithNested))
        {
            if (!folders.TryGetValue(Outer(type).MetadataToken.ToInt32(), out var from)) continue;
            foreach (var (used, where) in TypeUses.Of(type))
            {
                if (used.Scope is not Cecil.ModuleDefinition || used.Resolve() is not { } definition) continue;
                if (folders.TryGetValue(Outer(definition).MetadataToken.ToInt32(), out var to)) uses.Add(new FolderUse(from, to, where, definition.FullName));
            }
        }
        return uses;
    }

    /// <summary>The folder of each top-level type, by its metadata token.</summary>
    public static Dictionary<int, string> Folders(string assemblyFile, string root)
    {
        root = Path.GetFullPath(root) + Path.DirectorySeparatorChar;
        using var portable = new PEReader(File.OpenRead(assemblyFile));
        using var symbols = MetadataReaderProvider.FromPortablePdbStream(File.OpenRead(Path.ChangeExtension(assemblyFile, ".pdb")));
        var types = portable.GetMetadataReader();
        var debug = symbols.GetMetadataReader();
        var folders = new Dictionary<int, string>();
        foreach (var handle in types.TypeDefinitions)
        {
            var document = Document(types.GetTypeDefinition(handle), handle, debug);
            if (document.IsNil) continue;
            var file = debug.GetString(debug.GetDocument(document).Name);
            if (!file.StartsWith(root, StringComparison.Ordinal)) continue;
            var outer = handle;
            while (types.GetTypeDefinition(outer).GetDeclaringType() is { IsNil: false } declaring) outer = declaring;
            folders[MetadataTokens.GetToken(outer)] = Path.GetDirectoryName(file.Substring(root.Length))!.Replace(Path.DirectorySeparatorChar, '/');
        }
        return folders;
    }

    private static DocumentHandle Document(TypeDefinition type, TypeDefinitionHandle handle, MetadataReader debug)
    {
        foreach (var information in debug.GetCustomDebugInformation(handle).Select(debug.GetCustomDebugInformation))
        {
            if (debug.GetGuid(information.Kind) != TypeDefinitionDocument) continue;
            return MetadataTokens.DocumentHandle(debug.GetBlobReader(information.Value).ReadCompressedInteger());
        }
        foreach (var method in type.GetMethods())
        {
            var information = debug.GetMethodDebugInformation(method);
            if (!information.Document.IsNil) return information.Document;
            if (!information.SequencePointsBlob.IsNil) return information.GetSequencePoints().First().Document;
        }
        return default;
    }

    private static IEnumerable<Cecil.TypeDefinition> WithNested(Cecil.TypeDefinition type) => new[] { type }.Concat(type.NestedTypes.SelectMany(WithNested));

    private static Cecil.TypeDefinition Outer(Cecil.TypeDefinition type)
    {
        while (type.DeclaringType is not null) type = type.DeclaringType;
        return type;
    }
}
#endif
