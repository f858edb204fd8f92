using System;
using System.Collections.Generic;
using Grasshopper.Kernel.Types;
using Rhino.Geometry;

namespace Grasshopper.Kernel.Parameters
{
    public class Param_Geometry : GH_PersistentGeometryParam<IGH_GeometricGoo>
    {
        public Param_Geometry() : base("Geometry", "Geo", "Contains a collection of generic geometry", "Params", "Geometry")
        {
        }

        public override Guid ComponentGuid => new Guid("ac2bc2cb-70fb-4dd5-9c78-7e1ea97fe278");

        protected override GH_GetterResult Prompt_Singular(ref IGH_GeometricGoo value) => GH_GetterResult.cancel;

        protected override GH_GetterResult Prompt_Plural(ref List<IGH_GeometricGoo> values) => GH_GetterResult.cancel;
    }

    public class Param_Point : GH_PersistentGeometryParam<GH_Point>
    {
        public Param_Point() : base("Point", "Pt", "Contains a collection of three-dimensional points", "Params", "Geometry")
        {
        }

        public override Guid ComponentGuid => new Guid("fbac3e32-f100-4292-8692-77240a42fd1a");

        protected override GH_GetterResult Prompt_Singular(ref GH_Point value) => GH_GetterResult.cancel;

        protected override GH_GetterResult Prompt_Plural(ref List<GH_Point> values) => GH_GetterResult.cancel;
    }

    public class Param_Vector : GH_PersistentParam<GH_Vector>
    {
        public Param_Vector() : base("Vector", "Vec", "Contains a collection of three-dimensional vectors", "Params", "Geometry")
        {
        }

        public override Guid ComponentGuid => new Guid("16ef3e75-e315-4899-b531-d3166b42dac9");

        protected override GH_GetterResult Prompt_Singular(ref GH_Vector value) => GH_GetterResult.cancel;

        protected override GH_GetterResult Prompt_Plural(ref List<GH_Vector> values) => GH_GetterResult.cancel;
    }

    public class Param_Plane : GH_PersistentGeometryParam<GH_Plane>
    {
        public Param_Plane() : base("Plane", "Pln", "Contains a collection of three-dimensional axis-systems", "Params", "Geometry")
        {
        }

        public override Guid ComponentGuid => new Guid("4f8984c4-7c7a-4d69-b0a2-183cbb330d20");

        protected override GH_GetterResult Prompt_Singular(ref GH_Plane value) => GH_GetterResult.cancel;

        protected override GH_GetterResult Prompt_Plural(ref List<GH_Plane> values) => GH_GetterResult.cancel;
    }

    public class Param_Transform : GH_PersistentParam<GH_Transform>
    {
        public Param_Transform() : base("Transform", "Transform", "Contains a collection of three-dimensional transformations", "Params", "Primitive")
        {
        }

        public override Guid ComponentGuid => new Guid("28f40e48-e739-4211-91bd-f4aefa5965f8");

        protected override GH_GetterResult Prompt_Singular(ref GH_Transform value) => GH_GetterResult.cancel;

        protected override GH_GetterResult Prompt_Plural(ref List<GH_Transform> values) => GH_GetterResult.cancel;
    }

    public class Param_Curve : GH_PersistentGeometryParam<GH_Curve>, IGH_PreviewObject
    {
        public Param_Curve() : base("Curve", "Crv", "Contains a collection of generic curves", "Params", "Geometry")
        {
        }

        public override Guid ComponentGuid => new Guid("d5967b9f-e8ee-436b-a8ad-29fdcecf32d5");

        public bool Hidden { get; set; }

        public bool IsPreviewCapable => true;

        public BoundingBox ClippingBox => Preview_ComputeClippingBox();

        public void DrawViewportWires(IGH_PreviewArgs args) => Preview_DrawWires(args);

        public void DrawViewportMeshes(IGH_PreviewArgs args) => Preview_DrawMeshes(args);

        protected override GH_GetterResult Prompt_Singular(ref GH_Curve value) => GH_GetterResult.cancel;

        protected override GH_GetterResult Prompt_Plural(ref List<GH_Curve> values) => GH_GetterResult.cancel;
    }

    public class Param_Mesh : GH_PersistentGeometryParam<GH_Mesh>, IGH_PreviewObject
    {
        public Param_Mesh() : base("Mesh", "Mesh", "Contains a collection of polygon meshes", "Params", "Geometry")
        {
        }

        public override Guid ComponentGuid => new Guid("1e936df3-0eea-4246-8549-514cb8862b7a");

        public bool Hidden { get; set; }

        public bool IsPreviewCapable => true;

        public BoundingBox ClippingBox => Preview_ComputeClippingBox();

        public void DrawViewportWires(IGH_PreviewArgs args) => Preview_DrawWires(args);

        public void DrawViewportMeshes(IGH_PreviewArgs args) => Preview_DrawMeshes(args);

        protected override GH_GetterResult Prompt_Singular(ref GH_Mesh value) => GH_GetterResult.cancel;

        protected override GH_GetterResult Prompt_Plural(ref List<GH_Mesh> values) => GH_GetterResult.cancel;
    }

    public class Param_Brep : GH_PersistentGeometryParam<GH_Brep>
    {
        public Param_Brep() : base("Brep", "Brep", "Contains a collection of Breps", "Params", "Geometry")
        {
        }

        public override Guid ComponentGuid => new Guid("919e146f-30ae-4aae-be34-4d72f555e7da");

        protected override GH_GetterResult Prompt_Singular(ref GH_Brep value) => GH_GetterResult.cancel;

        protected override GH_GetterResult Prompt_Plural(ref List<GH_Brep> values) => GH_GetterResult.cancel;
    }
}
