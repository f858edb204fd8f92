using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Parameters;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Base;

/// <summary>One item of a solve: its inputs, its outputs and its messages.</summary>
internal sealed class Run(CaterpillarComponent component, IGH_DataAccess access, SolveCache cache, Background background)
{
    private readonly List<Action<IGH_DataAccess>> _given = [];
    private readonly Dictionary<int, List<IGH_Goo?>> _lists = [];
    private DocumentUnits? _units;

    /// <summary>What the item gives, in order.</summary>
    public IReadOnlyList<Action<IGH_DataAccess>> Given => _given;

    /// <summary>Number of the item in this solution, from 0.</summary>
    public int Iteration => access.Iteration;

    public GH_Document? Document => component.OnPingDocument();

    /// <summary>Conversion between document units and mm. Reports once if they differ.</summary>
    public DocumentUnits Units
    {
        get
        {
            if (_units is { } known) return known;
            var units = DocumentUnits.Current;
            if (!units.AreMillimeters)
                component.AddRuntimeMessage(GH_RuntimeMessageLevel.Remark, $"Geometry is scaled: the document is in {units.Name}, Caterpillar works in mm.");
            _units = units;
            return units;
        }
    }

    /// <summary>
    /// Checks that every connected port that could do without gets something: what failed upstream must not turn into a default. Required items are checked
    /// where they are read. Of a required list some may be null, of an optional one none, as it would mean something else without them.
    /// </summary>
    /// <exception cref="InputProblem">A connected port gets nothing.</exception>
    public void CheckSources()
    {
        for (var i = 0; i < component.Params.Input.Count; i++)
        {
            var port = component.Params.Input[i];
            if (port.SourceCount > 0 && !Arrives(i, port.Access, component.IsRequired(i)))
                throw new InputProblem($"{port.Name}: nothing arrives from what is connected.");
        }
    }

    private bool Arrives(int input, GH_ParamAccess kind, bool required)
    {
        if (kind == GH_ParamAccess.list)
        {
            var goos = Goos(input);
            return goos.Count > 0 && (required ? !goos.TrueForAll(g => g is null) : !goos.Contains(null));
        }
        IGH_Goo? goo = null;
        return required || (access.GetData(input, ref goo) && goo is not null);
    }

    // A list is read once.
    private List<IGH_Goo?> Goos(int input)
    {
        if (_lists.TryGetValue(input, out var known)) return known;
        var goos = new List<IGH_Goo?>();
        access.GetDataList(input, goos!);
        return _lists[input] = goos;
    }

    /// <summary>A required item.</summary>
    /// <exception cref="InputProblem">It is null or missing.</exception>
    public T Get<T>(int input)
    {
        var value = default(T);
        return access.GetData(input, ref value) && value is not null
            ? value
            : throw new InputProblem($"{component.Params.Input[input].Name} is missing.") { IsMissing = true };
    }

    /// <summary>An item that may be absent.</summary>
    public T? Maybe<T>(int input)
        where T : class
    {
        var value = default(T);
        return access.GetData(input, ref value) ? value : null;
    }

    /// <inheritdoc cref="Maybe{T}(int)"/>
    public T? MaybeValue<T>(int input)
        where T : struct
    {
        var value = default(T);
        return access.GetData(input, ref value) ? value : null;
    }

    /// <summary>A list without its nulls, which are reported.</summary>
    public List<T> List<T>(int input)
        where T : class
    {
        var goos = Goos(input);
        var some = new List<T>(goos.Count);
        var lost = 0;
        foreach (var goo in goos)
        {
            if (goo is T item) some.Add(item);
            else if (goo is null) lost++;
            else return Converted<T>(input);
        }
        ReportNulls(input, lost);
        return some;
    }

    /// <summary>A list with its nulls, whose items stand beside those of another list.</summary>
    public IReadOnlyList<T?> WithNulls<T>(int input)
        where T : class
        => Goos(input).ConvertAll(goo => goo as T);

    /// <summary>The print paths of a list.</summary>
    public PathList Paths(int input)
    {
        var goos = List<PrintPathGoo>(input);
        return cache.Renew<PathList>([input, access.Iteration], last => last?.Has(goos) == true ? last : new PathList(goos));
    }

    /// <summary>The steps of a list.</summary>
    public StepList Steps(int input)
    {
        var goos = List<StepGoo>(input);
        return cache.Renew<StepList>([input, access.Iteration], last => last?.Has(goos) == true ? last : new StepList(goos));
    }

    // What Grasshopper makes of the goo.
    private List<T> Converted<T>(int input)
        where T : class
    {
        var all = new List<T?>();
        access.GetDataList(input, all!);
        var some = all.Where(item => item is not null).Select(item => item!).ToList();
        ReportNulls(input, all.Count - some.Count);
        return some;
    }

    private void ReportNulls(int input, int lost)
    {
        if (lost == 0) return;
        Report(GH_RuntimeMessageLevel.Warning,
            $"{component.Params.Input[input].Name} has {lost} null {(lost == 1 ? "item, which is" : "items, which are")} ignored.");
    }

    /// <summary>A number greater than zero.</summary>
    /// <exception cref="InputProblem">It is missing, not finite, or not greater than zero.</exception>
    public double Positive(int input)
    {
        var value = Finite(input);
        return value > 0 ? value : throw new InputProblem($"{component.Params.Input[input].Name} must be greater than zero, not "
            + $"{NumberFormatter.Format(value, 6)}.");
    }

    /// <summary>A finite number; from an angle port always in degrees.</summary>
    public double Finite(int input)
    {
        var value = Get<double>(input);
        if (component.Params.Input[input] is Param_Number { AngleParameter: true, UseDegrees: false }) value = Angle.ToDegrees(value);
        return !double.IsNaN(value) && !double.IsInfinity(value)
            ? value
            : throw new InputProblem($"{component.Params.Input[input].Name} must be a finite number.");
    }

    /// <summary>The value of a choice port.</summary>
    /// <exception cref="InputProblem">There is no such choice.</exception>
    public T Choice<T>(int input)
        where T : struct, Enum
        => ToChoice<T>(input, Get<int>(input));

    /// <summary>The values of a port for several choices; null for none, which means all.</summary>
    /// <inheritdoc cref="Choice" path="/exception"/>
    public IReadOnlyList<T>? Choices<T>(int input)
        where T : struct, Enum
    {
        var numbers = List<GH_Integer>(input);
        return numbers.Count == 0 ? null : numbers.Select(n => ToChoice<T>(input, n.Value)).ToArray();
    }

    /// <summary>The full path of a file: relative paths start at the folder of the definition, if it has been saved.</summary>
    public string PathTo(string file)
    {
        var folder = Document is { IsFilePathDefined: true } document ? Path.GetDirectoryName(document.FilePath) : null;
        return Path.GetFullPath(folder is not null && !Path.IsPathRooted(file) ? Path.Combine(folder, file) : file);
    }

    /// <summary>The value of a result after its diagnostics were shown and collected; null if it has none.</summary>
    public T? Accept<T>(Result<T> result, List<string>? texts = null)
        where T : class
    {
        var lines = Report(result.Diagnostics);
        texts?.AddRange(lines);
        return result.Value;
    }

    public void Set(int output, object? value) => _given.Add(a => a.SetData(output, value));

    public void SetList(int output, IEnumerable values)
    {
        // Lists that are made while they are read are made now, where a problem is one of this item.
        var list = values as ICollection ?? values.Cast<object?>().ToArray();
        _given.Add(a => a.SetDataList(output, list));
    }

    /// <summary>Gives a copy of a tree, which is kept: what Grasshopper does with it (reverse, graft) must not reach the next solve.</summary>
    public void SetTree<T>(int output, GH_Structure<T> tree)
        where T : IGH_Goo
        => _given.Add(a => a.SetDataTree(output, tree.ShallowDuplicate()));

    /// <summary>Shows something in the viewports, as long as the result of the item.</summary>
    public void Show(IDrawn drawn) => _given.Add(_ => component.Show(drawn));

    /// <summary>The path of this item's data in an output.</summary>
    public GH_Path PathOf(int output) => access.ParameterTargetPath(output);

    /// <summary>Null for every item output; lists and trees stay empty.</summary>
    public void SetNulls()
    {
        for (var i = 0; i < component.Params.Output.Count; i++)
        {
            if (component.Params.Output[i].Access == GH_ParamAccess.item) Set(i, null);
        }
    }

    /// <summary>Hands out what was set.</summary>
    public void Give()
    {
        foreach (var give in _given) give(access);
    }

    /// <summary>Hands out what was set as far as it is no item, which is null.</summary>
    public void GiveNulls()
    {
        SetNulls();
        Give();
    }

    /// <summary>Hands out nothing of what was set.</summary>
    public void GiveOnlyNulls()
    {
        _given.Clear();
        GiveNulls();
    }

    /// <summary>A value that is kept from the last solve if the parts of its key are the same.</summary>
    public T Cached<T>(object?[] key, Func<T> make)
        where T : class
        => cache.Get(key, _ => make());

    /// <summary>
    /// A value that may take long, kept like the others. It is made on another thread, which may neither ask this run nor report to it.
    /// </summary>
    /// <exception cref="OperationCanceledException">The user pressed Escape.</exception>
    public T Work<T>(string label, object?[] key, Func<IProgress<double>, CancellationToken, T> work)
        where T : class
        => cache.Get(key, k => background.Get(k, label, work));

    /// <summary>Work that has to be done before the solve ends, such as writing a file.</summary>
    /// <inheritdoc cref="Work" path="/exception"/>
    public T Wait<T>(string label, Func<IProgress<double>, CancellationToken, T> work)
        where T : class
        => LongWork.Run(label, work);

    /// <summary>True if all inputs are up to date; false, with a warning, while something before this component is at work or was canceled.</summary>
    public bool MayAct()
    {
        if (component.Pending is not { } name) return true;
        component.AddRuntimeMessage(GH_RuntimeMessageLevel.Warning, $"Nothing was done: the result of {name} is not up to date. Press again when it is.");
        return false;
    }

    /// <summary>A short message below the component.</summary>
    public void Summarize(string text) => component.Message = text;

    /// <summary>Messages for diagnostics, and their texts for the output of that name.</summary>
    public IReadOnlyList<string> Report(IEnumerable<Diagnostic> diagnostics)
    {
        var texts = new List<string>();
        foreach (var diagnostic in diagnostics)
        {
            var text = diagnostic.ToString();
            texts.Add(text);
            Report(Level(diagnostic.Severity), text);
        }
        return texts;
    }

    /// <summary>A message that names the branch and the item.</summary>
    public void Report(GH_RuntimeMessageLevel level, string message) => component.AddRuntimeMessage(level, $"{Place()}: {message}");

    private static GH_RuntimeMessageLevel Level(Severity severity) => severity switch
    {
        Severity.Error => GH_RuntimeMessageLevel.Error,
        Severity.Warning => GH_RuntimeMessageLevel.Warning,
        _ => GH_RuntimeMessageLevel.Remark,
    };

    private T ToChoice<T>(int input, int number)
        where T : struct, Enum
    {
        foreach (T value in Enum.GetValues(typeof(T)))
        {
            if (Convert.ToInt32(value, System.Globalization.CultureInfo.InvariantCulture) == number) return value;
        }
        throw new InputProblem($"{component.Params.Input[input].Name} has no choice {NumberFormatter.Format(number)}; there are "
            + $"{string.Join(", ", Enum.GetNames(typeof(T)))}.");
    }

    // The path of an item output is the branch of the inputs; a list output of an item appends the index of the item.
    private string Place()
    {
        if (component.Params.Output.Count == 0) return "Item " + NumberFormatter.Format(access.Iteration);
        var items = component.Params.Input.Any(p => p.Access == GH_ParamAccess.item);
        var output = component.Params.Output.FindIndex(p => p.Access == GH_ParamAccess.item);
        if (output >= 0) return $"{access.ParameterTargetPath(output)}[{NumberFormatter.Format(access.ParameterTargetIndex(output))}]";
        var path = access.ParameterTargetPath(0);
        return items && path.Length > 1 ? $"{path.CullElement()}[{NumberFormatter.Format(path.Indices[path.Length - 1])}]" : path.ToString();
    }
}
