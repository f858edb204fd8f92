using System;
using System.Drawing;
using System.Globalization;
using Rhino.Geometry;

namespace Grasshopper.Kernel.Types
{
    /// <summary>The order of conversions: the source's CastTo first, then the target's CastFrom.</summary>
    internal static class Casting
    {
        public static object Bare(object source) => source is IGH_Goo goo ? goo.ScriptVariable() : source;

        public static bool ToDouble(object source, out double number)
        {
            number = 0;
            switch (Bare(source))
            {
                case double d: number = d; return true;
                case float f: number = f; return true;
                case int i: number = i; return true;
                case long l: number = l; return true;
                case bool b: number = b ? 1 : 0; return true;
                case string s: return double.TryParse(s, NumberStyles.Float, CultureInfo.InvariantCulture, out number);
                default: return false;
            }
        }

        public static bool ToInt(object source, out int number)
        {
            number = 0;
            if (!ToDouble(source, out var value) || double.IsNaN(value) || Math.Abs(value) > int.MaxValue) return false;
            number = (int)Math.Round(value);
            return true;
        }

        public static bool FromNumber<Q>(double number, ref Q target)
        {
            object value;
            if (typeof(Q) == typeof(double)) value = number;
            else if (typeof(Q) == typeof(int)) value = (int)Math.Round(number);
            else if (typeof(Q) == typeof(bool)) value = number != 0;
            else if (typeof(Q) == typeof(string)) value = number.ToString(CultureInfo.InvariantCulture);
            else return false;
            target = (Q)value;
            return true;
        }

        public static bool Give<T, Q>(T value, ref Q target)
        {
            if (!(value is Q given)) return false;
            target = given;
            return true;
        }

        /// <summary>Wraps any object in the goo that Grasshopper has for it.</summary>
        public static IGH_Goo Wrap(object data)
        {
            switch (data)
            {
                case null: return null;
                case IGH_Goo goo: return goo;
                case double d: return new GH_Number(d);
                case float f: return new GH_Number(f);
                case int i: return new GH_Integer(i);
                case bool b: return new GH_Boolean(b);
                case string s: return new GH_String(s);
                case Color c: return new GH_Colour(c);
                case Vector3d v: return new GH_Vector(v);
                case Point3d p: return new GH_Point(p);
                case Plane p: return new GH_Plane(p);
                case Curve c: return new GH_Curve(c);
                case Line l: return new GH_Line(l);
                case Arc a: return new GH_Arc(a);
                case Circle c: return new GH_Circle(c);
                case Polyline p: return new GH_Curve(p.ToPolylineCurve());
                case Mesh m: return new GH_Mesh(m);
                case Brep b: return new GH_Brep(b);
                case Box b: return new GH_Box(b);
                case GeometryBase g: return new AnyGeometry(g);
                default: return new GH_ObjectWrapper(data);
            }
        }

        /// <summary>Data as goo of a type, or null where no conversion exists.</summary>
        public static T ToGoo<T>(object data, Func<T> make)
            where T : class, IGH_Goo
        {
            var goo = Wrap(data);
            if (goo is T same) return same;
            if (goo == null || typeof(T).IsInterface) return null;
            if (goo.CastTo<T>(out var cast) && cast != null) return cast;
            var made = make();
            if (made == null) return null;
            return made.CastFrom(goo) ? made : null;
        }

        /// <summary>Goo as what a component asks for: the goo itself, its bare value, or through the goo's own conversion.</summary>
        public static bool ToBare<T>(IGH_Goo goo, out T value)
        {
            value = default;
            if (goo == null) return false;
            if (goo is T same) value = same;
            else if (goo.ScriptVariable() is T bare) value = bare;
            else if (!goo.CastTo(out value)) return false;
            return value != null;
        }
    }
}
