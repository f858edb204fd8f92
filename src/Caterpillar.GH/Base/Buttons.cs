namespace Caterpillar.GH.Base;

/// <summary>
/// A Boolean input as one button for each item, pressed in the solution in which it changes from false to true. It must have been false before: a
/// definition that was saved with a toggle at true does nothing when it opens.
/// </summary>
internal sealed class Buttons(int input)
{
    private readonly Dictionary<int, bool> _down = [];

    /// <summary>
    /// True if the button of the item is pressed now and all inputs are up to date. A press counts for this solution only, even if other inputs are bad.
    /// </summary>
    public bool IsPressed(Run run)
    {
        var down = run.MaybeValue<bool>(input) ?? true;
        var pressed = down && _down.TryGetValue(run.Iteration, out var before) && !before;
        _down[run.Iteration] = down;
        return pressed && run.MayAct();
    }
}
