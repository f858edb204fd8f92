using System;
using System.Collections.Generic;

namespace Caterpillar.CanvasPictures;

/// <summary>How a wire is drawn: single, double or dashed, as data is an item, a list or a tree.</summary>
internal enum Flow
{
    Item,
    List,
    Tree,
}

/// <summary>What a solved definition shows: lines in panels by id, flows by the id of the output, and the ids of objects with a warning or an error.</summary>
internal sealed record Results(IReadOnlyDictionary<Guid, IReadOnlyList<string>> Panels, IReadOnlyDictionary<Guid, Flow> Flows, ICollection<Guid> Warned,
    ICollection<Guid> Failed)
{
    public static Results None { get; } = new(new Dictionary<Guid, IReadOnlyList<string>>(), new Dictionary<Guid, Flow>(), [], []);
}
