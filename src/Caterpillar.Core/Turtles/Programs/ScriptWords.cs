namespace Caterpillar.Turtles;

/// <summary>The L-system words that a program draws, letter by letter. A letter may draw another word.</summary>
internal sealed class ScriptWords(ScriptCode code, FormulaContext context)
{
    private readonly List<Letters> _words = [];
    private LSystemInterpretation? _standard;
    private double _step;
    private double _angle;

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

    /// <summary>The commands of letters without a procedure, for the current step and angle of the script.</summary>
    public LSystemInterpretation Standard()
    {
        var (step, angle) = (Global(code.StepSlot, 1), Global(code.AngleSlot, 90));
        if (_standard is null || step != _step || angle != _angle) _standard = LSystemInterpretation.Standard(step, angle);
        (_step, _angle) = (step, angle);
        return _standard;
    }

    private double Global(int slot, double missing) => slot < 0 || double.IsNaN(context.Values[slot]) ? missing : context.Values[slot];

    private sealed class Letters(LSystemWord word)
    {
        public LSystemWord Word { get; } = word;

        public int At { get; set; }
    }
}
