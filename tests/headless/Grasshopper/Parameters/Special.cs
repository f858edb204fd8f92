using System;
using System.Collections.Generic;
using System.Drawing;
using System.Globalization;
using GH_IO.Serialization;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Types;

namespace Grasshopper.Kernel.Special
{
    /// <summary>A panel: a source of text, a line for each item, or a note.</summary>
    internal sealed class GH_Panel : GH_Param<IGH_Goo>
    {
        public GH_Panel() : base("Panel", "", "A panel for custom notes and text values", "Params", "Input", GH_ParamAccess.item)
        {
        }

        public override Guid ComponentGuid => new Guid("59e0b89a-e487-49f8-bab8-b5bab16be14c");

        public string UserText { get; set; } = "";

        public bool Multiline { get; set; } = true;

        public override bool Write(GH_IWriter writer)
        {
            base.Write(writer);
            writer.SetString("UserText", UserText);
            var look = writer.CreateChunk("PanelProperties");
            look.SetBoolean("DrawIndices", !Multiline);
            look.SetBoolean("DrawPaths", false);
            look.SetBoolean("Multiline", Multiline);
            look.SetBoolean("SpecialCodes", false);
            look.SetBoolean("Stream", false);
            look.SetBoolean("Wrap", true);
            return true;
        }

        public override bool Read(GH_IReader reader)
        {
            base.Read(reader);
            UserText = reader.GetString("UserText");
            Multiline = reader.FindChunk("PanelProperties").GetBoolean("Multiline");
            return true;
        }

        protected override void CollectVolatileData_Custom()
        {
            if (UserText.Length == 0) return;
            var lines = Multiline ? new[] { UserText } : UserText.Replace("\r\n", "\n").Split('\n');
            foreach (var line in lines) m_data.Append(new GH_String(line), new GH_Path(0));
        }

        protected override IGH_Goo Cast_Object(object data) => Casting.Wrap(data);
    }

    internal sealed class GH_NumberSlider : GH_Param<GH_Number>
    {
        public GH_NumberSlider() : base("Number Slider", "", "Numeric slider for single values", "Params", "Input", GH_ParamAccess.item)
        {
        }

        public override Guid ComponentGuid => new Guid("57da07bd-ecab-415d-9d86-af36d7073abc");

        public double Minimum { get; set; }

        public double Maximum { get; set; } = 1;

        public double Value { get; set; }

        public int Digits { get; set; } = 3;

        public override bool Write(GH_IWriter writer)
        {
            base.Write(writer);
            var slider = writer.CreateChunk("Slider");
            slider.SetInt32("Digits", Digits);
            slider.SetInt32("GripDisplay", 1);
            slider.SetInt32("Interval", Digits == 0 ? 1 : 0);
            slider.SetDouble("Max", Maximum);
            slider.SetDouble("Min", Minimum);
            slider.SetInt32("SnapCount", 0);
            slider.SetDouble("Value", Value);
            return true;
        }

        public override bool Read(GH_IReader reader)
        {
            base.Read(reader);
            var slider = reader.FindChunk("Slider");
            Digits = slider.GetInt32("Digits");
            Maximum = slider.GetDouble("Max");
            Minimum = slider.GetDouble("Min");
            Value = slider.GetDouble("Value");
            return true;
        }

        protected override void CollectVolatileData_Custom() => m_data.Append(new GH_Number(Value), new GH_Path(0));
    }

    internal sealed class GH_BooleanToggle : GH_Param<GH_Boolean>
    {
        public GH_BooleanToggle() : base("Boolean Toggle", "Toggle", "Boolean (true/false) toggle", "Params", "Input", GH_ParamAccess.item)
        {
        }

        public override Guid ComponentGuid => new Guid("2e78987b-9dfb-42a2-8b76-3923ac8bd91a");

        public bool Value { get; set; }

        public override bool Write(GH_IWriter writer)
        {
            base.Write(writer);
            writer.SetBoolean("ToggleValue", Value);
            return true;
        }

        public override bool Read(GH_IReader reader)
        {
            base.Read(reader);
            Value = reader.GetBoolean("ToggleValue");
            return true;
        }

        protected override void CollectVolatileData_Custom() => m_data.Append(new GH_Boolean(Value), new GH_Path(0));
    }

    /// <summary>A frame around objects, with a title.</summary>
    public class GH_Group : GH_DocumentObject
    {
        public GH_Group() : base("Group", "", "A group of Grasshopper objects", "Params", "Util")
        {
        }

        public override Guid ComponentGuid => new Guid("c552a431-af5b-46a9-a8a4-0fcbc27ef596");

        public List<Guid> ObjectIDs { get; } = new List<Guid>();

        public Color Colour { get; set; } = Color.FromArgb(150, 170, 135, 255);

        internal static GH_Group Of(string name, Color colour) => new GH_Group { NickName = name, Colour = colour };

        public void AddObject(Guid id)
        {
            if (!ObjectIDs.Contains(id)) ObjectIDs.Add(id);
        }

        public override bool Write(GH_IWriter writer)
        {
            base.Write(writer);
            writer.SetInt32("Border", 1);
            writer.SetDrawingColor("Colour", Colour);
            for (var i = 0; i < ObjectIDs.Count; i++) writer.SetGuid("ID", i, ObjectIDs[i]);
            writer.SetInt32("ID_Count", ObjectIDs.Count);
            return true;
        }

        public override bool Read(GH_IReader reader)
        {
            base.Read(reader);
            var colour = Colour;
            if (reader.TryGetDrawingColor("Colour", ref colour)) Colour = colour;
            ObjectIDs.Clear();
            for (var i = 0; i < reader.GetInt32("ID_Count"); i++) ObjectIDs.Add(reader.GetGuid("ID", i));
            return true;
        }
    }
}
