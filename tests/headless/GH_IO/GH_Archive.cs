using System.IO;
using System.Text;
using System.Xml;
using GH_IO.Types;

namespace GH_IO.Serialization
{
    /// <summary>Reads and writes .ghx text.</summary>
    public class GH_Archive
    {
        private GH_Chunk _root = new GH_Chunk("Root", -1);

        public GH_Chunk GetRootNode => _root;

        public void CreateNewRoot(bool forWriting)
        {
            _root = new GH_Chunk("Root", -1);
            if (forWriting) _root.SetVersion("ArchiveVersion", new GH_Version(0, 2, 2));
        }

        public bool AppendObject(GH_ISerializable target, string targetName)
        {
            if (!_root.ItemExists("ArchiveVersion")) _root.SetVersion("ArchiveVersion", new GH_Version(0, 2, 2));
            return target.Write(_root.CreateChunk(targetName));
        }

        public bool ExtractObject(GH_ISerializable target, string targetName)
        {
            var chunk = _root.FindChunk(targetName);
            if (chunk == null) throw new System.MemberAccessException("The archive has no object " + targetName + ".");
            return target.Read(chunk);
        }

        public string Serialize_Xml()
        {
            var text = new StringBuilder();
            var settings = new XmlWriterSettings { Indent = true, NewLineChars = "\n", OmitXmlDeclaration = true };
            using (var writer = XmlWriter.Create(text, settings)) _root.WriteXml(writer, "Archive");
            return "<?xml version=\"1.0\" encoding=\"utf-8\" standalone=\"yes\"?>\n" + text;
        }

        public bool Deserialize_Xml(string xmlContent)
        {
            var document = new XmlDocument();
            document.LoadXml(xmlContent);
            if (document.DocumentElement?.Name != "Archive") return false;
            _root = GH_Chunk.ReadXml(document.DocumentElement);
            return true;
        }

        public bool WriteToFile(string fileName, bool overwrite, bool rememberPath)
        {
            if (!overwrite && File.Exists(fileName)) return false;
            File.WriteAllText(fileName, Serialize_Xml(), new UTF8Encoding(false));
            return true;
        }

        public bool ReadFromFile(string fileName) => Deserialize_Xml(File.ReadAllText(fileName));
    }
}
