using System;
using System.Linq;
using GH_IO.Serialization;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Special;

namespace Caterpillar.GH.Obsolete;

/// <summary>Replaces a component by one with its ports in another order: wires, values, names and groups stay.</summary>
public abstract class PortUpgrade : IGH_UpgradeObject
{
    /// <summary>The day on which the component became obsolete.</summary>
    public abstract DateTime Version { get; }

    public abstract Guid UpgradeFrom { get; }

    public abstract Guid UpgradeTo { get; }

    /// <summary>For each input of the old component its place in the new one.</summary>
    private protected abstract int[] InputsNow { get; }

    /// <summary>The component of today. Outputs keep their places.</summary>
    private protected abstract IGH_Component Make();

    public IGH_DocumentObject? Upgrade(IGH_DocumentObject target, GH_Document document)
    {
        if (target is not IGH_Component old || old.ComponentGuid != UpgradeFrom || document is null) return null;
        var made = Make();
        for (var i = 0; i < old.Params.Input.Count; i++) Carry(old.Params.Input[i], made.Params.Input[InputsNow[i]], document);
        for (var i = 0; i < old.Params.Output.Count; i++)
        {
            Carry(old.Params.Output[i], made.Params.Output[i], document);
            GH_UpgradeUtil.MigrateRecipients(old.Params.Output[i], made.Params.Output[i]);
        }
        made.Hidden = old.Hidden;
        made.Locked = old.Locked;
        made.NickName = old.NickName;
        if (!GH_UpgradeUtil.SwapComponents(old, made, false)) return null;
        foreach (var group in document.Objects.OfType<GH_Group>().Where(g => g.ObjectIDs.Contains(old.InstanceGuid)).ToArray())
        {
            group.RemoveObject(old.InstanceGuid);
            group.AddObject(made.InstanceGuid);
        }
        return made;
    }

    // As by saving and opening: name, values, how data is mapped, and the sources by their ids.
    private static void Carry(IGH_Param from, IGH_Param to, GH_Document document)
    {
        var (name, description, optional) = (to.Name, to.Description, to.Optional);
        var stored = new GH_LooseChunk("Port");
        if (!from.Write(stored) || !to.Read(stored)) return;
        (to.Name, to.Description, to.Optional) = (name, description, optional);
        to.RelinkProxySources(document);
    }
}
