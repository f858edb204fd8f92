using System;
using System.Drawing;
using Rhino.Runtime;

namespace Rhino.DocObjects
{
    [Flags]
    public enum ObjectType : uint
    {
        None = 0,
        Point = 1,
        Curve = 4,
        Surface = 8,
        Brep = 16,
        Mesh = 32,
        SubD = 262144,
        Extrusion = 1073741824,
    }

    public enum ObjectColorSource
    {
        ColorFromLayer = 0,
        ColorFromObject = 1,
        ColorFromMaterial = 2,
        ColorFromParent = 3,
    }

    public abstract class ModelComponent : CommonObject
    {
        public virtual Guid Id { get; set; } = Guid.NewGuid();

        public virtual string Name { get; set; }
    }

    public sealed class Layer : ModelComponent
    {
        public override string Name { get; set; }

        public override Guid Id { get; set; } = Guid.NewGuid();

        public Guid ParentLayerId { get; set; }

        public Color Color { get; set; }

        public string FullPath { get; internal set; }
    }

    public class ObjectAttributes : CommonObject
    {
        public Guid ObjectId { get; set; }

        public string Name { get; set; }

        public int LayerIndex { get; set; }

        public Color ObjectColor { get; set; }

        public ObjectColorSource ColorSource { get; set; }

        public ObjectAttributes Duplicate() => (ObjectAttributes)MemberwiseClone();
    }

    public class RhinoObject : ModelComponent
    {
        internal RhinoObject(Geometry.GeometryBase geometry, ObjectAttributes attributes)
        {
            Geometry = geometry;
            Attributes = attributes;
        }

        public Geometry.GeometryBase Geometry { get; }

        public ObjectAttributes Attributes { get; }
    }
}
