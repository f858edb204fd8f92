using System;
using System.Linq;
using Caterpillar.GH.Components.Design;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Obsolete;
using Caterpillar.GH.Plugin;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;
using Grasshopper.Kernel.Special;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Plugin;

/// <summary>Components whose ports changed their order: old definitions keep theirs, and can be upgraded.</summary>
public sealed class UpgradeTests
{
    public static System.Collections.Generic.IEnumerable<Type> Upgrades => typeof(PluginInfo).Assembly.GetTypes()
        .Where(t => !t.IsAbstract && typeof(IGH_UpgradeObject).IsAssignableFrom(t));

    [Test]
    public void Every_obsolete_component_is_hidden_and_has_an_upgrade()
    {
        var from = Upgrades.Select(t => PluginTypes.Make<IGH_UpgradeObject>(t).UpgradeFrom).ToArray();
        Assert.That(PluginTypes.Obsolete, Is.Not.Empty);
        foreach (var old in PluginTypes.Obsolete.Select(PluginTypes.Make<GH_Component>))
        {
            Assert.That(old.Exposure, Is.EqualTo(GH_Exposure.hidden));
            Assert.That(from, Has.Member(old.ComponentGuid));
        }
    }

    [TestCaseSource(nameof(Upgrades))]
    public void An_upgrade_moves_each_port_to_its_namesake(Type type)
    {
        var upgrade = PluginTypes.Make<IGH_UpgradeObject>(type);
        var document = new GH_Document();
        var old = PluginTypes.Make<GH_Component>(PluginTypes.Obsolete.Single(t => PluginTypes.Make<GH_Component>(t).ComponentGuid == upgrade.UpgradeFrom));
        document.AddObject(old, false);
        var ids = old.Params.ToDictionary(p => p.Name + p.Kind, p => p.InstanceGuid);
        var made = (GH_Component)upgrade.Upgrade(old, document)!;
        Assert.That(made.ComponentGuid, Is.EqualTo(upgrade.UpgradeTo));
        foreach (var port in made.Params.Where(p => ids.ContainsKey(p.Name + p.Kind))) Assert.That(port.InstanceGuid, Is.EqualTo(ids[port.Name + port.Kind]));
        Assert.That(upgrade.Upgrade(made, document), Is.Null, "What is up to date stays.");
        Assert.That(upgrade.Version.Year, Is.GreaterThanOrEqualTo(2026));
    }

    [Test]
    public void An_old_turtle_solves_and_gives_the_same_after_its_upgrade()
    {
        var document = new GH_Document();
        var old = new TurtleComponent_OBSOLETE { NickName = "Star", Hidden = true };
        document.AddObject(old, false);
        var script = new Param_String();
        script.SetPersistentData("forward 10; left 90; forward 5");
        var bead = new Param_String();
        bead.SetPersistentData("0.6 x 0.3");
        document.AddObject(script, false);
        document.AddObject(bead, false);
        old.Params.Input[0].AddSource(script);
        old.Params.Input[4].AddSource(bead);
        ((Param_Number)old.Params.Input[2]).SetPersistentData(2.85);
        ((Param_Boolean)old.Params.Input[3]).SetPersistentData(true);
        old.Params.Output[1].DataMapping = GH_DataMapping.Flatten;
        var plan = new PlanToolpathComponent();
        document.AddObject(plan, false);
        plan.Params.Input[0].AddSource(old.Params.Output[1]);
        var group = new GH_Group();
        group.AddObject(old.InstanceGuid);
        document.AddObject(group, false);
        document.NewSolution(true);
        var before = Beads(old);
        Assert.That(before.Single().Area, Is.EqualTo(Bead.FromWidth(0.6, 0.3, shape: BeadShape.Stadium).Area));

        var made = (TurtleComponent)new TurtleUpgrade().Upgrade(old, document)!;
        Assert.That(document.Objects, Has.Member(made).And.No.Member(old));
        Assert.That(document.Objects[0], Is.SameAs(made), "In its place.");
        Assert.That(group.ObjectIDs, Is.EqualTo(new[] { made.InstanceGuid }));
        Assert.That((made.NickName, made.Hidden), Is.EqualTo(("Star", true)));
        Assert.That(made.Params.Input[2].Sources.Single(), Is.SameAs(bead));
        Assert.That(((GH_PersistentParam<Grasshopper.Kernel.Types.GH_Number>)made.Params.Input[3]).PersistentData.AllData(true).Single().ToString(),
            Is.EqualTo("2.85"));
        Assert.That(plan.Params.Input[0].Sources.Single(), Is.SameAs(made.Params.Output[1]));
        Assert.That(made.Params.Output[1].DataMapping, Is.EqualTo(GH_DataMapping.Flatten));
        document.NewSolution(true);
        Assert.That(made.RuntimeMessages(GH_RuntimeMessageLevel.Error), Is.Empty);
        Assert.That(Beads(made), Is.EqualTo(before));
        Assert.That(made.Params.Output[2].VolatileDataCount, Is.EqualTo(4), "Every Pose stays true.");
    }

    private static Bead[] Beads(GH_Component turtle) => turtle.Params.Output[0].VolatileData.get_Branch(0)!.Cast<Grasshopper.Kernel.Types.IGH_Goo>()
        .Select(g => ((PrintPath)g.ScriptVariable()!).BeadOf(0)).ToArray();
}
