using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Dialects;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>
/// Writes a decoded file again. Two machines read along: one the file as it was, one what is written; a line stays as it is when it makes the wanted move from
/// the state that the written lines have led to, otherwise its words are changed or a line that states the missing mode is put in front. Chunks that nothing
/// touches are copied whole.
/// </summary>
internal sealed partial class Splicer
{
    private const double NoChange = 1e-9;

    private readonly DecodedGCode _decoding;
    private readonly GCodeDocument _document;
    private readonly LineStyle _style;
    private readonly DecoderCore _in;
    private readonly DecoderCore _now;
    private readonly DialectRules _rules;
    private readonly ExtrusionAxis _axis;
    private readonly byte _extruder;
    private readonly LineRewriter _rewriter;

    // The line of the file that is gone through, and one that is made.
    private readonly ParsedLine _line = new();
    private readonly ParsedLine _made = new();

    private readonly SplicedText _text;
    private readonly double _tolerance;
    private readonly double _toleranceE;
    private int _number;

    public Splicer(DecodedGCode decoding, ConvertTarget? target, Stream stream)
    {
        _decoding = decoding;
        _document = decoding.Document!;
        _style = LineStyle.Of(_document).With(target?.DecimalsXyz, target?.DecimalsE, target?.DecimalsF);
        _target = target;
        _rules = target?.Dialect ?? decoding.Dialect;
        _axis = target?.Axis ?? decoding.Axis;
        _extruder = _axis.FirstLetter;
        _in = new DecoderCore(decoding.Dialect, decoding.Rule, decoding.Axis);
        _now = new DecoderCore(_rules, decoding.Rule, _axis);
        _rewriter = new LineRewriter(_style, _rules, _axis, decoding.Axis);
        _text = new SplicedText(stream, _style);
        _tolerance = 0.5001 * NumberFormatter.FromUnits(1, _style.DecimalsXyz);
        _toleranceE = target is null ? NoChange : 0.5001 * NumberFormatter.FromUnits(1, _style.DecimalsE);
    }

    /// <summary>Lines of motion are written anew, also where they could stay.</summary>
    public bool Anew { get; init; }

    public DiagnosticList Diagnostics { get; } = new();

    /// <summary>Writes the file with the moves of an edited toolpath.</summary>
    public void Run(Toolpath edited, SplicePlan plan, IProgress<double>? progress, CancellationToken cancel)
    {
        _cursor = new MoveCursor(edited);
        _plan = plan;
        var synced = true;
        for (var chunk = 0; chunk < _document.Chunks.Count; chunk++)
        {
            cancel.ThrowIfCancellationRequested();
            var piece = _document.Chunks[chunk];
            var lines = _decoding.Checkpoints[chunk].Line;
            if (synced && _target is null && !plan.IsDirty(chunk) && _text.IsPlain)
            {
                FlushComments(true);
                _text.Copy(piece.Text, piece.Start, piece.End);
            }
            else
            {
                var next = chunk + 1 < _document.Chunks.Count ? _decoding.Checkpoints[chunk + 1].Line : int.MaxValue;
                _cursor.SkipTo(lines + 1);
                _read = _decoding.Checkpoints[chunk].Events;
                if (synced)
                {
                    _in.Restore(_decoding.Checkpoints[chunk].State);
                    if (_target is null || chunk == 0) _now.Restore(_decoding.Checkpoints[chunk].State);
                }
                Lines(piece, lines, chunk == 0);
                synced = _target is null && next != int.MaxValue && InStep(next);
            }
            progress?.Report((chunk + 1.0) / _document.Chunks.Count);
        }
        FlushComments(true);
        End();
        foreach (var line in _end) Command(line);
        _text.Flush();
    }

    private bool InStep(int line)
    {
        var matters = !(_in.IsRelativeE && _now.IsRelativeE && line > _decoding.LastModeLine);
        return _in.Save().ReadsAlike(_now.Save(), matters);
    }

    private void Lines(GCodeChunk chunk, int before, bool first)
    {
        var text = chunk.Text;
        var at = chunk.Start;
        if (first)
        {
            var mark = TextEncoding.MarkLength(chunk);
            _text.Copy(text, at, at + mark);
            at += mark;
        }
        for (_number = before + 1; at < chunk.End; _number++)
        {
            var end = LineEnds.Find(text, at, chunk.End);
            var next = LineEnds.Skip(text, end, chunk.End);
            Line(text, at, end, next);
            at = next;
        }
    }

    private void Line(byte[] text, int start, int end, int next)
    {
        if (_number == _firstKept) Begin();
        _line.Scan(text, start, end);
        var moves = _in.ReadLine(_line, text, end, out var commands);
        var events = _in.LastEvents.Count;
        if (_number < _firstKept || _number > _lastKept)
        {
            _cursor.SkipTo(_number + 1);
            _read += events;
            return;
        }
        if (moves == 0 && commands == 0)
        {
            if (_line.Shape == LineShape.Blank)
            {
                _comments.Add(new CommentLine(text, start, end, next));
                return;
            }
            FlushComments(true);
            if (events > 0) TakeBeforeEvents(events);
            _read += events;
            Other(text, start, end, next);
            return;
        }
        Take(moves);
        if (moves > 0 && _own == 0 && !IsHome())
        {
            _read += events;
            FlushComments(false);
            Removed();
            return;
        }
        RestoreComments();
        FlushComments(true);
        if (_own == 0 && events > 0) TakeBeforeEvents(events);
        _read += events;
        // One move of its own is always the last task.
        var single = _own == 1;
        Put(single ? _tasks.Count - 1 : _tasks.Count);
        if (commands == 0) Other(text, start, end, next);
        else if (single) One(text, start, end, next, _tasks[_tasks.Count - 1].Wanted);
        else if (_own == 0) NoMove(text, start, end, next);
    }
}
