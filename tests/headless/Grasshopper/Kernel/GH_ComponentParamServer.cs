using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using GH_IO.Serialization;

namespace Grasshopper.Kernel
{
    public class GH_ComponentParamServer : IEnumerable<IGH_Param>
    {
        internal GH_ComponentParamServer(IGH_Component owner) => Owner = owner;

        public delegate void ParameterNickNameChangedEventHandler(object sender, GH_ParamServerEventArgs e);

        /// <summary>A rename by the user, or its undo. Not raised when code sets the nickname.</summary>
        public event ParameterNickNameChangedEventHandler ParameterNickNameChanged;

        public IGH_Component Owner { get; }

        public List<IGH_Param> Input { get; } = new List<IGH_Param>();

        public List<IGH_Param> Output { get; } = new List<IGH_Param>();

        public int IndexOfInputParam(string name) => Input.FindIndex(p => p.Name == name);

        public int IndexOfOutputParam(string name) => Output.FindIndex(p => p.Name == name);

        public bool RegisterInputParam(IGH_Param new_param) => Register(Input, new_param, Input.Count);

        public bool RegisterInputParam(IGH_Param new_param, int at_index) => Register(Input, new_param, at_index);

        public bool RegisterOutputParam(IGH_Param new_param) => Register(Output, new_param, Output.Count);

        public bool UnregisterInputParameter(IGH_Param param, bool isolate)
        {
            if (!Input.Remove(param)) return false;
            if (isolate) param.RemoveAllSources();
            ((IHeadlessParam)param).Server = null;
            return true;
        }

        public void OnParametersChanged()
        {
        }

        public IEnumerator<IGH_Param> GetEnumerator() => Input.Concat(Output).GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

        // What the zoomable + does.
        internal IGH_Param Insert(int index)
        {
            var variable = (IGH_VariableParameterComponent)Owner;
            if (!variable.CanInsertParameter(GH_ParameterSide.Input, index)) throw new InvalidOperationException("There is no + here.");
            var made = variable.CreateParameter(GH_ParameterSide.Input, index);
            if (made == null) return null;
            RegisterInputParam(made, index);
            variable.VariableParameterMaintenance();
            Owner.ExpireSolution(false);
            return made;
        }

        // What the zoomable - does.
        internal void Remove(int index)
        {
            var variable = (IGH_VariableParameterComponent)Owner;
            if (!variable.CanRemoveParameter(GH_ParameterSide.Input, index)) throw new InvalidOperationException("There is no - here.");
            if (!variable.DestroyParameter(GH_ParameterSide.Input, index)) return;
            UnregisterInputParameter(Input[index], true);
            variable.VariableParameterMaintenance();
            Owner.ExpireSolution(false);
        }

        // What a user does in the menu of a port.
        internal void Rename(IGH_Param param, string name)
        {
            param.NickName = name;
            ParameterNickNameChanged?.Invoke(Owner, new GH_ParamServerEventArgs(this, param));
        }

        // Ports of components with variable parameters are written with the id of their kind, and made again from it.
        internal void WriteVariable(GH_IWriter writer)
        {
            var data = writer.CreateChunk("ParameterData");
            WriteSide(data, "Input", Input);
            WriteSide(data, "Output", Output);
        }

        internal void ReadVariable(GH_IReader reader)
        {
            var data = reader.FindChunk("ParameterData");
            if (data == null) return;
            ReadSide(data, "Input", Input);
            ReadSide(data, "Output", Output);
            ((IGH_VariableParameterComponent)Owner).VariableParameterMaintenance();
        }

        private static void WriteSide(GH_IWriter data, string side, List<IGH_Param> ports)
        {
            data.SetInt32(side + "Count", ports.Count);
            for (var i = 0; i < ports.Count; i++)
            {
                data.SetGuid(side + "Id", i, ports[i].ComponentGuid);
                ports[i].Write(data.CreateChunk(side + "Param", i));
            }
        }

        private void ReadSide(GH_IReader data, string side, List<IGH_Param> ports)
        {
            var old = ports.ToList();
            ports.Clear();
            for (var i = 0; i < data.GetInt32(side + "Count"); i++)
            {
                var chunk = data.FindChunk(side + "Param", i);
                var id = data.GetGuid(side + "Id", i);
                // A port that is there already keeps its wires to others.
                var same = old.Find(p => p.ComponentGuid == id && p.InstanceGuid == chunk.GetGuid("InstanceGuid"));
                var param = same ?? (IGH_Param)Instances.ComponentServer.EmitObject(id);
                old.Remove(param);
                Register(ports, param, i);
                param.RemoveAllSources();
                param.Name = chunk.GetString("Name");
                param.Description = chunk.GetString("Description");
                param.Read(chunk);
                param.Optional = chunk.GetBoolean("Optional");
                param.Access = (GH_ParamAccess)chunk.GetInt32("Access");
            }
            foreach (var gone in old) ((IHeadlessParam)gone).Server = null;
        }

        private bool Register(List<IGH_Param> side, IGH_Param param, int index)
        {
            ((IHeadlessParam)param).Server = this;
            if (param.Attributes == null) param.CreateAttributes();
            side.Insert(Math.Min(index, side.Count), param);
            return true;
        }
    }

    public class GH_ParamServerEventArgs : EventArgs
    {
        internal GH_ParamServerEventArgs(GH_ComponentParamServer server, IGH_Param param)
        {
            Parameter = param;
            ParameterSide = server.Input.Contains(param) ? GH_ParameterSide.Input : GH_ParameterSide.Output;
        }

        public IGH_Param Parameter { get; }

        public GH_ParameterSide ParameterSide { get; }
    }

    public enum GH_ParameterSide
    {
        Input = 0,
        Output = 1,
    }

    public interface IGH_VariableParameterComponent
    {
        bool CanInsertParameter(GH_ParameterSide side, int index);

        bool CanRemoveParameter(GH_ParameterSide side, int index);

        IGH_Param CreateParameter(GH_ParameterSide side, int index);

        bool DestroyParameter(GH_ParameterSide side, int index);

        void VariableParameterMaintenance();
    }
}
