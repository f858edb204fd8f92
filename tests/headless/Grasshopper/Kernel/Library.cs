using System;
using System.Collections.Generic;
using System.Drawing;
using System.IO;
using Grasshopper.Kernel;

namespace Grasshopper
{
    public static class Instances
    {
        public static GH_ComponentServer ComponentServer { get; } = new GH_ComponentServer();
    }

    public static class Folders
    {
        // A test may set another one.
        internal static string Settings = Path.Combine(Path.GetTempPath(), "Grasshopper-headless");

        public static string SettingsFolder => Settings;
    }
}

namespace Grasshopper.Kernel
{
    public class GH_ComponentServer
    {
        internal readonly Dictionary<string, object> Categories = new Dictionary<string, object>();

        internal GH_ComponentServer()
        {
        }

        public bool AddCategoryIcon(string fullCategoryName, Bitmap icon)
        {
            Categories[fullCategoryName + " icon"] = icon;
            return true;
        }

        public bool AddCategoryShortName(string fullCategoryName, string categoryAbbreviation)
        {
            Categories[fullCategoryName + " short"] = categoryAbbreviation;
            return true;
        }

        public bool AddCategorySymbolName(string fullCategoryName, char symbol)
        {
            Categories[fullCategoryName + " symbol"] = symbol;
            return true;
        }
    }

    public abstract class GH_AssemblyPriority
    {
        public abstract GH_LoadingInstruction PriorityLoad();
    }

    public class GH_AssemblyInfo
    {
        public virtual string Name => "";

        public virtual string Description => "";

        public virtual Bitmap Icon => null;

        public virtual Guid Id => Guid.Empty;

        public virtual string AuthorName => "";

        public virtual string AuthorContact => "";

        public virtual string Version => "";

        public virtual GH_LibraryLicense License => GH_LibraryLicense.unset;
    }
}
