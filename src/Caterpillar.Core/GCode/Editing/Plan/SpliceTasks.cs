namespace Caterpillar.GCode;

/// <summary>
/// Assigns tasks to each line of the file: its own moves, and moves and events to insert before them. It reads the edited toolpath in step with the lines.
/// </summary>
internal sealed class SpliceTasks(SpliceContext context, SplicePlan plan, MoveCursor moves)
{
    private readonly List<SpliceTask> _tasks = [];
    private int _nextEvent;

    // The move before which the next event happens.
    private int _eventMove = EventMove(plan, 0);

    /// <summary>The tasks in order. A single own move of the line is the last.</summary>
    public IReadOnlyList<SpliceTask> Tasks => _tasks;

    /// <summary>The number of tasks that are moves of the line's own.</summary>
    public int OwnMoves { get; private set; }

    /// <summary>Continues with other moves of the edited toolpath.</summary>
    public void Continue(Toolpath edited) => moves = new MoveCursor(edited);

    /// <summary>Skips to the first move of a line or of the lines after it.</summary>
    public void SkipTo(int line) => moves.SkipTo(line);

    public void Clear()
    {
        _tasks.Clear();
        OwnMoves = 0;
    }

    /// <summary>The tasks of the current line, which made this many moves in the file.</summary>
    public void Take(int made)
    {
        Clear();
        if (context.Target is not null)
        {
            var read = context.Read;
            for (var i = 0; i < made; i++)
                AddOwn(new TargetMove(read.LastMoves, i) with { Arc = made == 1 ? read.LastArc : null, Turns = read.State.Rotary.Machine });
            return;
        }
        // Moves whose line made none here would hold up all others.
        while (moves.Valid && moves.Source < context.Number && moves.LeadsTo() < context.Number) moves.Next();
        while (moves.Valid && moves.LeadsTo() == context.Number)
        {
            AddEventsBefore(moves.Number);
            if (moves.Source < 0) _tasks.Add(new SpliceTask(null, moves.Move()));
            else AddOwn(moves.Move());
            moves.Next();
        }
    }

    /// <summary>True if a line has one own move, and nothing is inserted before or after it. Does not take it yet.</summary>
    public bool HasSingleMove(int line, out ToolpathColumns columns, out int index)
    {
        columns = null!;
        index = 0;
        if (!moves.Valid || moves.Source != line || _eventMove <= moves.Number) return false;
        columns = moves.Columns;
        index = moves.Index;
        return index + 1 < columns.Count && columns.Source[index + 1] > line;
    }

    /// <summary>Takes the move of <see cref="HasSingleMove"/>.</summary>
    public void TakeSingleMove() => moves.Next();

    /// <summary>Takes the insertions before the events of the current line.</summary>
    public void TakeBeforeEvents()
    {
        Clear();
        if (context.Target is not null) return;
        for (var index = _nextEvent; index < plan.Events.Count && plan.Events[index].Source <= context.Number; index++)
        {
            if (plan.Events[index].Source < context.Number) continue;
            for (; moves.Valid && moves.Source < 0 && moves.Number < plan.Events[index].Move; moves.Next())
            {
                AddEventsBefore(moves.Number);
                _tasks.Add(new SpliceTask(null, moves.Move()));
            }
            while (_nextEvent < index) AddNextEvent();
        }
    }

    /// <summary>Takes the insertions after the last line.</summary>
    public void TakeRest()
    {
        Clear();
        for (; context.Target is null && moves.Valid; moves.Next())
        {
            AddEventsBefore(moves.Number);
            if (moves.Source < 0) _tasks.Add(new SpliceTask(null, moves.Move()));
        }
        AddEventsBefore(int.MaxValue);
    }

    private void AddOwn(TargetMove move)
    {
        OwnMoves++;
        _tasks.Add(new SpliceTask(null, move));
    }

    private void AddEventsBefore(int move)
    {
        while (_nextEvent < plan.Events.Count && plan.Events[_nextEvent].Move <= move) AddNextEvent();
    }

    private void AddNextEvent()
    {
        if (plan.Events[_nextEvent].Source < 0) _tasks.Add(new SpliceTask(plan.Events[_nextEvent].Event, default));
        _eventMove = EventMove(plan, ++_nextEvent);
    }

    private static int EventMove(SplicePlan plan, int index) => index < plan.Events.Count ? plan.Events[index].Move : int.MaxValue;
}

/// <summary>A task of a line: an event or a move.</summary>
internal readonly record struct SpliceTask(PrinterEvent? Event, TargetMove Move);
