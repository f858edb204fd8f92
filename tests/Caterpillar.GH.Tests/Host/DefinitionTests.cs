using System;
using System.IO;
using System.Linq;
using System.Text;
using System.Xml;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Plugin;
using GH_IO.Serialization;
using Grasshopper;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Host;

/// <summary>A definition with components of the plug-in is saved as .ghx, opened again, and gives the same.</summary>
[Category("Host")]
public sealed class DefinitionTests
{
    private const string Program = "M83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 Y10 E0.5 F1200\n";

    [SetUp]
    public void SetUp() => Instances.ComponentServer.Load(typeof(PluginInfo).Assembly);

    private static GH_Document Make()
    {
        var document = new GH_Document();
        var text = new Param_String { NickName = "G-code" };
        text.SetPersistentData(Program);
        var (decode, printer, write) = (new DecodeGCodeComponent(), new PrinterComponent(), new GenerateGCodeComponent());
        foreach (var item in new IGH_DocumentObject[] { text, decode, printer, write }) document.AddObject(item, false);
        ((Caterpillar.GH.Params.PrinterChoiceParam)printer.Params.Input[0]).SetPersistentData("ender3");
        decode.Params.Input[1].AddSource(text);
        write.Params.Input[0].AddSource(decode.Params.Output[0]);
        write.Params.Input[1].AddSource(printer.Params.Output[0]);
        ((Param_String)write.Params.Input[2]).SetPersistentData("a reason in words");
        decode.Attributes.Pivot = new System.Drawing.PointF(120.5f, 40);
        return document;
    }

    private static string Save(GH_Document document)
    {
        var archive = new GH_Archive();
        Assert.That(archive.AppendObject(document, "Definition"), Is.True);
        return archive.Serialize_Xml();
    }

    private static string Result(GH_Document document)
    {
        document.NewSolution(true);
        var errors = document.Objects.OfType<IGH_ActiveObject>().SelectMany(o => o.RuntimeMessages(GH_RuntimeMessageLevel.Error));
        Assert.That(errors, Is.Empty);
        var output = document.Objects.OfType<GenerateGCodeComponent>().Single().Params.Output[0];
        return Encoding.UTF8.GetString(((Caterpillar.GH.Goos.GCodeGoo)output.VolatileData.get_Branch(0)[0]!).Value.ToBytes());
    }

    [Test]
    public void A_saved_definition_opens_with_its_wires_values_and_places()
    {
        var document = Make();
        var text = Save(document);
        var archive = new GH_Archive();
        archive.Deserialize_Xml(text);
        var copy = new GH_Document();
        Assert.That(archive.ExtractObject(copy, "Definition"), Is.True);
        Assert.That(Result(copy), Is.EqualTo(Result(document)));
        Assert.That(((Param_String)copy.Objects.OfType<GenerateGCodeComponent>().Single().Params.Input[2]).PersistentData.Branches[0][0].Value,
            Is.EqualTo("a reason in words"));
        Assert.That(copy.Objects[1].Attributes.Pivot.X, Is.EqualTo(120.5f));
        Assert.That(Save(copy), Is.EqualTo(text), "Saved again it is the same text.");
    }

    [Test]
    public void The_file_names_its_library_and_its_objects()
    {
        var xml = new XmlDocument();
        xml.LoadXml(Save(Make()));
        string? Item(string path) => xml.SelectSingleNode(path)?.InnerText;
        const string Definition = "/Archive/chunks/chunk[@name='Definition']";
        Assert.That(Item(Definition + "/chunks/chunk[@name='GHALibraries']/chunks/chunk/items/item[@name='Id']"), Is.EqualTo(new PluginInfo().Id.ToString()));
        Assert.That(Item(Definition + "/chunks/chunk[@name='DefinitionObjects']/items/item[@name='ObjectCount']"), Is.EqualTo("4"));
        foreach (XmlElement group in xml.SelectNodes("//items | //chunks")!)
            Assert.That(group.ChildNodes.Count, Is.EqualTo(int.Parse(group.GetAttribute("count"), System.Globalization.CultureInfo.InvariantCulture)));
    }

    [Test]
    public void An_object_of_no_library_is_skipped_and_reported()
    {
        var archive = new GH_Archive();
        archive.Deserialize_Xml(Save(Make()).Replace(new PrinterComponent().ComponentGuid.ToString(), Guid.NewGuid().ToString()));
        var copy = new GH_Document();
        Assert.That(archive.ExtractObject(copy, "Definition"), Is.False);
        Assert.That(copy.ObjectCount, Is.EqualTo(3));
    }
}
