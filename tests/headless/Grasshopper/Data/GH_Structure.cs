using System.Collections;
using System.Collections.Generic;
using System.Linq;
using GH_IO;
using GH_IO.Serialization;
using Grasshopper.Kernel.Types;

namespace Grasshopper.Kernel.Data
{
    public interface IGH_Structure
    {
        int PathCount { get; }

        int DataCount { get; }

        bool IsEmpty { get; }

        IList<GH_Path> Paths { get; }

        GH_Path get_Path(int index);

        IList get_Branch(int index);

        IList get_Branch(GH_Path path);

        bool PathExists(GH_Path path);

        void Clear();
    }

    public class GH_Structure<T> : IGH_Structure, GH_ISerializable
        where T : IGH_Goo
    {
        private readonly SortedList<GH_Path, List<T>> _branches = new SortedList<GH_Path, List<T>>();

        public int PathCount => _branches.Count;

        public int DataCount => _branches.Values.Sum(b => b.Count);

        public bool IsEmpty => DataCount == 0;

        public IList<GH_Path> Paths => _branches.Keys.ToList();

        public List<List<T>> Branches => _branches.Values.ToList();

        public GH_Path get_Path(int index) => _branches.Keys[index];

        public IList get_Branch(int index) => _branches.Values[index];

        public IList get_Branch(GH_Path path) => _branches.TryGetValue(path, out var branch) ? branch : null;

        public bool PathExists(GH_Path path) => _branches.ContainsKey(path);

        public List<T> EnsurePath(GH_Path path)
        {
            if (!_branches.TryGetValue(path, out var branch)) _branches.Add(new GH_Path(path), branch = new List<T>());
            return branch;
        }

        public void Append(T data) => Append(data, PathCount == 0 ? new GH_Path(0) : _branches.Keys.Last());

        public void Append(T data, GH_Path path) => EnsurePath(path).Add(data);

        public void AppendRange(IEnumerable<T> data, GH_Path path) => EnsurePath(path).AddRange(data);

        public void Insert(T data, GH_Path path, int index)
        {
            var branch = EnsurePath(path);
            while (branch.Count <= index) branch.Add(default);
            branch[index] = data;
        }

        public void Clear() => _branches.Clear();

        public GH_Structure<T> ShallowDuplicate()
        {
            var copy = new GH_Structure<T>();
            foreach (var branch in _branches) copy.AppendRange(branch.Value, branch.Key);
            return copy;
        }

        public IEnumerable<IGH_Goo> AllData(bool skipNulls) => _branches.Values.SelectMany(b => b).Where(g => !skipNulls || g != null).Cast<IGH_Goo>();

        public bool Write(GH_IWriter writer)
        {
            writer.SetInt32("Count", PathCount);
            var b = 0;
            foreach (var branch in _branches)
            {
                var chunk = writer.CreateChunk("Branch", b++);
                chunk.SetString("Path", branch.Key.ToString());
                chunk.SetInt32("Count", branch.Value.Count);
                for (var i = 0; i < branch.Value.Count; i++)
                {
                    var item = chunk.CreateChunk("Item", i);
                    if (branch.Value[i] == null) continue;
                    if (typeof(T).IsInterface) item.SetString("TypeName", branch.Value[i].GetType().AssemblyQualifiedName);
                    branch.Value[i].Write(item);
                }
            }
            return true;
        }

        public bool Read(GH_IReader reader)
        {
            Clear();
            for (var b = 0; b < reader.GetInt32("Count"); b++)
            {
                var chunk = reader.FindChunk("Branch", b);
                var branch = EnsurePath(GH_Path.Parse(chunk.GetString("Path")));
                for (var i = 0; i < chunk.GetInt32("Count"); i++)
                {
                    var item = chunk.FindChunk("Item", i);
                    var type = typeof(T);
                    if (type.IsInterface) type = item.ItemExists("TypeName") ? System.Type.GetType(item.GetString("TypeName")) : null;
                    if (type == null || item.ItemCount + item.ChunkCount == 0)
                    {
                        branch.Add(default);
                        continue;
                    }
                    var goo = (T)System.Activator.CreateInstance(type);
                    branch.Add(goo.Read(item) ? goo : default);
                }
            }
            return true;
        }
    }
}
