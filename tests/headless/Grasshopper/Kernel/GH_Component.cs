using System;
using System.Collections.Generic;
using System.Linq;
using GH_IO.Serialization;
using Grasshopper.Kernel.Data;
using Rhino;
using Rhino.DocObjects;
using Rhino.Geometry;

namespace Grasshopper.Kernel
{
    public abstract class GH_Component : GH_ActiveObject, IGH_Component
    {
        protected GH_Component(string name, string nickname, string description, string category, string subCategory)
            : base(name, nickname, description, category, subCategory)
        {
            Params = new GH_ComponentParamServer(this);
            PostConstructor();
        }

        public GH_ComponentParamServer Params { get; }

        public string Message { get; set; }

        public int RunCount { get; internal set; }

        public virtual bool Hidden { get; set; }

        public virtual bool IsPreviewCapable => Params.Any(p => p is IGH_PreviewObject);

        /// <summary>As in Grasshopper it looks at the inputs.</summary>
        public virtual bool IsBakeCapable => Params.Input.Any(p => p is IGH_BakeAwareObject);

        /// <summary>As in Grasshopper it does not look at <see cref="Hidden"/>.</summary>
        public virtual BoundingBox ClippingBox
            => Params.Output.OfType<IGH_PreviewObject>().Aggregate(BoundingBox.Empty, (box, p) => BoundingBox.Union(box, p.ClippingBox));

        public override GH_RuntimeMessageLevel RuntimeMessageLevel => base.RuntimeMessageLevel;

        public override IList<string> RuntimeMessages(GH_RuntimeMessageLevel level)
            => base.RuntimeMessages(level).Concat(Params == null ? new string[0] : Params.SelectMany(p => p.RuntimeMessages(level))).ToList();

        public override void ClearRuntimeMessages()
        {
            base.ClearRuntimeMessages();
            foreach (var param in Params) param.ClearRuntimeMessages();
        }

        public override void ClearData()
        {
            base.ClearData();
            foreach (var param in Params) param.ClearData();
            RunCount = 0;
        }

        public override void CollectData()
        {
            if (Phase == GH_SolutionPhase.Collected || Phase == GH_SolutionPhase.Computed || Locked) return;
            foreach (var input in Params.Input) input.CollectData();
            Phase = GH_SolutionPhase.Collected;
        }

        public override void ComputeData()
        {
            if (Phase == GH_SolutionPhase.Computed || Phase == GH_SolutionPhase.Failed || Locked) return;
            var missing = Params.Input.Where(p => !p.Optional && p.VolatileDataCount == 0).ToList();
            foreach (var input in missing)
                AddRuntimeMessage(GH_RuntimeMessageLevel.Warning, "Input parameter " + input.NickName + " failed to collect data");
            if (missing.Count > 0)
            {
                Phase = GH_SolutionPhase.Computed;
                return;
            }
            Phase = GH_SolutionPhase.Computing;
            BeforeSolveInstance();
            try
            {
                new SolveLoop(this).Run(SolveInstance);
            }
            catch (Exception exception)
            {
                // Grasshopper shows what a component throws as an error of the component.
                AddRuntimeMessage(GH_RuntimeMessageLevel.Error, exception.Message);
            }
            AfterSolveInstance();
            foreach (var output in Params.Output)
            {
                output.Phase = GH_SolutionPhase.Collected;
                ((IHeadlessParam)output).PostProcessData();
            }
            Phase = GH_SolutionPhase.Computed;
        }

        public override void CreateAttributes()
        {
            base.CreateAttributes();
            foreach (var param in Params) param.CreateAttributes();
        }

        public override bool DependsOn(IGH_ActiveObject potentialSource) => Params.Input.Any(p => p.DependsOn(potentialSource));

        public override void RemovedFromDocument(GH_Document document)
        {
            foreach (var param in Params) param.RemovedFromDocument(document);
            base.RemovedFromDocument(document);
        }

        public virtual void DrawViewportWires(IGH_PreviewArgs args)
        {
            foreach (var output in Params.Output.OfType<IGH_PreviewObject>()) output.DrawViewportWires(args);
        }

        public virtual void DrawViewportMeshes(IGH_PreviewArgs args)
        {
            foreach (var output in Params.Output.OfType<IGH_PreviewObject>()) output.DrawViewportMeshes(args);
        }

        public virtual void BakeGeometry(RhinoDoc doc, List<Guid> obj_ids) => BakeGeometry(doc, new ObjectAttributes(), obj_ids);

        public virtual void BakeGeometry(RhinoDoc doc, ObjectAttributes att, List<Guid> obj_ids)
        {
            foreach (var output in Params.Output.OfType<IGH_BakeAwareObject>().Where(o => o.IsBakeCapable)) output.BakeGeometry(doc, att, obj_ids);
        }

        public override bool Write(GH_IWriter writer)
        {
            base.Write(writer);
            if (Hidden) writer.SetBoolean("Hidden", true);
            if (this is IGH_VariableParameterComponent)
            {
                Params.WriteVariable(writer);
                return true;
            }
            for (var i = 0; i < Params.Input.Count; i++) Params.Input[i].Write(writer.CreateChunk("param_input", i));
            for (var i = 0; i < Params.Output.Count; i++) Params.Output[i].Write(writer.CreateChunk("param_output", i));
            return true;
        }

        public override bool Read(GH_IReader reader)
        {
            base.Read(reader);
            var hidden = false;
            Hidden = reader.TryGetBoolean("Hidden", ref hidden) && hidden;
            if (this is IGH_VariableParameterComponent)
            {
                Params.ReadVariable(reader);
                return true;
            }
            for (var i = 0; i < Params.Input.Count; i++)
            {
                if (reader.ChunkExists("param_input", i)) Params.Input[i].Read(reader.FindChunk("param_input", i));
            }
            for (var i = 0; i < Params.Output.Count; i++)
            {
                if (reader.ChunkExists("param_output", i)) Params.Output[i].Read(reader.FindChunk("param_output", i));
            }
            return true;
        }

        protected abstract void RegisterInputParams(GH_InputParamManager pManager);

        protected abstract void RegisterOutputParams(GH_OutputParamManager pManager);

        protected abstract void SolveInstance(IGH_DataAccess DA);

        protected virtual void BeforeSolveInstance()
        {
        }

        protected virtual void AfterSolveInstance()
        {
        }

        protected override void ExpireDownStreamObjects()
        {
            foreach (var recipient in Params.Output.SelectMany(o => o.Recipients)) recipient.ExpireSolution(false);
        }

        // Called inside the constructor, as in Grasshopper: fields of derived classes are not set yet.
        protected virtual void PostConstructor()
        {
            RegisterInputParams(new GH_InputParamManager(this));
            RegisterOutputParams(new GH_OutputParamManager(this));
        }

        public class GH_InputParamManager
        {
            private readonly GH_Component _owner;

            internal GH_InputParamManager(GH_Component owner) => _owner = owner;

            public int AddParameter(IGH_Param param)
            {
                _owner.Params.RegisterInputParam(param);
                return _owner.Params.Input.Count - 1;
            }

            public int AddParameter(IGH_Param param, string name, string nickname, string description, GH_ParamAccess access)
                => AddParameter(Describe(param, name, nickname, description, access));
        }

        public class GH_OutputParamManager
        {
            private readonly GH_Component _owner;

            internal GH_OutputParamManager(GH_Component owner) => _owner = owner;

            public int AddParameter(IGH_Param param)
            {
                _owner.Params.RegisterOutputParam(param);
                return _owner.Params.Output.Count - 1;
            }

            public int AddParameter(IGH_Param param, string name, string nickname, string description, GH_ParamAccess access)
                => AddParameter(Describe(param, name, nickname, description, access));
        }

        private static IGH_Param Describe(IGH_Param param, string name, string nickname, string description, GH_ParamAccess access)
        {
            param.Name = name;
            param.NickName = nickname;
            param.Description = description;
            param.Access = access;
            return param;
        }
    }
}
