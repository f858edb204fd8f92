using System;
using System.Collections.Generic;
using System.Drawing;
using System.Linq;
using GH_IO.Serialization;

namespace Grasshopper.Kernel
{
    /// <summary>Definitions in the form of .gh and .ghx files: header, libraries, objects with their containers.</summary>
    public sealed partial class GH_Document
    {
        private static readonly string[] Native = { "Grasshopper", "RhinoCommon" };

        public Guid DocumentID { get; private set; } = Guid.NewGuid();

        // The name in the properties of the definition.
        internal string Name { get; set; } = "";

        internal void SetId(Guid id) => DocumentID = id;

        public bool Write(GH_IWriter writer)
        {
            writer.SetVersion("plugin_version", 1, 0, 8);
            var header = writer.CreateChunk("DocumentHeader");
            header.SetGuid("DocumentID", DocumentID);
            header.SetString("Preview", "Shaded");
            writer.CreateChunk("DefinitionProperties").SetString("Name", Name);
            var libraries = _objects.Select(o => o.GetType().Assembly).Where(a => !Native.Contains(a.GetName().Name)).Distinct().ToList();
            var known = libraries.Select(Instances.ComponentServer.InfoOf).ToList();
            var list = writer.CreateChunk("GHALibraries");
            list.SetInt32("Count", known.Count);
            for (var i = 0; i < known.Count; i++)
            {
                var library = list.CreateChunk("Library", i);
                library.SetString("Author", known[i].AuthorName);
                library.SetGuid("Id", known[i].Id);
                library.SetString("Name", known[i].Name);
                library.SetString("Version", known[i].Version);
            }
            var objects = writer.CreateChunk("DefinitionObjects");
            objects.SetInt32("ObjectCount", _objects.Count);
            for (var i = 0; i < _objects.Count; i++)
            {
                var item = objects.CreateChunk("Object", i);
                item.SetGuid("GUID", _objects[i].ComponentGuid);
                var at = libraries.IndexOf(_objects[i].GetType().Assembly);
                if (at >= 0) item.SetGuid("Lib", known[at].Id);
                item.SetString("Name", _objects[i].Name);
                var container = item.CreateChunk("Container");
                if (!_objects[i].Write(container)) return false;
                var attributes = container.CreateChunk("Attributes");
                // Groups lie around their members.
                if (_objects[i] is Special.GH_Group) continue;
                attributes.SetDrawingRectangleF("Bounds", _objects[i].Attributes.Bounds);
                attributes.SetDrawingPointF("Pivot", _objects[i].Attributes.Pivot);
            }
            return true;
        }

        public bool Read(GH_IReader reader)
        {
            foreach (var item in _objects.ToArray()) RemoveObject(item, false);
            DocumentID = reader.FindChunk("DocumentHeader")?.GetGuid("DocumentID") ?? DocumentID;
            var objects = reader.FindChunk("DefinitionObjects");
            if (objects == null) return false;
            var whole = true;
            for (var i = 0; i < objects.GetInt32("ObjectCount"); i++)
            {
                var chunk = objects.FindChunk("Object", i);
                var item = Instances.ComponentServer.EmitObject(chunk.GetGuid("GUID"));
                if (item == null)
                {
                    whole = false;
                    continue;
                }
                var container = chunk.FindChunk("Container");
                whole &= item.Read(container);
                AddObject(item, false);
                Place(item, container.FindChunk("Attributes"));
            }
            foreach (var param in Params()) whole &= param.RelinkProxySources(this);
            return whole;
        }

        internal IGH_Param FindParam(Guid id) => Params().FirstOrDefault(p => p.InstanceGuid == id);

        private IEnumerable<IGH_Param> Params()
            => _objects.SelectMany(o => o is IGH_Component component ? component.Params : o is IGH_Param param ? new[] { param }
                : Enumerable.Empty<IGH_Param>()).ToList();

        private static void Place(IGH_DocumentObject item, GH_IReader attributes)
        {
            if (attributes == null) return;
            var bounds = attributes.Items.Find(i => i.Name == "Bounds");
            if (bounds != null) item.Attributes.Bounds = (RectangleF)bounds.InternalData;
            // Toggles and buttons of Grasshopper have bounds only, groups neither.
            item.Attributes.Pivot = (PointF)(attributes.Items.Find(i => i.Name == "Pivot")?.InternalData ?? item.Attributes.Bounds.Location);
        }
    }
}
