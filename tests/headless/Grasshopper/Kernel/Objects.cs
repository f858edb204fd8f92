using System;
using System.Collections.Generic;
using System.Drawing;
using System.Linq;
using GH_IO;
using GH_IO.Serialization;

namespace Grasshopper.Kernel
{
    public class GH_InstanceDescription : IGH_InstanceDescription
    {
        public GH_InstanceDescription(string name, string nickname, string description, string category, string subcategory)
        {
            Name = name;
            NickName = nickname;
            Description = description;
            Category = category;
            SubCategory = subcategory;
        }

        public virtual string Name { get; set; } = "";

        public virtual string NickName { get; set; } = "";

        public virtual string Description { get; set; } = "";

        public virtual string Category { get; set; } = "";

        public virtual string SubCategory { get; set; } = "";

        public Guid InstanceGuid { get; private set; } = Guid.NewGuid();

        public void NewInstanceGuid() => NewInstanceGuid(Guid.NewGuid());

        public void NewInstanceGuid(Guid UUID) => InstanceGuid = UUID;

        public virtual bool Write(GH_IWriter writer)
        {
            writer.SetString("Name", Name);
            writer.SetString("NickName", NickName);
            writer.SetString("Description", Description);
            writer.SetGuid("InstanceGuid", InstanceGuid);
            return true;
        }

        public virtual bool Read(GH_IReader reader)
        {
            var text = NickName;
            if (reader.TryGetString("NickName", ref text)) NickName = text;
            var id = InstanceGuid;
            if (reader.TryGetGuid("InstanceGuid", ref id)) InstanceGuid = id;
            return true;
        }
    }

    internal sealed class HeadlessAttributes : IGH_Attributes
    {
        public HeadlessAttributes(IGH_DocumentObject owner) => DocObject = owner;

        public PointF Pivot { get; set; }

        public RectangleF Bounds { get; set; }

        public bool Selected { get; set; }

        public IGH_DocumentObject DocObject { get; }

        public IGH_Attributes GetTopLevel => DocObject is IHeadlessParam param && param.Server != null ? param.Server.Owner.Attributes : this;
    }

    public abstract class GH_DocumentObject : GH_InstanceDescription, IGH_DocumentObject
    {
        private Bitmap _icon;

        internal GH_DocumentObject(string name, string nickname, string description, string category, string subcategory)
            : base(name, nickname, description, category, subcategory)
        {
        }

        public abstract Guid ComponentGuid { get; }

        public virtual GH_Exposure Exposure => GH_Exposure.primary;

        public Bitmap Icon_24x24 => _icon ?? (_icon = Icon);

        public IGH_Attributes Attributes { get; set; }

        protected virtual Bitmap Icon => null;

        internal GH_Document Document { get; set; }

        public virtual void CreateAttributes() => Attributes = new HeadlessAttributes(this);

        public virtual void AddedToDocument(GH_Document document) => Document = document;

        public virtual void RemovedFromDocument(GH_Document document) => Document = null;

        public virtual void DocumentContextChanged(GH_Document document, GH_DocumentContext context)
        {
        }

        public virtual void ExpireSolution(bool recompute)
        {
        }

        public void OnDisplayExpired(bool redraw)
        {
        }

        public virtual GH_Document OnPingDocument() => Document;
    }

    public abstract class GH_ActiveObject : GH_DocumentObject, IGH_ActiveObject
    {
        private readonly List<KeyValuePair<GH_RuntimeMessageLevel, string>> _messages = new List<KeyValuePair<GH_RuntimeMessageLevel, string>>();

        internal GH_ActiveObject(string name, string nickname, string description, string category, string subcategory)
            : base(name, nickname, description, category, subcategory)
        {
        }

        public virtual bool MutableNickName { get; set; } = true;

        public virtual bool Locked { get; set; }

        public virtual GH_SolutionPhase Phase { get; set; }

        public virtual GH_RuntimeMessageLevel RuntimeMessageLevel
        {
            get
            {
                foreach (var level in new[] { GH_RuntimeMessageLevel.Error, GH_RuntimeMessageLevel.Warning, GH_RuntimeMessageLevel.Remark })
                {
                    if (RuntimeMessages(level).Count > 0) return level;
                }
                return GH_RuntimeMessageLevel.Blank;
            }
        }

        public virtual void AddRuntimeMessage(GH_RuntimeMessageLevel level, string text)
        {
            var message = new KeyValuePair<GH_RuntimeMessageLevel, string>(level, text);
            if (!string.IsNullOrEmpty(text) && !_messages.Contains(message)) _messages.Add(message);
        }

        public virtual IList<string> RuntimeMessages(GH_RuntimeMessageLevel level) => _messages.Where(m => m.Key == level).Select(m => m.Value).ToList();

        public virtual void ClearRuntimeMessages() => _messages.Clear();

        public virtual void ClearData()
        {
            ClearRuntimeMessages();
            Phase = GH_SolutionPhase.Blank;
        }

        public virtual void CollectData()
        {
        }

        public virtual void ComputeData()
        {
        }

        public virtual bool DependsOn(IGH_ActiveObject potentialSource) => false;

        public override void ExpireSolution(bool recompute)
        {
            ClearData();
            ExpireDownStreamObjects();
            if (recompute) OnPingDocument()?.NewSolution(false);
        }

        protected virtual void ExpireDownStreamObjects()
        {
        }
    }
}
