using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Types;

namespace Grasshopper.Kernel
{
    /// <summary>
    /// Runs a component once per combination of data: branches are matched by position, the last branch repeats; inside a branch items are matched by the
    /// longest list, the last item repeats; a list input takes part once per branch; a tree input is outside of all this.
    /// </summary>
    internal sealed class SolveLoop : IGH_DataAccess
    {
        // Where outputs go is not documented for every mix of inputs: a test may send them elsewhere.
        internal static Func<GH_Path, GH_Path> Target = path => path;

        // Nor whether a tree that a component gives is copied.
        internal static bool SharesTrees;

        // Nor whether grafting keeps empty branches.
        internal static bool GraftKeepsEmpty;

        private readonly GH_Component _component;
        private readonly List<IGH_Param> _matched;
        private readonly bool _anyItems;
        private readonly HashSet<int> _set = new HashSet<int>();
        private GH_Path _path = new GH_Path(0);
        private int _branch;
        private int _item;
        private bool _aborted;

        public SolveLoop(GH_Component component)
        {
            _component = component;
            _matched = component.Params.Input.Where(p => p.Access != GH_ParamAccess.tree && p.VolatileData.PathCount > 0).ToList();
            _anyItems = component.Params.Input.Any(p => p.Access == GH_ParamAccess.item);
        }

        public int Iteration { get; private set; }

        public void Run(Action<IGH_DataAccess> solve)
        {
            var branches = _matched.Count == 0 ? 1 : _matched.Max(p => p.VolatileData.PathCount);
            // Outputs follow the input with the most branches, or of those the one with the longest paths.
            var principal = _matched.OrderByDescending(p => p.VolatileData.PathCount).ThenByDescending(p => p.VolatileData.get_Path(0).Length).FirstOrDefault();
            for (_branch = 0; _branch < branches; _branch++)
            {
                _path = principal == null ? new GH_Path(0) : principal.VolatileData.get_Path(_branch);
                var lists = _matched.Where(p => p.Access == GH_ParamAccess.item).Select(p => BranchOf(p).Count).ToList();
                var runs = lists.Count == 0 ? 1 : lists.Contains(0) ? 0 : lists.Max();
                if (runs == 0)
                {
                    for (var i = 0; i < _component.Params.Output.Count; i++) _component.Params.Output[i].AddVolatileDataList(_path, new object[0]);
                }
                for (_item = 0; _item < runs; _item++)
                {
                    _set.Clear();
                    solve(this);
                    Iteration++;
                    _component.RunCount = Iteration;
                    if (_aborted) return;
                    FillGaps();
                }
            }
        }

        public bool GetData<T>(int index, ref T destination)
        {
            var param = _component.Params.Input[index];
            var branch = param.VolatileData.PathCount == 0 ? null : BranchOf(param);
            if (branch == null || branch.Count == 0) return false;
            if (!Casting.ToBare<T>((IGH_Goo)branch[Math.Min(_item, branch.Count - 1)], out var value)) return false;
            destination = value;
            return true;
        }

        public bool GetDataList<T>(int index, List<T> list)
        {
            var param = _component.Params.Input[index];
            if (param.VolatileData.PathCount == 0) return false;
            foreach (IGH_Goo goo in BranchOf(param))
            {
                Casting.ToBare<T>(goo, out var value);
                list.Add(value);
            }
            return true;
        }

        public bool GetDataTree<T>(int index, out GH_Structure<T> tree)
            where T : IGH_Goo
        {
            tree = _component.Params.Input[index].VolatileData as GH_Structure<T>;
            return tree != null;
        }

        public bool SetData(int paramIndex, object data)
        {
            _set.Add(paramIndex);
            return _component.Params.Output[paramIndex].AddVolatileData(ParameterTargetPath(paramIndex), ParameterTargetIndex(paramIndex), data);
        }

        public bool SetDataList(int paramIndex, IEnumerable data)
        {
            _set.Add(paramIndex);
            return _component.Params.Output[paramIndex].AddVolatileDataList(ParameterTargetPath(paramIndex), data);
        }

        public bool SetDataTree(int paramIndex, IGH_Structure tree)
        {
            _set.Add(paramIndex);
            return _component.Params.Output[paramIndex].AddVolatileDataTree(tree);
        }

        public GH_Path ParameterTargetPath(int paramIndex)
            => Target(_component.Params.Output[paramIndex].Access != GH_ParamAccess.item && _anyItems ? _path.AppendElement(_item) : _path);

        public int ParameterTargetIndex(int paramIndex) => _item;

        public void AbortComponentSolution() => _aborted = true;

        private IList BranchOf(IGH_Param param) => param.VolatileData.get_Branch(Math.Min(_branch, param.VolatileData.PathCount - 1));

        private void FillGaps()
        {
            for (var i = 0; i < _component.Params.Output.Count; i++)
            {
                var output = _component.Params.Output[i];
                if (_set.Contains(i) || output.Access == GH_ParamAccess.tree) continue;
                if (output.Access == GH_ParamAccess.item) output.AddVolatileData(Target(_path), _item, null);
                else output.AddVolatileDataList(ParameterTargetPath(i), new object[0]);
            }
        }
    }
}
