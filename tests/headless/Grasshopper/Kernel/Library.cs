using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Drawing;
using System.IO;
using System.Linq;
using System.Reflection;
using Grasshopper.Kernel;

namespace Grasshopper
{
    public static class Instances
    {
        public static GH_ComponentServer ComponentServer { get; } = new GH_ComponentServer();

        public static bool IsDocumentServer => true;

        public static GH_DocumentServer DocumentServer { get; } = new GH_DocumentServer();

        public static GH_SettingsServer Settings { get; } = new GH_SettingsServer("headless");
    }

    public static class Folders
    {
        // Tests run side by side: each thread has its own.
        [ThreadStatic]
        private static string s_settings;

        // A test may set another one.
        internal static string Settings
        {
            get => s_settings ?? Path.Combine(Path.GetTempPath(), "Grasshopper-headless");
            set => s_settings = value;
        }

        public static string SettingsFolder => Settings;
    }
}

namespace Grasshopper.Kernel
{
    public interface IGH_DocumentOwner
    {
        void DocumentModified(GH_Document document);

        void DocumentClosed(GH_Document document);

        GH_Document OwnerDocument();
    }

    /// <summary>The definitions that are open in the editor.</summary>
    public class GH_DocumentServer
    {
        private readonly List<GH_Document> _documents = new List<GH_Document>();

        internal GH_DocumentServer()
        {
        }

        public bool Contains(GH_Document doc) => _documents.Contains(doc);

        public void AddDocument(GH_Document document) => _documents.Add(document);

        public bool RemoveDocument(GH_Document document) => _documents.Remove(document);
    }

    public class GH_SettingsServer
    {
        private readonly Dictionary<string, bool> _values = new Dictionary<string, bool>();

        public GH_SettingsServer(string name)
        {
        }

        public bool GetValue(string key, bool @default) => _values.TryGetValue(key, out var value) ? value : @default;

        public void SetValue(string key, bool value) => _values[key] = value;
    }

    public class GH_ComponentServer
    {
        internal readonly Dictionary<string, object> Categories = new Dictionary<string, object>();
        private readonly ConcurrentDictionary<Guid, Type> _types = new ConcurrentDictionary<Guid, Type>();
        private readonly ConcurrentDictionary<Assembly, GH_AssemblyInfo> _libraries = new ConcurrentDictionary<Assembly, GH_AssemblyInfo>();

        internal GH_ComponentServer() => Load(typeof(GH_ComponentServer).Assembly);

        /// <summary>A new object by the id of its kind, or null where no library has it.</summary>
        public IGH_DocumentObject EmitObject(Guid id) => _types.TryGetValue(id, out var type) ? (IGH_DocumentObject)Activator.CreateInstance(type) : null;

        /// <summary>Takes the objects of a library, as Grasshopper does with a .gha.</summary>
        internal void Load(Assembly library)
        {
            foreach (var type in (library == typeof(GH_ComponentServer).Assembly ? library.GetTypes() : library.GetExportedTypes())
                .Where(t => !t.IsAbstract && !t.ContainsGenericParameters && typeof(IGH_DocumentObject).IsAssignableFrom(t)))
                _types[((IGH_DocumentObject)Activator.CreateInstance(type)).ComponentGuid] = type;
        }

        internal GH_AssemblyInfo InfoOf(Assembly library)
        {
            if (_libraries.TryGetValue(library, out var info)) return info;
            var type = library.GetExportedTypes().FirstOrDefault(t => typeof(GH_AssemblyInfo).IsAssignableFrom(t));
            return _libraries[library] = type == null ? new GH_AssemblyInfo() : (GH_AssemblyInfo)Activator.CreateInstance(type);
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
