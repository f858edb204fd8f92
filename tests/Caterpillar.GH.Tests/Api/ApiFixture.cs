using System.IO;
using System.Linq;
using Mono.Cecil;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Api;

/// <summary>The lists and the compiled assemblies.</summary>
internal static class ApiFixture
{
    private static readonly string[] Files =
        ["RhinoCommon-7.37.txt.gz", "GH_IO-7.37.txt.gz", "Grasshopper-6-docids.txt.gz", "Grasshopper-8.20-stubs.txt.gz"];

    public static AllowList Allow() => AllowList.Read(Path.Combine(TestFolder, "Api", "allow.txt"));

    public static string TestFolder => Path.Combine(Caterpillar.Tests.TestData.Repository, "tests", "Caterpillar.GH.Tests");

    private static (ApiList Exact, ApiList Documented, ApiList Stubs)? s_lists;

    /// <summary>A check; skips the test where the lists are absent.</summary>
    public static ApiCheck Check(AllowList? allow = null)
    {
        var (exact, documented, stubs) = s_lists ??= Lists();
        return new ApiCheck(exact, documented, stubs, allow ?? Allow());
    }

    public static ModuleDefinition Open(string name)
    {
        var folder = TestContext.CurrentContext.TestDirectory;
        var resolver = new DefaultAssemblyResolver();
        resolver.AddSearchDirectory(folder);
        return ModuleDefinition.ReadModule(Path.Combine(folder, name + ".dll"), new ReaderParameters { AssemblyResolver = resolver });
    }

    private static (ApiList, ApiList, ApiList) Lists()
    {
        var folder = Path.GetFullPath(Path.Combine(Caterpillar.Tests.TestData.Repository, "..", "shared", "reference", "api"));
        if (!Files.All(f => File.Exists(Path.Combine(folder,
            f)))) Assert.Ignore("The lists of Rhino's and Grasshopper's public API are not here: shared/reference/api");
        ApiList exact = new(), documented = new(), stubs = new();
        ListReader.ReadExact(ListReader.Lines(Path.Combine(folder, Files[0])), exact);
        ListReader.ReadExact(ListReader.Lines(Path.Combine(folder, Files[1])), exact);
        ListReader.ReadDocumentation(ListReader.Lines(Path.Combine(folder, Files[2])), documented);
        ListReader.ReadStubs(ListReader.Lines(Path.Combine(folder, Files[3])), stubs);
        return (exact, documented, stubs);
    }
}
