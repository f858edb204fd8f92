using System;
using System.Linq;

namespace Grasshopper.Kernel
{
    /// <summary>Knows how to replace an old object by a new one; Grasshopper finds it in the library by itself.</summary>
    public interface IGH_UpgradeObject
    {
        DateTime Version { get; }

        Guid UpgradeFrom { get; }

        Guid UpgradeTo { get; }

        IGH_DocumentObject Upgrade(IGH_DocumentObject target, GH_Document document);
    }

    public static class GH_UpgradeUtil
    {
        public static int MigrateRecipients(IGH_Param from, IGH_Param to)
        {
            var recipients = from.Recipients.ToList();
            foreach (var recipient in recipients)
            {
                // The new wire takes the place of the old one.
                var sources = recipient.Sources.ToList();
                recipient.RemoveAllSources();
                foreach (var source in sources) recipient.AddSource(ReferenceEquals(source, from) ? to : source);
            }
            return recipients.Count;
        }

        public static bool SwapComponents(IGH_Component oldComponent, IGH_Component newComponent, bool migrateParameters)
        {
            if (migrateParameters) throw new NotSupportedException("The headless host moves no ports: do it before.");
            var document = oldComponent.OnPingDocument();
            if (document == null) return false;
            newComponent.CreateAttributes();
            newComponent.Attributes.Pivot = oldComponent.Attributes.Pivot;
            var index = document.Objects.IndexOf(oldComponent);
            document.RemoveObject(oldComponent, false);
            return document.AddObject(newComponent, false, index);
        }
    }
}
