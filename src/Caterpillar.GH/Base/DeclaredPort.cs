namespace Caterpillar.GH.Base;

/// <summary>An input as a component declares it.</summary>
/// <param name="Param">The parameter with its texts. It is the port itself, unless the port was read from a file.</param>
/// <param name="IsRequired">True without a default if it is not optional.</param>
/// <param name="Default">The value of an item port that is not connected.</param>
/// <param name="Conditions">Choices for which the port is shown: all must hold. None = always.</param>
internal sealed record DeclaredPort(IGH_Param Param, bool IsRequired, object? Default, IReadOnlyList<PortCondition> Conditions);

/// <summary>A choice port that must have one of some values.</summary>
internal sealed record PortCondition(string Port, IReadOnlyCollection<int> Values);
