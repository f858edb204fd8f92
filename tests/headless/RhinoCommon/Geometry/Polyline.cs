using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Rhino.Collections;

namespace Rhino.Collections
{
    public class RhinoList<T> : IList<T>
    {
        private readonly List<T> _items = new List<T>();

        public RhinoList()
        {
        }

        public RhinoList(IEnumerable<T> collection) => _items.AddRange(collection);

        public int Count => _items.Count;

        public T First => _items[0];

        public T Last => _items[_items.Count - 1];

        bool ICollection<T>.IsReadOnly => false;

        public T this[int index]
        {
            get => _items[index];
            set => _items[index] = value;
        }

        public void Add(T item) => _items.Add(item);

        public void AddRange(IEnumerable<T> collection) => _items.AddRange(collection);

        public void Clear() => _items.Clear();

        public bool Contains(T item) => _items.Contains(item);

        public void CopyTo(T[] array, int arrayIndex) => _items.CopyTo(array, arrayIndex);

        public int IndexOf(T item) => _items.IndexOf(item);

        public void Insert(int index, T item) => _items.Insert(index, item);

        public bool Remove(T item) => _items.Remove(item);

        public void RemoveAt(int index) => _items.RemoveAt(index);

        public T[] ToArray() => _items.ToArray();

        public IEnumerator<T> GetEnumerator() => _items.GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
    }

    public class Point3dList : RhinoList<Geometry.Point3d>
    {
        public Point3dList()
        {
        }

        public Point3dList(IEnumerable<Geometry.Point3d> collection) : base(collection)
        {
        }

        public Geometry.BoundingBox BoundingBox => new Geometry.BoundingBox(this);

        public void Add(double x, double y, double z) => Add(new Geometry.Point3d(x, y, z));
    }
}

namespace Rhino.Geometry
{
    public class Polyline : Point3dList
    {
        public Polyline()
        {
        }

        public Polyline(IEnumerable<Point3d> collection) : base(collection)
        {
        }

        public bool IsValid => Count > 1 && Enumerable.Range(1, Count - 1).All(i => this[i] != this[i - 1]);

        public bool IsClosed => Count > 2 && this[0] == this[Count - 1];

        public int SegmentCount => Math.Max(Count - 1, 0);

        public double Length
        {
            get
            {
                var sum = 0.0;
                for (var i = 1; i < Count; i++) sum += this[i].DistanceTo(this[i - 1]);
                return sum;
            }
        }

        public Polyline Duplicate() => new Polyline(this);

        public PolylineCurve ToPolylineCurve() => new PolylineCurve(this);
    }
}
