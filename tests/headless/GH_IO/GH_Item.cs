using System;
using System.Collections.Generic;
using System.Drawing;
using System.Globalization;
using System.Linq;
using System.Xml;

namespace GH_IO.Types
{
    /// <summary>A named value of an archive, with the text forms of .ghx files.</summary>
    public class GH_Item
    {
        internal GH_Item(string name, int index, GH_Types type, object value)
        {
            Name = name;
            Index = index;
            Type = type;
            InternalData = value;
        }

        public string Name { get; set; }

        public int Index { get; set; }

        public GH_Types Type { get; }

        public object InternalData { get; }

        internal void WriteXml(XmlWriter writer)
        {
            writer.WriteStartElement("item");
            writer.WriteAttributeString("name", Name);
            if (Index >= 0) writer.WriteAttributeString("index", Text(Index));
            writer.WriteAttributeString("type_name", Type.ToString());
            writer.WriteAttributeString("type_code", Text((int)Type));
            switch (InternalData)
            {
                case bool b: writer.WriteString(b ? "true" : "false"); break;
                case double d: writer.WriteString(Text(d)); break;
                case float f: writer.WriteString(f.ToString("R", CultureInfo.InvariantCulture)); break;
                case DateTime date: writer.WriteString(date.Ticks.ToString(CultureInfo.InvariantCulture)); break;
                case Guid g: writer.WriteString(g.ToString()); break;
                case string s: writer.WriteString(Kept(s)); break;
                case byte[] bytes:
                    writer.WriteStartElement("stream");
                    writer.WriteAttributeString("length", Text(bytes.Length));
                    writer.WriteString(Convert.ToBase64String(bytes));
                    writer.WriteEndElement();
                    break;
                case GH_Version v: Parts(writer, "Major Minor Revision", Text(v.major), Text(v.minor), Text(v.revision)); break;
                case PointF p: Parts(writer, "X Y", Text(p.X), Text(p.Y)); break;
                case RectangleF r: Parts(writer, "X Y W H", Text(r.X), Text(r.Y), Text(r.Width), Text(r.Height)); break;
                case Color c: Parts(writer, "ARGB", string.Join(";", new[] { c.A, c.R, c.G, c.B }.Select(v => Text(v)))); break;
                case GH_Point3D p: Parts(writer, "X Y Z", Text(p.x), Text(p.y), Text(p.z)); break;
                case GH_Plane p:
                    Parts(writer, "Ox Oy Oz Xx Xy Xz Yx Yy Yz", Text(p.Origin.x), Text(p.Origin.y), Text(p.Origin.z),
                        Text(p.XAxis.x), Text(p.XAxis.y), Text(p.XAxis.z), Text(p.YAxis.x), Text(p.YAxis.y), Text(p.YAxis.z));
                    break;
                default: writer.WriteString(Convert.ToString(InternalData, CultureInfo.InvariantCulture)); break;
            }
            writer.WriteEndElement();
        }

        // The form in XML drops what lies outside the basic plane, and control characters.
        private static string Kept(string text)
            => string.Concat(text.Where(c => !char.IsSurrogate(c) && (c >= ' ' || c == '\t' || c == '\n' || c == '\r')));

        internal static GH_Item ReadXml(XmlElement e)
        {
            var type = (GH_Types)int.Parse(e.GetAttribute("type_code"), CultureInfo.InvariantCulture);
            var index = e.HasAttribute("index") ? int.Parse(e.GetAttribute("index"), CultureInfo.InvariantCulture) : -1;
            return new GH_Item(e.GetAttribute("name"), index, type, Value(type, e));
        }

        private static object Value(GH_Types type, XmlElement e)
        {
            var text = e.InnerText;
            switch (type)
            {
                case GH_Types.gh_bool: return string.Equals(text, "true", StringComparison.OrdinalIgnoreCase);
                case GH_Types.gh_byte: return byte.Parse(text, CultureInfo.InvariantCulture);
                case GH_Types.gh_int32: return int.Parse(text, CultureInfo.InvariantCulture);
                case GH_Types.gh_int64: return long.Parse(text, CultureInfo.InvariantCulture);
                case GH_Types.gh_single: return float.Parse(text, CultureInfo.InvariantCulture);
                case GH_Types.gh_double: return double.Parse(text, CultureInfo.InvariantCulture);
                case GH_Types.gh_decimal: return decimal.Parse(text, CultureInfo.InvariantCulture);
                case GH_Types.gh_date: return new DateTime(long.Parse(text, CultureInfo.InvariantCulture));
                case GH_Types.gh_guid: return new Guid(text);
                case GH_Types.gh_string: return text;
                case GH_Types.gh_bytearray: return Convert.FromBase64String(text);
                case GH_Types.gh_version: return new GH_Version((int)Part(e, "Major"), (int)Part(e, "Minor"), (int)Part(e, "Revision"));
                case GH_Types.gh_drawing_pointf: return new PointF((float)Part(e, "X"), (float)Part(e, "Y"));
                case GH_Types.gh_drawing_rectanglef:
                    return new RectangleF((float)Part(e, "X"), (float)Part(e, "Y"), (float)Part(e, "W"), (float)Part(e, "H"));
                case GH_Types.gh_drawing_color:
                    var c = text.Trim().Split(';').Select(v => int.Parse(v, CultureInfo.InvariantCulture)).ToArray();
                    return Color.FromArgb(c[0], c[1], c[2], c[3]);
                case GH_Types.gh_point3d: return Point(e, "X", "Y", "Z");
                case GH_Types.gh_plane:
                    return new GH_Plane { Origin = Point(e, "Ox", "Oy", "Oz"), XAxis = Point(e, "Xx", "Xy", "Xz"), YAxis = Point(e, "Yx", "Yy", "Yz") };
                default: throw new NotSupportedException("The headless archive does not read items of type " + type + ".");
            }
        }

        private static GH_Point3D Point(XmlElement e, string x, string y, string z) => new GH_Point3D(Part(e, x), Part(e, y), Part(e, z));

        private static double Part(XmlElement e, string name) => double.Parse(e[name].InnerText, CultureInfo.InvariantCulture);

        private static void Parts(XmlWriter writer, string names, params string[] values)
        {
            var all = names.Split(' ');
            for (var i = 0; i < all.Length; i++) writer.WriteElementString(all[i], values[i]);
        }

        private static string Text(int value) => value.ToString(CultureInfo.InvariantCulture);

        private static string Text(float value) => value.ToString("R", CultureInfo.InvariantCulture);

        private static string Text(double value) => value.ToString("R", CultureInfo.InvariantCulture);
    }
}
