using System;
using System.Drawing;
using System.Globalization;
using GH_IO.Serialization;
using GH_IO.Types;
using Rhino.Geometry;

namespace Grasshopper.Kernel.Types
{
    public class GH_Number : GH_Goo<double>
    {
        public GH_Number()
        {
        }

        public GH_Number(double number) : base(number)
        {
        }

        public override bool IsValid => !double.IsNaN(m_value) && !double.IsInfinity(m_value);

        public override string TypeName => "Number";

        public override string TypeDescription => "A double-precision number";

        public override IGH_Goo Duplicate() => new GH_Number(m_value);

        public override string ToString() => m_value.ToString(CultureInfo.InvariantCulture);

        public override bool CastFrom(object source) => Casting.ToDouble(source, out m_value);

        public override bool CastTo<Q>(ref Q target) => Casting.FromNumber(m_value, ref target);

        public override bool Write(GH_IWriter writer)
        {
            writer.SetDouble("number", m_value);
            return true;
        }

        public override bool Read(GH_IReader reader) => reader.TryGetDouble("number", ref m_value);
    }

    public class GH_Guid : GH_Goo<Guid>
    {
        public override bool IsValid => true;

        public override string TypeName => "Guid";

        public override string TypeDescription => "A globally unique identifier";

        public override IGH_Goo Duplicate() => new GH_Guid { m_value = m_value };

        public override string ToString() => m_value.ToString();

        public override bool CastFrom(object source)
        {
            if (!(Casting.Bare(source) is Guid id)) return false;
            m_value = id;
            return true;
        }

        public override bool CastTo<Q>(ref Q target) => Casting.Give(m_value, ref target);
    }

    public class GH_Integer : GH_Goo<int>
    {
        public GH_Integer()
        {
        }

        public GH_Integer(int number) : base(number)
        {
        }

        public override bool IsValid => true;

        public override string TypeName => "Integer";

        public override string TypeDescription => "A 32-bit integer";

        public override IGH_Goo Duplicate() => new GH_Integer(m_value);

        public override string ToString() => m_value.ToString(CultureInfo.InvariantCulture);

        public override bool CastFrom(object source) => Casting.ToInt(source, out m_value);

        public override bool CastTo<Q>(ref Q target) => Casting.FromNumber(m_value, ref target);

        public override bool Write(GH_IWriter writer)
        {
            writer.SetInt32("number", m_value);
            return true;
        }

        public override bool Read(GH_IReader reader) => reader.TryGetInt32("number", ref m_value);
    }

    public class GH_Boolean : GH_Goo<bool>
    {
        public GH_Boolean()
        {
        }

        internal GH_Boolean(bool value) : base(value)
        {
        }

        public override bool IsValid => true;

        public override string TypeName => "Boolean";

        public override string TypeDescription => "A boolean value";

        public override IGH_Goo Duplicate() => new GH_Boolean(m_value);

        public override string ToString() => m_value ? "True" : "False";

        public override bool CastFrom(object source)
        {
            if (Casting.Bare(source) is string text) return bool.TryParse(text, out m_value);
            if (Casting.Bare(source) is bool flag)
            {
                m_value = flag;
                return true;
            }
            if (!Casting.ToDouble(source, out var number)) return false;
            m_value = number != 0;
            return true;
        }

        public override bool CastTo<Q>(ref Q target) => Casting.FromNumber(m_value ? 1 : 0, ref target);

        public override bool Write(GH_IWriter writer)
        {
            writer.SetBoolean("boolean", m_value);
            return true;
        }

        public override bool Read(GH_IReader reader) => reader.TryGetBoolean("boolean", ref m_value);
    }

    public class GH_String : GH_Goo<string>
    {
        public GH_String()
        {
        }

        public GH_String(string value) : base(value)
        {
        }

        public override bool IsValid => m_value != null;

        public override string TypeName => "Text";

        public override string TypeDescription => "Text";

        public override IGH_Goo Duplicate() => new GH_String(m_value);

        public override string ToString() => m_value ?? "";

        public override bool CastFrom(object source)
        {
            m_value = source is IGH_Goo goo ? goo.ToString() : Convert.ToString(source, CultureInfo.InvariantCulture);
            return m_value != null;
        }

        public override bool Write(GH_IWriter writer)
        {
            writer.SetString("string", m_value);
            return true;
        }

        public override bool Read(GH_IReader reader) => reader.TryGetString("string", ref m_value);
    }

    public class GH_Colour : GH_Goo<Color>
    {
        public GH_Colour()
        {
        }

        internal GH_Colour(Color colour) : base(colour)
        {
        }

        public override bool IsValid => true;

        public override string TypeName => "Colour";

        public override string TypeDescription => "An ARGB colour";

        public override IGH_Goo Duplicate() => new GH_Colour(m_value);

        public override string ToString() => string.Format(CultureInfo.InvariantCulture, "{0},{1},{2} ({3})", m_value.R, m_value.G, m_value.B, m_value.A);

        public override bool CastFrom(object source)
        {
            if (!(Casting.Bare(source) is Color colour)) return false;
            m_value = colour;
            return true;
        }
    }

    public class GH_ObjectWrapper : GH_Goo<object>
    {
        public GH_ObjectWrapper()
        {
        }

        internal GH_ObjectWrapper(object obj) : base(obj)
        {
        }

        public override bool IsValid => m_value != null;

        public override string TypeName => m_value == null ? "Null" : m_value.GetType().Name;

        public override string TypeDescription => "Any object";

        public override IGH_Goo Duplicate() => new GH_ObjectWrapper(m_value);

        public override string ToString() => m_value == null ? "" : m_value.ToString();

        public override bool CastFrom(object source)
        {
            m_value = source;
            return source != null;
        }
    }

    public class GH_Vector : GH_Goo<Vector3d>
    {
        public GH_Vector()
        {
        }

        internal GH_Vector(Vector3d vector) : base(vector)
        {
        }

        public override bool IsValid => m_value.IsValid;

        public override string TypeName => "Vector";

        public override string TypeDescription => "A 3D vector";

        public override IGH_Goo Duplicate() => new GH_Vector(m_value);

        public override string ToString() => "{" + m_value + "}";

        public override bool CastFrom(object source)
        {
            if (Casting.Bare(source) is Vector3d vector) m_value = vector;
            else if (Casting.Bare(source) is Point3d point) m_value = new Vector3d(point);
            else return false;
            return true;
        }
    }
}
