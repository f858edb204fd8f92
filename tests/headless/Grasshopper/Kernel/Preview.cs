using System.Drawing;
using Rhino.Display;
using Rhino.Geometry;

namespace Grasshopper.Kernel
{
    public class GH_PreviewWireArgs
    {
        public GH_PreviewWireArgs(RhinoViewport vp, DisplayPipeline pl, Color col, int thickness)
        {
            Viewport = vp;
            Pipeline = pl;
            Color = col;
            Thickness = thickness;
        }

        public RhinoViewport Viewport { get; }

        public DisplayPipeline Pipeline { get; }

        public Color Color { get; }

        public int Thickness { get; }
    }

    public class GH_PreviewMeshArgs
    {
        public GH_PreviewMeshArgs(RhinoViewport vp, DisplayPipeline pl, DisplayMaterial mat, MeshingParameters mp)
        {
            Viewport = vp;
            Pipeline = pl;
            Material = mat;
            MeshingParameters = mp;
        }

        public RhinoViewport Viewport { get; }

        public DisplayPipeline Pipeline { get; }

        public DisplayMaterial Material { get; }

        public MeshingParameters MeshingParameters { get; }
    }

    internal sealed class HeadlessPreviewArgs : IGH_PreviewArgs
    {
        public HeadlessPreviewArgs(GH_Document document, DisplayPipeline display)
        {
            Document = document;
            Display = display;
        }

        public GH_Document Document { get; }

        public DisplayPipeline Display { get; }

        public RhinoViewport Viewport { get; } = new RhinoViewport();

        public Color WireColour { get; set; } = Color.DarkRed;

        public Color WireColour_Selected { get; set; } = Color.DarkGreen;

        public DisplayMaterial ShadeMaterial { get; } = new DisplayMaterial(Color.DarkRed);

        public DisplayMaterial ShadeMaterial_Selected { get; } = new DisplayMaterial(Color.DarkGreen);

        public int DefaultCurveThickness => 1;

        public MeshingParameters MeshingParameters => MeshingParameters.Default;
    }
}
