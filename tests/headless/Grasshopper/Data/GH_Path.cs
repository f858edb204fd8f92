using System;
using System.Globalization;
using System.Linq;

namespace Grasshopper.Kernel.Data
{
    public class GH_Path : IComparable<GH_Path>
    {
        public GH_Path(params int[] args) => Indices = (int[])args.Clone();

        public GH_Path(GH_Path other) : this(other.Indices)
        {
        }

        public int[] Indices { get; set; }

        public int Length => Indices.Length;

        public GH_Path AppendElement(int index) => new GH_Path(Indices.Concat(new[] { index }).ToArray());

        public GH_Path CullElement() => new GH_Path(Indices.Take(Indices.Length - 1).ToArray());

        public int CompareTo(GH_Path other)
        {
            for (var i = 0; i < Math.Min(Length, other.Length); i++)
            {
                if (Indices[i] != other.Indices[i]) return Indices[i].CompareTo(other.Indices[i]);
            }
            return Length.CompareTo(other.Length);
        }

        public override bool Equals(object obj) => obj is GH_Path other && CompareTo(other) == 0;

        public override int GetHashCode() => Indices.Aggregate(17, (hash, i) => unchecked(hash * 31 + i));

        public override string ToString() => "{" + string.Join(";", Indices.Select(i => i.ToString(CultureInfo.InvariantCulture))) + "}";

        internal static GH_Path Parse(string text)
            => new GH_Path(text.Trim('{', '}').Split(';').Select(p => int.Parse(p, CultureInfo.InvariantCulture)).ToArray());
    }
}
