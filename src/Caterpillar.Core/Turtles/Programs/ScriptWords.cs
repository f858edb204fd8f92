namespace Caterpillar.Turtles;

/// <summary>The L-system words that a program draws, letter by letter. A letter may draw another word.</summary>
internal sealed class ScriptWords(ScriptCode code, FormulaContext context)
{
    private readonly List<Letters> _words = [];

    /// <summary>Words that are being drawn.</summary>
    public int Count => _words.Count;

    public void Begin(LSystemWord word) => _words.Add(new Letters(word));

    /// <summary>Ends all words but the first ones.</summary>
    public void CutTo(int count) => _words.RemoveRange(count, _words.Count - count);

    /// <summary>The word on top and its next letter. False at its end.</summary>
    public bool Next(out LSystemWord word, out int index)
    {
        var letters = _words[_words.Count - 1];
        (word, index) = (letters.Word, letters.At++);
        if (index < word.Count) return true;
        _words.RemoveAt(_words.Count - 1);
        return false;
    }

    /// <summary>Draws a letter without a procedure with the step and angle that the script has now.</summary>
    public void Draw(Turtle turtle, LSystemWord word, int index) => word.Apply(turtle, index, Global(code.StepSlot, 1), Global(code.AngleSlot, 90));

    private double Global(int slot, double missing) => slot < 0 || double.IsNaN(context.Values[slot]) ? missing : context.Values[slot];

    private sealed class Letters(LSystemWord word)
    {
        public LSystemWord Word { get; } = word;

        public int At { get; set; }
    }
}
