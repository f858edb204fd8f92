using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using GH_IO.Serialization;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Types;
using Rhino.Geometry;

namespace Grasshopper.Kernel
{
    public abstract class GH_Param<T> : GH_ActiveObject, IGH_Param, IHeadlessParam
        where T : class, IGH_Goo
    {
        protected GH_Structure<T> m_data = new GH_Structure<T>();
        private readonly List<IGH_Param> _sources = new List<IGH_Param>();
        private readonly List<IGH_Param> _recipients = new List<IGH_Param>();
        private readonly List<Guid> _proxySources = new List<Guid>();

        protected GH_Param(string name, string nickname, string description, string category, string subcategory, GH_ParamAccess access)
            : base(name, nickname, description, category, subcategory)
        {
            Access = access;
        }

        public virtual GH_ParamAccess Access { get; set; }

        public virtual GH_ParamKind Kind => Server == null ? GH_ParamKind.floating : Server.Input.Contains(this) ? GH_ParamKind.input : GH_ParamKind.output;

        public virtual bool Optional { get; set; }

        public virtual GH_DataMapping DataMapping { get; set; }

        public virtual bool Reverse { get; set; }

        public virtual bool Simplify { get; set; }

        public virtual string TypeName => InstantiateT()?.TypeName ?? "Data";

        public Type Type => typeof(T);

        public virtual IList<IGH_Param> Sources => _sources;

        public int SourceCount => _sources.Count;

        public virtual IList<IGH_Param> Recipients => _recipients;

        public IGH_Structure VolatileData => m_data;

        public int VolatileDataCount => m_data.DataCount;

        internal GH_ComponentParamServer Server { get; set; }

        GH_ComponentParamServer IHeadlessParam.Server
        {
            get => Server;
            set => Server = value;
        }

        public virtual void AddSource(IGH_Param source)
        {
            if (source == null || _sources.Contains(source)) return;
            _sources.Add(source);
            source.Recipients.Add(this);
        }

        public void RemoveSource(IGH_Param source)
        {
            if (_sources.Remove(source)) source.Recipients.Remove(this);
        }

        public virtual void RemoveAllSources()
        {
            foreach (var source in _sources.ToArray()) RemoveSource(source);
        }

        public bool AddVolatileData(GH_Path path, int index, object data)
        {
            var goo = data == null ? null : Cast_Object(data);
            if (data != null && goo == null)
            {
                var from = Casting.Wrap(data);
                AddRuntimeMessage(GH_RuntimeMessageLevel.Error, "Data conversion failed from " + from.TypeName + " to " + TypeName);
            }
            m_data.Insert(goo, path, index);
            return goo != null || data == null;
        }

        public bool AddVolatileDataList(GH_Path path, IEnumerable list)
        {
            var all = m_data.EnsurePath(path).Count;
            if (list == null) return false;
            foreach (var item in list) AddVolatileData(path, all++, item);
            return true;
        }

        public bool AddVolatileDataTree(IGH_Structure tree)
        {
            if (SolveLoop.SharesTrees && m_data.IsEmpty && tree is GH_Structure<T> same)
            {
                m_data = same;
                return true;
            }
            for (var i = 0; i < tree.PathCount; i++) AddVolatileDataList(tree.get_Path(i), tree.get_Branch(i));
            return true;
        }

        public override void ClearData()
        {
            base.ClearData();
            m_data.Clear();
        }

        public override void CollectData()
        {
            if (Phase == GH_SolutionPhase.Collected || Phase == GH_SolutionPhase.Computed) return;
            if (Kind == GH_ParamKind.output) return;
            m_data.Clear();
            if (SourceCount > 0) CollectVolatileData_FromSources();
            else CollectVolatileData_Custom();
            PostProcessData();
            OnVolatileDataCollected();
            Phase = GH_SolutionPhase.Collected;
        }

        public override void ComputeData()
        {
            if (Kind == GH_ParamKind.floating && m_data.IsEmpty && SourceCount > 0)
                AddRuntimeMessage(GH_RuntimeMessageLevel.Warning, "Floating parameter " + NickName + " failed to collect data");
            Phase = GH_SolutionPhase.Computed;
        }

        public override bool DependsOn(IGH_ActiveObject potentialSource)
            => _sources.Any(s => ReferenceEquals(s, potentialSource) || ReferenceEquals(((IHeadlessParam)s).Server?.Owner, potentialSource));

        public override GH_Document OnPingDocument() => Server?.Owner.OnPingDocument() ?? base.OnPingDocument();

        public override void RemovedFromDocument(GH_Document document)
        {
            RemoveAllSources();
            foreach (var recipient in _recipients.ToArray()) recipient.RemoveSource(this);
            base.RemovedFromDocument(document);
        }

        public override bool Write(GH_IWriter writer)
        {
            base.Write(writer);
            writer.SetBoolean("Optional", Optional);
            if (Server?.Owner is IGH_VariableParameterComponent) writer.SetInt32("Access", (int)Access);
            writer.SetInt32("SourceCount", SourceCount);
            for (var i = 0; i < SourceCount; i++) writer.SetGuid("Source", i, _sources[i].InstanceGuid);
            if (DataMapping != GH_DataMapping.None) writer.SetInt32("Mapping", (int)DataMapping);
            return true;
        }

        public override bool Read(GH_IReader reader)
        {
            base.Read(reader);
            var mapping = 0;
            DataMapping = reader.TryGetInt32("Mapping", ref mapping) ? (GH_DataMapping)mapping : GH_DataMapping.None;
            var count = 0;
            reader.TryGetInt32("SourceCount", ref count);
            _proxySources.Clear();
            for (var i = 0; i < count; i++) _proxySources.Add(reader.GetGuid("Source", i));
            return true;
        }

        /// <summary>Makes wires of the ids that were read, once all objects of the definition are there.</summary>
        public virtual bool RelinkProxySources(GH_Document document)
        {
            var found = true;
            foreach (var id in _proxySources)
            {
                var source = document.FindParam(id);
                if (source != null) AddSource(source);
                found &= source != null;
            }
            _proxySources.Clear();
            return found;
        }

        protected virtual T InstantiateT() => typeof(T).IsAbstract || typeof(T).IsInterface ? null : (T)Activator.CreateInstance(typeof(T));

        protected virtual T PreferredCast(object data) => null;

        protected virtual void OnVolatileDataCollected()
        {
        }

        protected virtual void CollectVolatileData_Custom()
        {
        }

        protected virtual void CollectVolatileData_FromSources()
        {
            foreach (var source in _sources)
            {
                source.CollectData();
                AddVolatileDataTree(source.VolatileData);
            }
        }

        public virtual void PostProcessData()
        {
            var branches = m_data.Branches;
            if (Reverse) branches.ForEach(b => b.Reverse());
            if (DataMapping != GH_DataMapping.None) m_data = Mapped(branches);
            if (Simplify) m_data = Simplified();
        }

        private GH_Structure<T> Mapped(List<List<T>> branches)
        {
            var mapped = new GH_Structure<T>();
            for (var i = 0; i < branches.Count; i++)
            {
                if (DataMapping == GH_DataMapping.Flatten) mapped.AppendRange(branches[i], new GH_Path(0));
                else if (branches[i].Count == 0 && SolveLoop.GraftKeepsEmpty) mapped.EnsurePath(m_data.get_Path(i));
                else for (var k = 0; k < branches[i].Count; k++) mapped.Append(branches[i][k], m_data.get_Path(i).AppendElement(k));
            }
            return mapped;
        }

        // Without the elements that all paths begin with; one stays.
        private GH_Structure<T> Simplified()
        {
            var paths = m_data.Paths;
            if (paths.Count == 0) return m_data;
            var shared = 0;
            while (paths.All(p => p.Length > shared + 1 && p.Indices[shared] == paths[0].Indices[shared])) shared++;
            var simple = new GH_Structure<T>();
            for (var i = 0; i < paths.Count; i++) simple.AppendRange(m_data.Branches[i], new GH_Path(paths[i].Indices.Skip(shared).ToArray()));
            return simple;
        }

        protected override void ExpireDownStreamObjects()
        {
            foreach (var recipient in _recipients) recipient.ExpireSolution(false);
        }

        public override void ExpireSolution(bool recompute)
        {
            ClearData();
            ExpireDownStreamObjects();
            if (Server != null && Server.Input.Contains(this)) Server.Owner.ExpireSolution(recompute);
            else if (recompute) OnPingDocument()?.NewSolution(false);
        }

        protected BoundingBox Preview_ComputeClippingBox()
        {
            var box = BoundingBox.Empty;
            foreach (var goo in m_data.AllData(true))
            {
                if (goo is IGH_PreviewData preview) box.Union(preview.ClippingBox);
            }
            return box;
        }

        protected void Preview_DrawWires(IGH_PreviewArgs args)
        {
            var colour = Attributes?.GetTopLevel.Selected == true ? args.WireColour_Selected : args.WireColour;
            var wires = new GH_PreviewWireArgs(args.Viewport, args.Display, colour, args.DefaultCurveThickness);
            foreach (var goo in m_data.AllData(true)) (goo as IGH_PreviewData)?.DrawViewportWires(wires);
        }

        protected void Preview_DrawMeshes(IGH_PreviewArgs args)
        {
            var meshes = new GH_PreviewMeshArgs(args.Viewport, args.Display, args.ShadeMaterial, args.MeshingParameters);
            foreach (var goo in m_data.AllData(true)) (goo as IGH_PreviewData)?.DrawViewportMeshes(meshes);
        }

        protected virtual T Cast_Object(object data) => data as T ?? PreferredCast(data) ?? Casting.ToGoo(data, InstantiateT);
    }

    /// <summary>What the host needs to know of a parameter, whatever its type of data.</summary>
    internal interface IHeadlessParam : IGH_Param
    {
        GH_ComponentParamServer Server { get; set; }

        void PostProcessData();
    }

    public abstract class GH_PersistentParam<T> : GH_Param<T>
        where T : class, IGH_Goo
    {
        protected GH_Structure<T> m_dataPersistent = new GH_Structure<T>();

        protected GH_PersistentParam(string name, string nickname, string description, string category, string subcategory)
            : base(name, nickname, description, category, subcategory, GH_ParamAccess.item)
        {
        }

        public GH_Structure<T> PersistentData => m_dataPersistent;

        public virtual int PersistentDataCount => m_dataPersistent.DataCount;

        public void SetPersistentData(params object[] values)
        {
            m_dataPersistent.Clear();
            foreach (var value in values) m_dataPersistent.Append(Cast_Object(value), new GH_Path(0));
        }

        public override bool Write(GH_IWriter writer)
        {
            base.Write(writer);
            if (!m_dataPersistent.IsEmpty) m_dataPersistent.Write(writer.CreateChunk("PersistentData"));
            return true;
        }

        public override bool Read(GH_IReader reader)
        {
            base.Read(reader);
            m_dataPersistent.Clear();
            var chunk = reader.FindChunk("PersistentData");
            return chunk == null || m_dataPersistent.Read(chunk);
        }

        protected abstract GH_GetterResult Prompt_Singular(ref T value);

        protected abstract GH_GetterResult Prompt_Plural(ref List<T> values);

        // Persistent data is copied, so that a component may change what it gets.
        protected override void CollectVolatileData_Custom()
        {
            for (var i = 0; i < m_dataPersistent.PathCount; i++)
                m_data.AppendRange(m_dataPersistent.Branches[i].Select(g => (T)g?.Duplicate()), m_dataPersistent.get_Path(i));
        }
    }

    public abstract class GH_PersistentGeometryParam<T> : GH_PersistentParam<T>
        where T : class, IGH_GeometricGoo
    {
        internal GH_PersistentGeometryParam(string name, string nickname, string description, string category, string subcategory)
            : base(name, nickname, description, category, subcategory)
        {
        }
    }
}
