using System;
using GH_IO;
using GH_IO.Serialization;
using Rhino.Geometry;

namespace Grasshopper.Kernel.Types
{
    public interface IGH_Goo : GH_ISerializable
    {
        bool IsValid { get; }

        string IsValidWhyNot { get; }

        string TypeName { get; }

        string TypeDescription { get; }

        IGH_Goo Duplicate();

        string ToString();

        object ScriptVariable();

        bool CastTo<T>(out T target);

        bool CastFrom(object source);
    }

    public abstract class GH_Goo<T> : IGH_Goo
    {
        protected T m_value;

        protected GH_Goo()
        {
        }

        protected GH_Goo(T internal_data) => m_value = internal_data;

        public virtual T Value
        {
            get => m_value;
            set => m_value = value;
        }

        public abstract bool IsValid { get; }

        public virtual string IsValidWhyNot => IsValid ? string.Empty : "This " + TypeName + " is not valid.";

        public abstract string TypeName { get; }

        public abstract string TypeDescription { get; }

        public abstract IGH_Goo Duplicate();

        public abstract override string ToString();

        public virtual object ScriptVariable() => Value;

        public virtual bool CastTo<Q>(ref Q target) => false;

        public virtual bool CastFrom(object source) => false;

        public virtual bool Write(GH_IWriter writer) => true;

        public virtual bool Read(GH_IReader reader) => true;

        bool IGH_Goo.CastTo<Q>(out Q target)
        {
            target = default;
            return CastTo(ref target);
        }
    }

    public interface IGH_GeometricGoo : IGH_Goo
    {
        BoundingBox Boundingbox { get; }

        Guid ReferenceID { get; set; }

        bool IsReferencedGeometry { get; }

        IGH_GeometricGoo DuplicateGeometry();

        BoundingBox GetBoundingBox(Transform xform);

        IGH_GeometricGoo Transform(Transform xform);

        IGH_GeometricGoo Morph(SpaceMorph xmorph);
    }

    public abstract class GH_GeometricGoo<T> : GH_Goo<T>, IGH_GeometricGoo
    {
        protected GH_GeometricGoo()
        {
        }

        protected GH_GeometricGoo(T internal_data) : base(internal_data)
        {
        }

        public override bool IsValid => m_value != null;

        public virtual Guid ReferenceID { get; set; }

        public virtual bool IsReferencedGeometry => ReferenceID != Guid.Empty;

        public abstract BoundingBox Boundingbox { get; }

        public override IGH_Goo Duplicate() => DuplicateGeometry();

        public abstract IGH_GeometricGoo DuplicateGeometry();

        public abstract BoundingBox GetBoundingBox(Transform xform);

        public abstract IGH_GeometricGoo Transform(Transform xform);

        public abstract IGH_GeometricGoo Morph(SpaceMorph xmorph);
    }
}
