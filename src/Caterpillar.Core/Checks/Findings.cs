using System;
using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>What checks find along a toolpath: for each kind the first place and a count. Messages are made for the first finding only.</summary>
internal sealed class Findings(Toolpath toolpath)
{
    private readonly DiagnosticList _list = new();

    public void Add(Severity severity, string code, int move, Func<string> message)
    {
        if (!_list.Contains(code, severity)) _list.Add(severity, code, message(), Place(move));
        else _list.Add(severity, code, "");
    }

    public IReadOnlyList<Diagnostic> ToList() => _list.ToList();

    private SourceLocation? Place(int move)
    {
        // Before the first move and after the last there is none to name.
        if (move < 0 || move >= toolpath.Count) return null;
        var source = toolpath[move].Source;
        return toolpath.Source == MoveSource.Lines
            ? new SourceLocation(Line: source > 0 ? source : null, Move: move)
            : new SourceLocation(Step: source >= 0 ? source : null, Move: move);
    }
}
