using System;
using Rhino.DocObjects;
using Rhino.Runtime;

namespace Rhino.Runtime
{
    public abstract class CommonObject : IDisposable
    {
        public bool IsValid => CheckValid();

        public static CommonObject FromBase64String(int archive3dm, int opennurbs, string base64Data)
            => Geometry.OpenNurbs.Read(Convert.FromBase64String(base64Data));

        public void Dispose()
        {
        }

        internal virtual bool CheckValid() => true;
    }
}

namespace Rhino.Geometry
{
    public abstract class GeometryBase : CommonObject
    {
        public ObjectType ObjectType => KindOf();

        public virtual GeometryBase Duplicate() => CopyOf();

        public bool Transform(Transform xform)
        {
            Map(xform);
            return true;
        }

        public bool Scale(double scaleFactor) => Transform(Geometry.Transform.Scale(Point3d.Origin, scaleFactor));

        public bool Translate(Vector3d translationVector) => Transform(Geometry.Transform.Translation(translationVector));

        public BoundingBox GetBoundingBox(bool accurate) => Box(Geometry.Transform.Identity);

        public virtual BoundingBox GetBoundingBox(Transform xform) => Box(xform);

        public uint DataCRC(uint currentRemainder)
        {
            var hash = currentRemainder ^ 2166136261;
            foreach (var value in Numbers())
            {
                foreach (var part in BitConverter.GetBytes(value)) hash = unchecked((hash ^ part) * 16777619);
            }
            return hash;
        }

        internal abstract ObjectType KindOf();

        internal abstract GeometryBase CopyOf();

        internal abstract void Map(Transform xform);

        internal abstract BoundingBox Box(Transform xform);

        internal abstract System.Collections.Generic.IEnumerable<double> Numbers();

        internal static NotSupportedException NeedsRhino(string what) => new NotSupportedException(what + " needs Rhino: the headless host cannot do it.");
    }

    public abstract class SpaceMorph
    {
        public abstract Point3d MorphPoint(Point3d point);
    }
}
