using System.Linq;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Grasshopper.Kernel;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Recorded;

public sealed class PromptTests
{
    [Test]
    public void A_profile_can_be_set_by_its_name_on_the_command_line()
    {
        var param = new OpenPrinterParam();
        Rhino.Input.RhinoGet.Answers.Clear();
        Assert.That(param.Ask(), Is.EqualTo((GH_GetterResult.cancel, (string?)null)));
        Rhino.Input.RhinoGet.Answers.Enqueue("no such printer");
        Assert.That(param.Ask().Result, Is.EqualTo(GH_GetterResult.cancel));
        Rhino.Input.RhinoGet.Answers.Enqueue(" ender3 ");
        Assert.That(param.Ask(), Is.EqualTo((GH_GetterResult.success, (string?)"ender3")));
        foreach (var answer in new[] { "generic", "ender3", "" }) Rhino.Input.RhinoGet.Answers.Enqueue(answer);
        Assert.That(param.AskAll(), Is.EqualTo(new[] { "generic", "ender3" }));
    }

    private sealed class OpenPrinterParam() : StoredParam<PrinterGoo>("Printer", "P", "Printers.", "Setup")
    {
        public override System.Guid ComponentGuid => new("4b0cbb57-8f4e-4a3a-9c31-6f1d8f2f4b01");

        public (GH_GetterResult Result, string? Name) Ask()
        {
            var value = new PrinterGoo();
            var result = Prompt_Singular(ref value);
            return (result, value.Value?.Name);
        }

        public string[] AskAll()
        {
            var values = new System.Collections.Generic.List<PrinterGoo>();
            Prompt_Plural(ref values);
            return values.Select(v => v.Value.Name).ToArray();
        }
    }
}
