using System.Linq;
using Caterpillar.GH.Base;
using Caterpillar.GH.Params;

namespace Caterpillar.GH.Tests.Host;

/// <summary>Ports that follow choices, without a solution.</summary>
internal static class Chosen
{
    /// <summary>Shows the ports for what is connected to the choices of a component.</summary>
    public static void Follow(ChosenPortsComponent component)
    {
        do
        {
            foreach (var choice in component.Params.Input.OfType<ChoiceParam>())
            {
                choice.ClearData();
                choice.CollectData();
            }
        }
        while (component.Arrange());
        component.ExpireSolution(false);
    }
}
