using System;
using System.Collections.Generic;
using System.Linq;

namespace Grasshopper.Kernel
{
    public sealed partial class GH_Document : GH_IO.GH_ISerializable
    {
        // Tests run side by side: each thread has its own.
        [ThreadStatic]
        private static Func<bool> s_escapeKey;

        private readonly List<IGH_DocumentObject> _objects = new List<IGH_DocumentObject>();
        private readonly Queue<GH_ScheduleDelegate> _scheduled = new Queue<GH_ScheduleDelegate>();
        private bool _solving;

        // Tests run side by side: each thread has its own.
        [ThreadStatic]
        private static bool s_isLocked;

        public delegate void GH_ScheduleDelegate(GH_Document document);

        public IList<IGH_DocumentObject> Objects => _objects;

        public int ObjectCount => _objects.Count;

        public bool Enabled { get; set; } = true;

        public string FilePath { get; set; }

        /// <summary>The cluster that it is the inside of.</summary>
        public IGH_DocumentOwner Owner { get; set; }

        public bool IsFilePathDefined => !string.IsNullOrEmpty(FilePath);

        public bool AbortRequested { get; private set; }

        /// <summary>The lock of the solver, for all definitions.</summary>
        public static bool EnableSolutions
        {
            get => !s_isLocked;
            set => s_isLocked = !value;
        }

        public GH_ProcessStep SolutionState => _solving ? GH_ProcessStep.Process : GH_ProcessStep.PostProcess;

        public int SolutionDepth => _solving ? 1 : 0;

        internal int SolutionCount { get; private set; }

        internal int ScheduledCount => _scheduled.Count;

        // What a test stands in for the keyboard.
        internal static Func<bool> EscapeKey
        {
            get => s_escapeKey ?? (() => false);
            set => s_escapeKey = value;
        }

        public static bool IsEscapeKeyDown() => EscapeKey();

        public bool AddObject(IGH_DocumentObject docObject, bool update, int index = int.MaxValue)
        {
            if (_objects.Contains(docObject)) return false;
            _objects.Insert(Math.Min(index, _objects.Count), docObject);
            if (docObject.Attributes == null) docObject.CreateAttributes();
            docObject.AddedToDocument(this);
            if (update) NewSolution(false);
            return true;
        }

        public bool RemoveObject(IGH_DocumentObject docObject, bool update)
        {
            if (!_objects.Remove(docObject)) return false;
            docObject.RemovedFromDocument(this);
            if (update) NewSolution(false);
            return true;
        }

        public IGH_DocumentObject FindObject(Guid iid, bool topLevelOnly) => _objects.FirstOrDefault(o => o.InstanceGuid == iid);

        public void RequestAbortSolution() => AbortRequested = true;

        public void NewSolution(bool expireAllObjects) => NewSolution(expireAllObjects, GH_SolutionMode.Default);

        public void NewSolution(bool expireAllObjects, GH_SolutionMode mode)
        {
            if (!Enabled || !EnableSolutions || _solving) return;
            _solving = true;
            AbortRequested = false;
            SolutionCount++;
            try
            {
                var active = _objects.OfType<IGH_ActiveObject>().ToList();
                if (expireAllObjects) active.ForEach(o => o.ClearData());
                foreach (var item in InOrder(active))
                {
                    if (AbortRequested) break;
                    item.CollectData();
                    item.ComputeData();
                }
            }
            finally
            {
                _solving = false;
            }
        }

        public void ScheduleSolution(int delay) => ScheduleSolution(delay, null);

        public void ScheduleSolution(int delay, GH_ScheduleDelegate callback) => _scheduled.Enqueue(callback);

        /// <summary>Does what the timer of Grasshopper would do: the callbacks that wait now, then one solution.</summary>
        internal bool RunSchedule()
        {
            if (_scheduled.Count == 0) return false;
            for (var waiting = _scheduled.Count; waiting > 0; waiting--) _scheduled.Dequeue()?.Invoke(this);
            NewSolution(false);
            return true;
        }

        // Sources before what depends on them; otherwise in the order of the document.
        private static IEnumerable<IGH_ActiveObject> InOrder(List<IGH_ActiveObject> all)
        {
            var done = new HashSet<IGH_ActiveObject>();
            while (done.Count < all.Count)
            {
                var next = all.FirstOrDefault(o => !done.Contains(o) && all.All(s => done.Contains(s) || ReferenceEquals(s, o) || !o.DependsOn(s)));
                if (next == null) throw new InvalidOperationException("The definition has a cycle.");
                done.Add(next);
                yield return next;
            }
        }
    }
}
