using System.Collections;
using System.Collections.Generic;
using System.Linq;

namespace Grasshopper.Kernel
{
    public class GH_ComponentParamServer : IEnumerable<IGH_Param>
    {
        internal GH_ComponentParamServer(IGH_Component owner) => Owner = owner;

        public IGH_Component Owner { get; }

        public List<IGH_Param> Input { get; } = new List<IGH_Param>();

        public List<IGH_Param> Output { get; } = new List<IGH_Param>();

        public int IndexOfInputParam(string name) => Input.FindIndex(p => p.Name == name);

        public int IndexOfOutputParam(string name) => Output.FindIndex(p => p.Name == name);

        public bool RegisterInputParam(IGH_Param new_param) => Register(Input, new_param);

        public bool RegisterOutputParam(IGH_Param new_param) => Register(Output, new_param);

        public IEnumerator<IGH_Param> GetEnumerator() => Input.Concat(Output).GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

        private bool Register(List<IGH_Param> side, IGH_Param param)
        {
            ((IHeadlessParam)param).Server = this;
            side.Add(param);
            return true;
        }
    }
}
