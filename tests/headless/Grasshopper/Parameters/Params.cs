using System;
using System.Collections.Generic;
using Grasshopper.Kernel.Types;
using Rhino.Geometry;

namespace Grasshopper.Kernel.Parameters
{
    public class Param_GenericObject : GH_PersistentParam<IGH_Goo>
    {
        public Param_GenericObject() : base("Data", "Data", "Contains a collection of generic data", "Params", "Primitive")
        {
        }

        public override Guid ComponentGuid => new Guid("8ec86459-bf01-4409-baee-174d0d2b13d0");

        protected override IGH_Goo Cast_Object(object data) => Casting.Wrap(data);

        protected override GH_GetterResult Prompt_Singular(ref IGH_Goo value) => GH_GetterResult.cancel;

        protected override GH_GetterResult Prompt_Plural(ref List<IGH_Goo> values) => GH_GetterResult.cancel;
    }

    public class Param_Number : GH_PersistentParam<GH_Number>
    {
        public Param_Number() : base("Number", "Num", "Contains a collection of floating point numbers", "Params", "Primitive")
        {
        }

        public override Guid ComponentGuid => new Guid("3e8ca6be-fda8-4aaf-b5c0-3c54c8bb7312");

        public virtual bool AngleParameter { get; set; }

        public virtual bool UseDegrees { get; set; }

        protected override GH_GetterResult Prompt_Singular(ref GH_Number value) => GH_GetterResult.cancel;

        protected override GH_GetterResult Prompt_Plural(ref List<GH_Number> values) => GH_GetterResult.cancel;
    }

    public class Param_Integer : GH_PersistentParam<GH_Integer>
    {
        internal readonly List<KeyValuePair<string, int>> NamedValues = new List<KeyValuePair<string, int>>();

        public Param_Integer() : base("Integer", "Int", "Contains a collection of integer numbers", "Params", "Primitive")
        {
        }

        public override Guid ComponentGuid => new Guid("2e3ab970-8545-46bb-836c-1c11e5610bce");

        public bool HasNamedValues => NamedValues.Count > 0;

        public void AddNamedValue(string name, int value) => NamedValues.Add(new KeyValuePair<string, int>(name, value));

        public void ClearNamedValues() => NamedValues.Clear();

        public override bool Write(GH_IO.Serialization.GH_IWriter writer)
        {
            for (var i = 0; i < NamedValues.Count; i++)
            {
                var chunk = writer.CreateChunk("NamedValue", i);
                chunk.SetString("Name", NamedValues[i].Key);
                chunk.SetInt32("Value", NamedValues[i].Value);
            }
            return base.Write(writer);
        }

        public override bool Read(GH_IO.Serialization.GH_IReader reader)
        {
            if (reader.ChunkExists("NamedValue", 0)) NamedValues.Clear();
            for (var i = 0; reader.ChunkExists("NamedValue", i); i++)
            {
                var chunk = reader.FindChunk("NamedValue", i);
                AddNamedValue(chunk.GetString("Name"), chunk.GetInt32("Value"));
            }
            return base.Read(reader);
        }

        protected override GH_GetterResult Prompt_Singular(ref GH_Integer value) => GH_GetterResult.cancel;

        protected override GH_GetterResult Prompt_Plural(ref List<GH_Integer> values) => GH_GetterResult.cancel;
    }

    public class Param_Boolean : GH_PersistentParam<GH_Boolean>
    {
        public Param_Boolean() : base("Boolean", "Bool", "Contains a collection of boolean values", "Params", "Primitive")
        {
        }

        public override Guid ComponentGuid => new Guid("cb95db89-6165-43b6-9c41-5702bc5bf137");

        protected override GH_GetterResult Prompt_Singular(ref GH_Boolean value) => GH_GetterResult.cancel;

        protected override GH_GetterResult Prompt_Plural(ref List<GH_Boolean> values) => GH_GetterResult.cancel;
    }

    public class Param_String : GH_PersistentParam<GH_String>
    {
        public Param_String() : base("Text", "Txt", "Contains a collection of text fragments", "Params", "Primitive")
        {
        }

        public override Guid ComponentGuid => new Guid("3ede854e-c753-40eb-84cb-b48008f14fd4");

        protected override GH_GetterResult Prompt_Singular(ref GH_String value) => GH_GetterResult.cancel;

        protected override GH_GetterResult Prompt_Plural(ref List<GH_String> values) => GH_GetterResult.cancel;
    }

    public class Param_FilePath : GH_PersistentParam<GH_String>
    {
        public Param_FilePath() : base("File Path", "Path", "Contains a collection of file paths", "Params", "Primitive")
        {
        }

        public override Guid ComponentGuid => new Guid("06953bda-1d37-4d58-9b38-4b3c74e54c8f");

        public string FileFilter { get; set; }

        public bool ExpireOnFileEvent { get; set; }

        protected override GH_GetterResult Prompt_Singular(ref GH_String value) => GH_GetterResult.cancel;

        protected override GH_GetterResult Prompt_Plural(ref List<GH_String> values) => GH_GetterResult.cancel;
    }

    public class Param_Colour : GH_PersistentParam<GH_Colour>
    {
        public Param_Colour() : base("Colour", "Col", "Contains a collection of RGB colours", "Params", "Primitive")
        {
        }

        public override Guid ComponentGuid => new Guid("203a91c3-287a-43b6-a9c5-ebb96240a650");

        protected override GH_GetterResult Prompt_Singular(ref GH_Colour value) => GH_GetterResult.cancel;

        protected override GH_GetterResult Prompt_Plural(ref List<GH_Colour> values) => GH_GetterResult.cancel;
    }

    public class Param_Guid : GH_PersistentParam<GH_Guid>
    {
        public Param_Guid() : base("Guid", "ID", "Contains a collection of Globally Unique Identifiers", "Params", "Primitive")
        {
        }

        public override Guid ComponentGuid => new Guid("6a3e2c44-0d0c-4b7e-9c1a-3a4a0f6f1c55");

        protected override GH_GetterResult Prompt_Singular(ref GH_Guid value) => GH_GetterResult.cancel;

        protected override GH_GetterResult Prompt_Plural(ref List<GH_Guid> values) => GH_GetterResult.cancel;
    }
}
