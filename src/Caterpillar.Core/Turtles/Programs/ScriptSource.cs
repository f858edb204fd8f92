namespace Caterpillar.Turtles;

/// <summary>A script or an included file as tokens, with the files that it reads.</summary>
internal sealed class ScriptSource(string? file, List<Token> tokens)
{
    private const int MaxIncludes = 100;

    /// <summary>Its name in messages. Null = the script itself.</summary>
    public string? File { get; } = file;

    public List<Token> Tokens { get; } = tokens;

    /// <summary>Included files by the token of their name. Null if the file has been included before.</summary>
    public Dictionary<int, ScriptSource?> Includes { get; } = [];

    /// <summary>Images, by the token of their file name.</summary>
    public Dictionary<int, GrayImage> Images { get; } = [];

    /// <summary>Reads a script and its included files.</summary>
    /// <exception cref="FormulaException">A text is not a program, or a file is missing, includes itself or is not an image.</exception>
    public static ScriptSource Read(string text, string? file, ScriptFiles files) => new Reader(files, file).Read(text, null, null);

    private sealed class Reader(ScriptFiles files, string? main)
    {
        // Paths of the files that are being read, from the outermost.
        private readonly List<string> _open = [];
        private readonly HashSet<string> _read = new(StringComparer.Ordinal);
        private readonly Dictionary<string, GrayImage> _images = new(StringComparer.Ordinal);
        private long _pixels;

        public ScriptSource Read(string text, string? file, string? path)
        {
            try
            {
                var source = new ScriptSource(file, Lexer.Read(text));
                for (var i = 1; i < source.Tokens.Count; i++)
                {
                    var name = source.Tokens[i];
                    if (name.Kind != TokenKind.Text) continue;
                    if (source.Tokens[i - 1].IsWord("include")) source.Includes.Add(i, Include(name, file, path));
                    else if (i > 1 && source.Tokens[i - 2].IsWord("image")) source.Images.Add(i, Image(name, path));
                }
                return source;
            }
            catch (FormulaException e) when (e.File is null)
            {
                e.File = file;
                throw;
            }
        }

        // A file is included once, however many name it.
        private ScriptSource? Include(Token name, string? file, string? from)
        {
            var path = files.Find(name, from);
            if (_open.Contains(path)) throw new FormulaException("turtle.include", $"'{name.Text}' includes itself.", name);
            if (!_read.Add(path)) return null;
            if (_read.Count > MaxIncludes)
                throw new FormulaException("turtle.include", "A script can include up to 100 files.", name);
            _open.Add(path);
            var source = Read(Encoding.UTF8.GetString(ScriptFiles.Read(path, name)), Beside(file ?? main, name.Text), path);
            _open.RemoveAt(_open.Count - 1);
            return source;
        }

        private GrayImage Image(Token name, string? from)
        {
            var path = files.Find(name, from);
            if (_images.TryGetValue(path, out var known)) return known;
            var read = ImageReader.Read(ScriptFiles.Read(path, name), name.Text);
            var image = read.Value
                ?? throw new FormulaException(read.Diagnostics[0].Code, $"'{name.Text}': {read.Diagnostics[0].Message}", name);
            _pixels += (long)image.Width * image.Height;
            if (_pixels > ImageReader.MaxPixels)
                throw new FormulaException("turtle.file", "The images of the script have more than 100 million pixels in total.", name);
            return _images[path] = image;
        }

        // As the user would write it, from where the script was named.
        private static string Beside(string? file, string name)
        {
            var cut = file?.LastIndexOfAny(['/', '\\']) ?? -1;
            return cut < 0 ? name : file!.Substring(0, cut + 1) + name;
        }
    }
}
