using System;
using System.Collections.Generic;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Layers, roles and objects from comments.</summary>
internal sealed partial class DecoderCore
{
    private const int MostSettings = 5000;
    private const int MostThumbnails = 100;
    private readonly SortedDictionary<string, string> _settings = new(StringComparer.Ordinal);

    private readonly List<Thumbnail> _thumbnails = [];

    // True once comments of their own say what strands are for; then those behind moves say nothing new.
    private bool _typed;
    private bool _namesAlone;

    /// <summary>The settings that the slicer wrote as <c>; key = value</c>.</summary>
    public IReadOnlyDictionary<string, string> Settings => _settings;

    public IReadOnlyList<Thumbnail> Thumbnails => _thumbnails;

    private void CommentLine(byte[] text, int start, int end)
    {
        Features.SemicolonComments++;
        Meaning(text, start, end);
    }

    private void Meaning(byte[] text, int start, int end)
    {
        var meaning = CommentReader.Read(text, start, end);
        switch (meaning.Kind)
        {
            case CommentKind.LayerNumber:
                DecodeCounters.LayerMarks++;
                Mark(meaning.Number, meaning.Z, 0);
                break;
            case CommentKind.LayerChange:
                DecodeCounters.LayerMarks++;
                Mark(null, meaning.Number == 1 ? meaning.Z : double.NaN, meaning.Height);
                break;
            case CommentKind.Z:
                Layers.SetZ(meaning.Z);
                break;
            case CommentKind.Height:
                Layers.SetThickness(meaning.Height);
                break;
            case CommentKind.Role:
                _typed = true;
                _role = meaning.Role;
                break;
            case CommentKind.ObjectStart:
                SetObject(meaning.Text);
                break;
            case CommentKind.ObjectEnd:
                SetObject("");
                break;
            case CommentKind.Thumbnail:
                if (_thumbnails.Count < MostThumbnails && Thumbnail.Read(meaning.Text) is { } thumbnail) _thumbnails.Add(thumbnail);
                break;
            case CommentKind.Setting:
                if (meaning.Text.Length > 0 && _settings.Count < MostSettings) _settings[meaning.Text] = meaning.Value;
                break;
            default:
                if (!_typed || _namesAlone) NameAlone(text, start, end);
                break;
        }
    }

    // Simplify3D: a comment that is nothing but the name of a role.
    private void NameAlone(byte[] text, int start, int end)
    {
        if (end - start > 30 || CommentReader.WholeRole(text, start, end) is not { } role) return;
        _typed = _namesAlone = true;
        _role = role;
    }

    // Slic3r: what a move is for stands behind it.
    private void TrailingComment(byte[] text, int start)
    {
        var end = LineEnds.Find(text, start, text.Length);
        if (CommentReader.WholeRole(text, start, end) is { } role) _role = role;
        else if (!_ownMarks && CommentReader.NextLayer(text, start, end) is >= 0 and var layer) MarkByMove(layer);
    }

    private bool _ownMarks;

    /// <summary>The line of the first comment that begins a layer, or 0.</summary>
    public int FirstMarkLine { get; private set; }

    private void FirstMark()
    {
        if (Layers.Marked) return;
        FirstMarkLine = _line;
        _out.ForgetLayers();
    }

    private void MarkByMove(int layer)
    {
        FirstMark();
        Layers.Mark(layer, double.NaN, 0);
    }

    private void Mark(int? number, double z, double thickness)
    {
        _ownMarks = true;
        FirstMark();
        Layers.Mark(number, z, thickness);
        _lastFlatZ = double.NaN;
    }

    private void SetObject(string name)
    {
        if (name != Layers.Object) Layers.SetObject(name);
    }
}
