using System;
using System.Linq;
using Mono.Cecil;
using Mono.Cecil.Cil;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Api;

/// <summary>The check finds what would fail in Rhino: it is tested with assemblies that have one error each.</summary>
public sealed class ApiCheckProofTests
{
    private const TypeAttributes Public = TypeAttributes.Public | TypeAttributes.Class;

    [Test]
    public void An_enum_value_that_differs()
    {
        Assert.That(Host("RhinoCommon", m => Enum(m, "Rhino", "UnitSystem", ("Millimeters", 3))),
            Is.EqualTo(new[] { "Rhino.UnitSystem.Millimeters is 2, not 3." }));
        Assert.That(Host("Grasshopper", m => Enum(m, "Grasshopper.Kernel", "GH_ParamAccess", ("list", 1), ("tree", 7))),
            Is.EqualTo(new[] { "Grasshopper.Kernel.GH_ParamAccess.tree is 2, not 7." }));
        Assert.That(Host("Grasshopper", m => Enum(m, "Grasshopper.Kernel", "GH_ParamAccess", ("forest", 3))),
            Is.EqualTo(new[] { "Grasshopper.Kernel.GH_ParamAccess.forest does not exist." }));
    }

    [Test]
    public void A_constant_that_differs() => Assert.That(Host("RhinoCommon", m =>
    {
        var type = Class(m, "Rhino", "RhinoMath");
        type.Fields.Add(new FieldDefinition("ZeroTolerance", FieldAttributes.Public | FieldAttributes.Static | FieldAttributes.Literal,
            m.TypeSystem.Double) { Constant = 1e-12 });
    }), Has.One.StartsWith("Rhino.RhinoMath.ZeroTolerance is 2.3283064365386963E-10, not 1E-12"));

    [TestCase("RhinoCommon", "Rhino", "NoSuchType")]
    [TestCase("Grasshopper", "Grasshopper.Kernel", "GH_NoSuchType")]
    public void A_type_that_does_not_exist(string assembly, string space, string name)
        => Assert.That(Host(assembly, m => Class(m, space, name)), Is.EqualTo(new[] { $"The type {space}.{name} does not exist." }));

    [TestCase("RhinoCommon", "Rhino", "RhinoDoc", "Vanish")]
    [TestCase("GH_IO", "GH_IO.Serialization", "GH_Archive", "Vanish")]
    [TestCase("Grasshopper", "Grasshopper.Kernel", "GH_Document", "Vanish")]
    public void A_method_that_does_not_exist(string assembly, string space, string name, string method)
        => Assert.That(Host(assembly, m => Method(Class(m, space, name), method, MethodAttributes.Public)),
            Has.Member($"{space}.{name}.{method}() does not exist."));

    [TestCase("RhinoCommon", "Rhino", "RhinoDoc", "EndUndoRecord")]
    [TestCase("Grasshopper", "Grasshopper.Kernel", "GH_Document", "ScheduleSolution")]
    public void A_method_with_other_parameters(string assembly, string space, string name, string method)
        => Assert.That(Host(assembly, m => Method(Class(m, space, name), method, MethodAttributes.Public, m.TypeSystem.String)),
            Has.Member($"{space}.{name}.{method}(System.String) does not exist."));

    [Test]
    public void A_method_that_is_static_elsewhere()
    {
        Assert.That(Host("Grasshopper",
            m => Method(Class(m, "Grasshopper.Kernel", "GH_Document"), "IsEscapeKeyDown", MethodAttributes.Public, returns: m.TypeSystem.Boolean)),
            Is.EqualTo(new[] { "Grasshopper.Kernel.GH_Document.IsEscapeKeyDown() is static." }));
        Assert.That(Host("RhinoCommon",
            m => Method(Class(m, "Rhino.Geometry", "Mesh"), "Compact", MethodAttributes.Public | MethodAttributes.Static, returns: m.TypeSystem.Boolean)),
            Has.Member("Rhino.Geometry.Mesh.Compact() is not static."));
    }

    [Test]
    public void A_method_that_returns_something_else()
        => Assert.That(Host("RhinoCommon", m => Method(Class(m, "Rhino.Geometry", "Mesh"), "Compact", MethodAttributes.Public, returns: m.TypeSystem.Int32)),
            Has.Member("Rhino.Geometry.Mesh.Compact() returns System.Boolean, not System.Int32."));

    [Test]
    public void A_protected_member_shown_as_public()
    {
        Assert.That(Host("Grasshopper", m => Method(Class(m, "Grasshopper.Kernel", "GH_Component"), "BeforeSolveInstance", MethodAttributes.Public)),
            Has.Member("Grasshopper.Kernel.GH_Component.BeforeSolveInstance() is not public."));
        Assert.That(Host("RhinoCommon",
            m => Method(Class(m, "Rhino.Geometry", "SpaceMorph"), ".ctor",
            MethodAttributes.Public | MethodAttributes.SpecialName | MethodAttributes.RTSpecialName)),
            Has.Member("Rhino.Geometry.SpaceMorph.#ctor() is protected."));
    }

    [Test]
    public void A_public_member_shown_as_protected()
        => Assert.That(Host("Grasshopper",
            m => Method(Class(m, "Grasshopper.Kernel", "GH_Component"), "CreateAttributes",
            MethodAttributes.Family | MethodAttributes.Virtual | MethodAttributes.NewSlot)),
            Has.Member("Grasshopper.Kernel.GH_Component.CreateAttributes() is public."));

    [Test]
    public void A_property_that_can_not_be_set()
    {
        Assert.That(Host("RhinoCommon",
            m => Method(Class(m, "Rhino.Geometry", "Mesh"), "set_IsClosed", MethodAttributes.Public | MethodAttributes.SpecialName, m.TypeSystem.Boolean)),
            Has.Member("Rhino.Geometry.Mesh.IsClosed() can't be set."));
        Assert.That(Host("Grasshopper",
            m => Method(Class(m, "Grasshopper.Kernel", "GH_Document"), "set_ObjectCount", MethodAttributes.Public | MethodAttributes.SpecialName,
            m.TypeSystem.Int32)),
            Has.Member("Grasshopper.Kernel.GH_Document.ObjectCount() can't be set."));
    }

    [Test]
    public void A_base_that_is_another()
        => Assert.That(Host("RhinoCommon",
            m => m.Types.Add(new TypeDefinition("Rhino.Geometry", "Mesh", Public, m.ImportReference(typeof(System.IO.MemoryStream))))),
            Has.Member("Rhino.Geometry.Mesh is not known to be a System.IO.MemoryStream."));

    [Test]
    public void The_plug_in_calls_what_does_not_exist() => Assert.That(Plugin(m =>
    {
        var document = m.ImportReference(Host("Grasshopper").GetType("Grasshopper.Kernel.GH_Document"));
        var il = Method(Class(m, "Test", "Caller"), "Call", MethodAttributes.Public | MethodAttributes.Static).Body.GetILProcessor();
        il.Emit(OpCodes.Ldnull);
        il.Emit(OpCodes.Call, new MethodReference("Vanish", m.TypeSystem.Void, document) { HasThis = true });
        il.Emit(OpCodes.Ret);
    }), Has.Member("Grasshopper.Kernel.GH_Document.Vanish() does not exist."));

    [Test]
    public void The_plug_in_leaves_something_abstract()
    {
        var problems = Plugin(m => m.Types.Add(new TypeDefinition("Test", "Half", Public,
            m.ImportReference(Host("Grasshopper").GetType("Grasshopper.Kernel.GH_Component")))));
        Assert.That(problems, Has.Member("Test.Half does not implement Grasshopper.Kernel.GH_Component.SolveInstance.")
            .And.Member("Test.Half does not implement Grasshopper.Kernel.GH_DocumentObject.ComponentGuid."));
    }

    [Test]
    public void The_plug_in_leaves_out_a_member_of_an_interface()
    {
        var problems = Plugin(m =>
        {
            var type = Class(m, "Test", "Drawn");
            type.Interfaces.Add(new InterfaceImplementation(m.ImportReference(Host("Grasshopper").GetType("Grasshopper.Kernel.IGH_PreviewData"))));
            Method(type, "get_ClippingBox", MethodAttributes.Public | MethodAttributes.Virtual | MethodAttributes.NewSlot);
        });
        Assert.That(problems, Is.EqualTo(new[]
        {
            "Test.Drawn does not implement Grasshopper.Kernel.IGH_PreviewData.DrawViewportMeshes.",
                "Test.Drawn does not implement Grasshopper.Kernel.IGH_PreviewData.DrawViewportWires.",
        }));
    }

    [Test]
    public void The_plug_in_overrides_nothing_or_with_another_accessibility()
    {
        var problems = Plugin(m =>
        {
            var type = new TypeDefinition("Test", "Odd", Public | TypeAttributes.Abstract,
                m.ImportReference(Host("Grasshopper").GetType("Grasshopper.Kernel.GH_Component")));
            m.Types.Add(type);
            Method(type, "Vanish", MethodAttributes.Public | MethodAttributes.Virtual);
            Method(type, "BeforeSolveInstance", MethodAttributes.Public | MethodAttributes.Virtual);
        });
        Assert.That(problems, Is.EqualTo(new[] { "Test.Odd.BeforeSolveInstance changes the accessibility of what it overrides.",
            "Test.Odd.Vanish overrides nothing." }));
    }

    [Test]
    public void Every_fact_of_the_allow_list_is_used()
    {
        var allow = ApiFixture.Allow();
        var check = ApiFixture.Check(allow);
        foreach (var assembly in new[] { "RhinoCommon", "GH_IO", "Grasshopper" }) check.CheckHost(Host(assembly));
        check.CheckPlugin(Host("Caterpillar.GH"));
        var all = allow.Public.Concat(allow.Protected).Concat(allow.Bases).Concat(allow.Abstract);
        Assert.That(all.Where(fact => !allow.Used.Contains(fact)), Is.Empty);
    }

    private static string[] Host(string name, Action<ModuleDefinition> fill)
    {
        using var module = ModuleDefinition.CreateModule(name + ".dll",
            new ModuleParameters { Kind = ModuleKind.Dll, AssemblyResolver = new DefaultAssemblyResolver() });
        fill(module);
        var check = ApiFixture.Check();
        check.CheckHost(module);
        return check.Problems.ToArray();
    }

    private static string[] Plugin(Action<ModuleDefinition> fill)
    {
        var resolver = new DefaultAssemblyResolver();
        resolver.AddSearchDirectory(TestContext.CurrentContext.TestDirectory);
        using var module = ModuleDefinition.CreateModule("Test.dll", new ModuleParameters { Kind = ModuleKind.Dll, AssemblyResolver = resolver });
        fill(module);
        using var memory = new System.IO.MemoryStream();
        module.Write(memory);
        memory.Position = 0;
        using var read = ModuleDefinition.ReadModule(memory, new ReaderParameters { AssemblyResolver = resolver });
        var check = ApiFixture.Check();
        check.CheckPlugin(read);
        return check.Problems.ToArray();
    }

    private static ModuleDefinition Host(string name) => ApiFixture.Open(name);

    private static TypeDefinition Class(ModuleDefinition module, string space, string name)
    {
        var type = new TypeDefinition(space, name, Public | (name == "SpaceMorph" ? TypeAttributes.Abstract : 0), module.TypeSystem.Object);
        module.Types.Add(type);
        return type;
    }

    private static MethodDefinition Method(TypeDefinition type, string name, MethodAttributes attributes, TypeReference? parameter = null,
        TypeReference? returns = null)
    {
        var method = new MethodDefinition(name, attributes, returns ?? type.Module.TypeSystem.Void) { HasThis = (attributes & MethodAttributes.Static) == 0 };
        if (parameter is not null) method.Parameters.Add(new ParameterDefinition(parameter));
        if (name.StartsWith("set_", StringComparison.Ordinal)) method.IsSetter = true;
        type.Methods.Add(method);
        return method;
    }

    private static void Enum(ModuleDefinition module, string space, string name, params (string Name, int Value)[] values)
    {
        var type = new TypeDefinition(space, name, TypeAttributes.Public | TypeAttributes.Sealed, module.ImportReference(typeof(System.Enum)));
        type.Fields.Add(new FieldDefinition("value__", FieldAttributes.Public | FieldAttributes.SpecialName | FieldAttributes.RTSpecialName,
            module.TypeSystem.Int32));
        foreach (var value in values)
            type.Fields.Add(new FieldDefinition(value.Name, FieldAttributes.Public | FieldAttributes.Static | FieldAttributes.Literal,
                type) { Constant = value.Value });
        module.Types.Add(type);
    }
}
