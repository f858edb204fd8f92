using System;
using System.Collections.Generic;
using System.Drawing;
using System.Linq;
using Rhino.Geometry;

namespace Rhino.Display
{
    public class DisplayMaterial
    {
        public DisplayMaterial()
        {
        }

        public DisplayMaterial(Color diffuse) => Diffuse = diffuse;

        public Color Diffuse { get; set; }
    }

    public enum PointStyle
    {
        Simple = 0,
        ControlPoint = 1,
    }

    public class RhinoViewport
    {
        internal RhinoViewport()
        {
        }
    }

    internal sealed class DrawCall
    {
        public DrawCall(string what, Color color, object item, int thickness)
        {
            What = what;
            Color = color;
            Item = item;
            Thickness = thickness;
        }

        public string What { get; }

        public Color Color { get; }

        public object Item { get; }

        public int Thickness { get; }

        public DisplayMaterial Material { get; set; }
    }

    /// <summary>Records what is drawn.</summary>
    public sealed class DisplayPipeline
    {
        internal readonly List<DrawCall> Calls = new List<DrawCall>();

        internal DisplayPipeline()
        {
        }

        public void DrawCurve(Curve curve, Color color) => DrawCurve(curve, color, 1);

        public void DrawCurve(Curve curve, Color color, int thickness) => Calls.Add(new DrawCall("curve", color, curve, thickness));

        public void DrawPolyline(IEnumerable<Point3d> polyline, Color color, int thickness)
            => Calls.Add(new DrawCall("polyline", color, polyline.ToArray(), thickness));

        public void DrawLine(Point3d from, Point3d to, Color color, int thickness) => Calls.Add(new DrawCall("line", color, new Line(from, to), thickness));

        public void DrawLines(IEnumerable<Line> lines, Color color, int thickness)
            => Calls.Add(new DrawCall("lines", color, lines as Line[] ?? lines.ToArray(), thickness));

        public void DrawPoints(IEnumerable<Point3d> points, PointStyle style, int radius, Color color)
            => Calls.Add(new DrawCall("points", color, points as Point3d[] ?? points.ToArray(), radius));

        public void DrawBox(BoundingBox box, Color color, int thickness) => Calls.Add(new DrawCall("box", color, box, thickness));

        public void DrawMeshShaded(Mesh mesh, DisplayMaterial material) => Calls.Add(new DrawCall("shaded", material.Diffuse, mesh, 0) { Material = material });

        public void DrawMeshFalseColors(Mesh mesh) => Calls.Add(new DrawCall("colours", Color.Empty, mesh, 0));

        public void DrawMeshWires(Mesh mesh, Color color) => Calls.Add(new DrawCall("wires", color, mesh, 1));
    }
}
