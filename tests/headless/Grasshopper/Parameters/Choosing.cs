using System;
using System.Collections.Generic;
using System.Globalization;
using GH_IO.Serialization;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Types;

namespace Grasshopper.Kernel.Special
{
    /// <summary>An entry of a value list. Here an expression is a number or a quoted text.</summary>
    internal sealed class GH_ValueListItem
    {
        public GH_ValueListItem(string name, string expression)
        {
            Name = name;
            Expression = expression;
        }

        public string Name { get; }

        public string Expression { get; }

        public bool Selected { get; set; }

        public IGH_Goo Value => Expression.StartsWith("\"", StringComparison.Ordinal) ? new GH_String(Expression.Trim('"'))
            : (IGH_Goo)new GH_Number(double.Parse(Expression, CultureInfo.InvariantCulture));
    }

    /// <summary>A list of values of which one is chosen.</summary>
    internal sealed class GH_ValueList : GH_Param<IGH_Goo>
    {
        private const int DropDown = 1;

        public GH_ValueList() : base("Value List", "List", "Provides a list of preset values to choose from", "Params", "Input", GH_ParamAccess.item)
        {
        }

        public override Guid ComponentGuid => new Guid("00027467-0d24-4fa7-b178-8dc0ac5f42ec");

        public List<GH_ValueListItem> ListItems { get; } = new List<GH_ValueListItem>();

        public override bool Write(GH_IWriter writer)
        {
            base.Write(writer);
            writer.SetInt32("ListCount", ListItems.Count);
            writer.SetInt32("ListMode", DropDown);
            for (var i = 0; i < ListItems.Count; i++)
            {
                var item = writer.CreateChunk("ListItem", i);
                item.SetString("Expression", ListItems[i].Expression);
                item.SetString("Name", ListItems[i].Name);
                item.SetBoolean("Selected", ListItems[i].Selected);
            }
            return true;
        }

        public override bool Read(GH_IReader reader)
        {
            base.Read(reader);
            ListItems.Clear();
            for (var i = 0; i < reader.GetInt32("ListCount"); i++)
            {
                var item = reader.FindChunk("ListItem", i);
                ListItems.Add(new GH_ValueListItem(item.GetString("Name"), item.GetString("Expression")) { Selected = item.GetBoolean("Selected") });
            }
            return true;
        }

        protected override void CollectVolatileData_Custom()
        {
            foreach (var item in ListItems)
            {
                if (item.Selected) m_data.Append(item.Value, new GH_Path(0));
            }
        }

        protected override IGH_Goo Cast_Object(object data) => Casting.Wrap(data);
    }

    /// <summary>A button: true while it is pressed.</summary>
    internal sealed class GH_ButtonObject : GH_Param<GH_Boolean>
    {
        public GH_ButtonObject() : base("Button", "", "Button object with two values", "Params", "Input", GH_ParamAccess.item)
        {
        }

        public override Guid ComponentGuid => new Guid("a8b97322-2d53-47cd-905e-b932c3ccd74e");

        public bool ButtonDown { get; set; }

        public override bool Write(GH_IWriter writer)
        {
            base.Write(writer);
            writer.SetString("ExpressionNormal", "False");
            writer.SetString("ExpressionPressed", "True");
            return true;
        }

        protected override void CollectVolatileData_Custom() => m_data.Append(new GH_Boolean(ButtonDown), new GH_Path(0));
    }
}
