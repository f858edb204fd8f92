using System;
using System.Collections.Generic;
using System.Drawing;
using System.Linq;
using Rhino.DocObjects;
using Rhino.DocObjects.Tables;
using Rhino.Geometry;

namespace Rhino
{
    /// <summary>A document that keeps what is added to it, and the undo records around that.</summary>
    public sealed class RhinoDoc
    {
        internal readonly List<string> UndoRecords = new List<string>();
        private uint _openRecord;

        internal RhinoDoc()
        {
            Objects = new ObjectTable(this);
            Layers = new LayerTable();
            InstanceDefinitions = new InstanceDefinitionTable(this);
        }

        // Tests run side by side: each thread has its own.
        [ThreadStatic]
        private static RhinoDoc s_activeDoc;

        public static RhinoDoc ActiveDoc
        {
            get => s_activeDoc;
            set => s_activeDoc = value;
        }

        public UnitSystem ModelUnitSystem { get; set; } = UnitSystem.Millimeters;

        // Meters of a custom unit.
        internal double CustomUnit { get; set; } = 1;

        public bool GetCustomUnitSystem(bool modelUnits, out string customUnitName, out double metersPerCustomUnit)
        {
            customUnitName = "custom units";
            metersPerCustomUnit = CustomUnit;
            return ModelUnitSystem == UnitSystem.CustomUnits;
        }

        public double ModelAbsoluteTolerance { get; set; } = 0.01;

        public uint RuntimeSerialNumber => 1;

        public ObjectTable Objects { get; }

        public LayerTable Layers { get; }

        public GroupTable Groups { get; } = new GroupTable();

        public InstanceDefinitionTable InstanceDefinitions { get; }

        public ViewTable Views { get; } = new ViewTable();

        public ObjectAttributes CreateDefaultAttributes() => new ObjectAttributes { LayerIndex = Layers.CurrentLayerIndex };

        internal bool IsRecording => _openRecord != 0;

        public uint BeginUndoRecord(string description)
        {
            if (_openRecord != 0) return 0;
            UndoRecords.Add(description);
            return _openRecord = (uint)UndoRecords.Count;
        }

        public bool EndUndoRecord(uint undoRecordSerialNumber)
        {
            if (undoRecordSerialNumber == 0 || undoRecordSerialNumber != _openRecord) return false;
            _openRecord = 0;
            return true;
        }
    }
}

namespace Rhino.DocObjects.Tables
{
    public sealed class ObjectTable
    {
        internal readonly List<RhinoObject> Items = new List<RhinoObject>();

        // For each object, the undo record it was added in, or null.
        internal readonly List<string> Records = new List<string>();
        private readonly RhinoDoc _doc;

        internal ObjectTable(RhinoDoc doc) => _doc = doc;

        public int Count => Items.Count;

        public Guid Add(GeometryBase geometry, ObjectAttributes attributes)
            => geometry == null || !geometry.IsValid ? Guid.Empty
                : Add(new RhinoObject(geometry.Duplicate(), attributes?.Duplicate() ?? new ObjectAttributes()));

        public Guid AddInstanceObject(int instanceDefinitionIndex, Transform instanceXform, ObjectAttributes attributes)
            => Add(new InstanceObject(_doc.InstanceDefinitions.Items[instanceDefinitionIndex], attributes.Duplicate()));

        public RhinoObject FindId(Guid id) => Items.Find(i => i.Id == id);

        private Guid Add(RhinoObject item)
        {
            item.Attributes.ObjectId = item.Id;
            Items.Add(item);
            Records.Add(_doc.IsRecording ? _doc.UndoRecords[_doc.UndoRecords.Count - 1] : null);
            return item.Id;
        }

        public bool Delete(Guid objectId, bool quiet)
        {
            var at = Items.FindIndex(i => i.Id == objectId);
            if (at < 0) return false;
            Items.RemoveAt(at);
            Records.RemoveAt(at);
            return true;
        }

        public RhinoObject[] FindByUserString(string key, string value, bool caseSensitive)
            => Items.Where(i => string.Equals(i.Attributes.GetUserString(key), value,
                caseSensitive ? StringComparison.Ordinal : StringComparison.OrdinalIgnoreCase)).ToArray();

        public Guid AddCurve(Curve curve, ObjectAttributes attributes) => Add(curve, attributes);

        public Guid AddMesh(Mesh mesh, ObjectAttributes attributes) => Add(mesh, attributes);

        public Guid AddPolyline(IEnumerable<Point3d> points, ObjectAttributes attributes) => Add(new PolylineCurve(points), attributes);
    }

    public sealed class InstanceDefinitionTable
    {
        internal readonly List<InstanceDefinition> Items = new List<InstanceDefinition>();
        private readonly RhinoDoc _doc;

        internal InstanceDefinitionTable(RhinoDoc doc) => _doc = doc;

        public string GetUnusedInstanceDefinitionName(string root)
        {
            var name = root;
            for (var i = 1; Items.Any(d => d != null && d.Name == name); i++) name = root + " " + i;
            return name;
        }

        public int Add(string name, string description, Point3d basePoint, IEnumerable<GeometryBase> geometry, IEnumerable<ObjectAttributes> attributes)
        {
            if (Items.Any(d => d != null && d.Name == name)) return -1;
            Items.Add(new InstanceDefinition(Items.Count, name, geometry.ToArray(), attributes.ToArray()));
            return Items.Count - 1;
        }

        public bool Delete(int idefIndex, bool deleteReferences, bool quiet)
        {
            foreach (var item in _doc.Objects.Items.OfType<InstanceObject>().Where(o => o.InstanceDefinition.Index == idefIndex).ToList())
                _doc.Objects.Delete(item.Id, quiet);
            Items[idefIndex] = null;
            return true;
        }
    }

    public sealed class ViewTable
    {
        internal ViewTable()
        {
        }

        public bool RedrawEnabled { get; set; } = true;

        public void Redraw()
        {
        }
    }

    public sealed class GroupTable
    {
        internal readonly List<string> Names = new List<string>();

        internal GroupTable()
        {
        }

        public int Find(string groupName) => Names.IndexOf(groupName);

        public int Add(string groupName)
        {
            Names.Add(groupName);
            return Names.Count - 1;
        }
    }

    public sealed class LayerTable
    {
        internal readonly List<Layer> Items = new List<Layer> { new Layer { Name = "Default", FullPath = "Default", Color = Color.Black } };

        internal LayerTable()
        {
        }

        public int Count => Items.Count;

        public int CurrentLayerIndex => 0;

        public int FindByFullPath(string layerPath, int notFoundReturnValue)
        {
            var at = Items.FindIndex(l => string.Equals(l.FullPath, layerPath, StringComparison.OrdinalIgnoreCase));
            return at < 0 ? notFoundReturnValue : at;
        }

        public Layer FindIndex(int index) => index >= 0 && index < Items.Count ? Items[index] : null;

        public int Add(Layer layer)
        {
            var parent = Items.FirstOrDefault(l => l.Id == layer.ParentLayerId && layer.ParentLayerId != Guid.Empty);
            var path = parent == null ? layer.Name : parent.FullPath + "::" + layer.Name;
            if (string.IsNullOrEmpty(layer.Name) || FindByFullPath(path, -1) >= 0) return -1;
            Items.Add(new Layer { Name = layer.Name, Color = layer.Color, ParentLayerId = layer.ParentLayerId, FullPath = path });
            return Items.Count - 1;
        }
    }
}
