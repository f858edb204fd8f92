using System;
using System.Collections.Generic;
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

    public enum ObjectPlotWeightSource
    {
        PlotWeightFromLayer = 0,
        PlotWeightFromObject = 1,
        PlotWeightFromParent = 3,
    }

    public abstract class ModelComponent : CommonObject
    {
        public virtual Guid Id { get; set; } = Guid.NewGuid();

        public virtual string Name { get; set; }

        public virtual int Index { get; set; }
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

        public double PlotWeight { get; set; }

        public ObjectPlotWeightSource PlotWeightSource { get; set; }

        internal Dictionary<string, string> UserStrings { get; private set; } = new Dictionary<string, string>();

        internal List<int> Groups { get; private set; } = new List<int>();

        public int GroupCount => Groups.Count;

        public bool SetUserString(string key, string value)
        {
            UserStrings[key] = value;
            return true;
        }

        public string GetUserString(string key) => UserStrings.TryGetValue(key, out var value) ? value : null;

        public void AddToGroup(int groupIndex) => Groups.Add(groupIndex);

        public ObjectAttributes Duplicate()
        {
            var copy = (ObjectAttributes)MemberwiseClone();
            copy.UserStrings = new Dictionary<string, string>(UserStrings);
            copy.Groups = new List<int>(Groups);
            return copy;
        }
    }

    public class RhinoObject : ModelComponent
    {
        internal RhinoObject(Geometry.GeometryBase geometry, ObjectAttributes attributes)
        {
            Geometry = geometry;
            Attributes = attributes;
        }

        public virtual Geometry.GeometryBase Geometry { get; }

        public ObjectAttributes Attributes { get; }

        // The document does not keep what is deleted.
        public bool IsDeleted => false;
    }

    public class ObjRef
    {
        private readonly Geometry.GeometryBase _geometry;

        internal ObjRef(Geometry.GeometryBase geometry) => _geometry = geometry;

        public Geometry.Curve Curve() => _geometry as Geometry.Curve;
    }

    public sealed class InstanceDefinition : ModelComponent
    {
        internal readonly Geometry.GeometryBase[] Parts;
        internal readonly ObjectAttributes[] PartAttributes;

        internal InstanceDefinition(int index, string name, Geometry.GeometryBase[] parts, ObjectAttributes[] attributes)
        {
            Index = index;
            Name = name;
            Parts = parts;
            PartAttributes = attributes;
        }

        public override int Index { get; set; }
    }

    public class InstanceObject : RhinoObject
    {
        internal InstanceObject(InstanceDefinition definition, ObjectAttributes attributes)
            : base(null, attributes) => InstanceDefinition = definition;

        public InstanceDefinition InstanceDefinition { get; }
    }
}
