using System;
using System.Collections;
using System.Collections.Generic;
using System.Drawing;
using GH_IO;
using Grasshopper.Kernel.Data;
using Rhino;
using Rhino.Display;
using Rhino.DocObjects;
using Rhino.Geometry;

namespace Grasshopper.Kernel
{
    public interface IGH_InstanceDescription : GH_ISerializable
    {
        string Name { get; set; }

        string NickName { get; set; }

        string Description { get; set; }

        string Category { get; set; }

        string SubCategory { get; set; }

        Guid InstanceGuid { get; }

        void NewInstanceGuid(Guid UUID);
    }

    public interface IGH_DocumentObject : IGH_InstanceDescription
    {
        Guid ComponentGuid { get; }

        GH_Exposure Exposure { get; }

        IGH_Attributes Attributes { get; set; }

        void CreateAttributes();

        void AddedToDocument(GH_Document document);

        void RemovedFromDocument(GH_Document document);

        void DocumentContextChanged(GH_Document document, GH_DocumentContext context);

        void ExpireSolution(bool recompute);

        GH_Document OnPingDocument();
    }

    public interface IGH_ActiveObject : IGH_DocumentObject
    {
        bool MutableNickName { get; set; }

        bool Locked { get; set; }

        GH_SolutionPhase Phase { get; set; }

        GH_RuntimeMessageLevel RuntimeMessageLevel { get; }

        void AddRuntimeMessage(GH_RuntimeMessageLevel Type, string Message);

        IList<string> RuntimeMessages(GH_RuntimeMessageLevel level);

        void ClearRuntimeMessages();

        void ClearData();

        void CollectData();

        void ComputeData();

        bool DependsOn(IGH_ActiveObject PotentialSource);
    }

    public interface IGH_Component : IGH_ActiveObject, IGH_PreviewObject, IGH_BakeAwareObject
    {
        GH_ComponentParamServer Params { get; }

        string Message { get; set; }

        int RunCount { get; }
    }

    public interface IGH_Param : IGH_ActiveObject
    {
        GH_ParamAccess Access { get; set; }

        GH_ParamKind Kind { get; }

        bool Optional { get; set; }

        GH_DataMapping DataMapping { get; set; }

        bool Reverse { get; set; }

        bool Simplify { get; set; }

        string TypeName { get; }

        Type Type { get; }

        IList<IGH_Param> Sources { get; }

        int SourceCount { get; }

        IList<IGH_Param> Recipients { get; }

        IGH_Structure VolatileData { get; }

        int VolatileDataCount { get; }

        void AddSource(IGH_Param source);

        void RemoveSource(IGH_Param source);

        void RemoveAllSources();

        bool RelinkProxySources(GH_Document document);

        bool AddVolatileData(GH_Path path, int index, object data);

        bool AddVolatileDataList(GH_Path path, IEnumerable list);

        bool AddVolatileDataTree(IGH_Structure tree);
    }

    public interface IGH_DataAccess
    {
        int Iteration { get; }

        bool GetData<T>(int index, ref T destination);

        bool GetDataList<T>(int index, List<T> list);

        bool GetDataTree<T>(int index, out GH_Structure<T> tree)
            where T : Types.IGH_Goo;

        bool SetData(int paramIndex, object data);

        bool SetDataList(int paramIndex, IEnumerable data);

        bool SetDataTree(int paramIndex, IGH_Structure tree);

        GH_Path ParameterTargetPath(int paramIndex);

        int ParameterTargetIndex(int paramIndex);

        void AbortComponentSolution();
    }

    public interface IGH_Attributes
    {
        PointF Pivot { get; set; }

        RectangleF Bounds { get; set; }

        bool Selected { get; set; }

        IGH_DocumentObject DocObject { get; }

        IGH_Attributes GetTopLevel { get; }
    }

    public interface IGH_PreviewArgs
    {
        GH_Document Document { get; }

        DisplayPipeline Display { get; }

        RhinoViewport Viewport { get; }

        Color WireColour { get; }

        Color WireColour_Selected { get; }

        DisplayMaterial ShadeMaterial { get; }

        DisplayMaterial ShadeMaterial_Selected { get; }

        int DefaultCurveThickness { get; }

        MeshingParameters MeshingParameters { get; }
    }

    public interface IGH_PreviewObject
    {
        bool Hidden { get; set; }

        bool IsPreviewCapable { get; }

        BoundingBox ClippingBox { get; }

        void DrawViewportWires(IGH_PreviewArgs args);

        void DrawViewportMeshes(IGH_PreviewArgs args);
    }

    public interface IGH_PreviewData
    {
        BoundingBox ClippingBox { get; }

        void DrawViewportWires(GH_PreviewWireArgs args);

        void DrawViewportMeshes(GH_PreviewMeshArgs args);
    }

    public interface IGH_BakeAwareData
    {
        bool BakeGeometry(RhinoDoc doc, ObjectAttributes att, out Guid obj_guid);
    }

    public interface IGH_BakeAwareObject
    {
        bool IsBakeCapable { get; }

        void BakeGeometry(RhinoDoc doc, List<Guid> obj_ids);

        void BakeGeometry(RhinoDoc doc, ObjectAttributes att, List<Guid> obj_ids);
    }
}
